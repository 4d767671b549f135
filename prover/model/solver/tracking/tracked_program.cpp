#include "prover/model/solver/tracking/tracked_program.h"

namespace plprove::model {

std::size_t workspace_size(const TrackedProgram& program) {
    const int points = 9; // three with their speeds, and what a step needs
    return static_cast<std::size_t>(points * program.unknowns + program.places);
}

TrackFunction* fastest_tracker() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f")) return avx512::track;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2::track;
#endif
    return portable::track;
}

} // namespace plprove::model
