#include "prover/three_views/tracking/tracker.h"

namespace plprove {

namespace {

struct Trackers {
    TrackFunction *doubles, *double_double, *triple_double;
    RefinedValuesFunction* refined_values;
    TrackEachFunction* each;
};

Trackers fastest() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f"))
        return {avx512::track, avx512::track_double_double, avx512::track_triple_double,
                avx512::refined_values, avx512::track_each};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return {avx2::track, avx2::track_double_double, avx2::track_triple_double,
                avx2::refined_values, avx2::track_each};
#endif
    return {portable::track, portable::track_double_double, portable::track_triple_double,
            portable::refined_values, portable::track_each};
}

} // namespace

TrackFunction* fastest_tracker() {
    return fastest().doubles;
}

TrackEachFunction* fastest_tracker_of_each() {
    return fastest().each;
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
