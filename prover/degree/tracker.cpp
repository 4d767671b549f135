#include "prover/degree/tracker.h"

namespace plprove {

namespace {

struct Trackers {
    TrackFunction *doubles, *wide;
};

Trackers fastest() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f")) return {avx512::track, avx512::track_wide};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return {avx2::track, avx2::track_wide};
#endif
    return {portable::track, portable::track_wide};
}

} // namespace

TrackFunction* fastest_tracker() {
    return fastest().doubles;
}

TrackFunction* fastest_wide_tracker() {
    return fastest().wide;
}

} // namespace plprove
