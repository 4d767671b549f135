#include "prover/degree/tracking/tracker.h"

namespace plprove {

namespace {

struct Trackers {
    TrackFunction *doubles, *wide, *triple;
    TraceFunction* trace;
};

Trackers fastest() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f"))
        return {avx512::track, avx512::track_wide, avx512::track_triple, avx512::trace_terms};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return {avx2::track, avx2::track_wide, avx2::track_triple, avx2::trace_terms};
#endif
    return {portable::track, portable::track_wide, portable::track_triple, portable::trace_terms};
}

} // namespace

TrackFunction* fastest_tracker() {
    return fastest().doubles;
}

TrackFunction* fastest_wide_tracker() {
    return fastest().wide;
}

TrackFunction* fastest_triple_tracker() {
    return fastest().triple;
}

TraceFunction* fastest_trace() {
    return fastest().trace;
}

} // namespace plprove
