#include "prover/three_views/tracking/tracker.h"

namespace plprove {

namespace {

struct Trackers {
    TrackFunction *doubles, *double_double, *triple_double;
    RefinedValuesFunction* refined_values;
};

Trackers fastest() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f"))
        return {avx512::track, avx512::track_double_double, avx512::track_triple_double,
                avx512::refined_values};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return {avx2::track, avx2::track_double_double, avx2::track_triple_double,
                avx2::refined_values};
#endif
    return {portable::track, portable::track_double_double, portable::track_triple_double,
            portable::refined_values};
}

} // namespace

TrackFunction* fastest_tracker() {
    return fastest().doubles;
}

TrackFunction* fastest_double_double_tracker() {
    return fastest().double_double;
}

TrackFunction* fastest_triple_double_tracker() {
    return fastest().triple_double;
}

RefinedValuesFunction* fastest_refined_values() {
    return fastest().refined_values;
}

} // namespace plprove
