// join_ranks() where CMake found no MPI.
#include "prover/system/exit.h"
#include "prover/system/ranks.h"

#include <string>

namespace plprove {

Ranks join_ranks() {
    const int count = ranks_started();
    if (count == 1) return {};
    leave_words_to_rank_0(exit_input);
    throw BadInput("this plprove was built without MPI, and " + std::to_string(count) +
                   " were started together: install Open MPI and build plprove again, or start it "
                   "without mpirun");
}

} // namespace plprove
