#include "prover/many_views/tracking/tracked_way.h"

namespace plprove::many_views {

int rows_size(const TrackedWay& way) {
    int size = 0;
    for (int v = 0; v < way.cameras; ++v)
        size += way.camera[v].equations * (way.camera[v].coordinates + way.common() + 2);
    return size;
}

std::size_t workspace_size(const TrackedWay& way) {
    const int common_rows = way.common() * (way.common() + 2);
    const int points = 10; // three with their speeds, and what a step needs
    const int numbers_of_place = 8;
    return static_cast<std::size_t>(points * way.unknowns + numbers_of_place * way.places +
                                    way.entries + rows_size(way) + common_rows);
}

namespace {

struct Trackers {
    TrackFunction *doubles, *double_double;
};

Trackers fastest() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f")) return {avx512::track, avx512::track_double_double};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return {avx2::track, avx2::track_double_double};
#endif
    return {portable::track, portable::track_double_double};
}

} // namespace

TrackFunction* fastest_tracker() {
    return fastest().doubles;
}

TrackFunction* fastest_double_double_tracker() {
    return fastest().double_double;
}

} // namespace plprove::many_views
