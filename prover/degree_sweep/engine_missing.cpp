// Stands in until the engine is there.
#include "prover/degree/degree.h"

#include <stdexcept>

namespace plprove {

int DegreeCertificate::degree() const {
    int degree = 0;
    for (const ApproximateSolution& solution : solutions)
        degree += solution.real ? 1 : 2;
    return degree;
}

DegreeRun compute_degree(std::size_t, const DegreeOptions&) {
    throw std::runtime_error("this build has no engine for degrees");
}

} // namespace plprove
