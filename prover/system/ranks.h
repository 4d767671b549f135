// The processes that mpirun or srun started together: MPI calls them ranks. A plprove that was
// started alone, or built without MPI, is the only rank.
#pragma once

#include <cstddef>
#include <functional>

namespace plprove {

/// One rank. Only the thread that joined may call the function.
struct Ranks {
    int number = 0; ///< of this rank: from 0 to count - 1
    int count = 1;

    /// Waits for all ranks. The sum of what they give.
    std::function<std::size_t(std::size_t)> sum = [](std::size_t alone) { return alone; };

    /// Rank 0 speaks, and collects.
    bool leads() const { return number == 0; }
};

/// How many ranks were started together, as the environment says; 1 outside mpirun and srun.
int ranks_started();

/// The number of this rank, as the environment says; 0 outside mpirun and srun.
int number_of_rank();

/// For what is wrong with all ranks alike, as with their command line: rank 0 says it. Any other
/// one ends here with this status, a second later: mpirun ends them all as soon as one has failed.
void leave_words_to_rank_0(int status);

/// Joins the ranks that were started together. MPI ends with the last copy of the result, and waits
/// there for all ranks, unless an exception ends this one: then mpirun ends the others. Throws
/// BadInput if there are several, and this plprove was built without MPI. A plprove that was
/// started alone does not start MPI.
Ranks join_ranks();

} // namespace plprove
