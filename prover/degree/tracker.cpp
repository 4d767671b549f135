#include "prover/degree/tracker.h"

#include "prover/degree/double_double.h"

namespace plprove {

namespace double_double {

#include "prover/degree/tracker_kernel.h"

} // namespace double_double

TrackCost track_double_double(const TrackedSystem& system, const TrackedImages& images,
                              const TrackSettings& settings, std::size_t count,
                              const CameraPoint* starts, CameraPoint* ends,
                              TrackOutcome* outcomes) {
    return double_double::Tracker(system, images, settings, count, starts, ends, outcomes).run();
}

TrackFunction* fastest_tracker() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f")) return avx512::track;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2::track;
#endif
    return portable::track;
}

} // namespace plprove
