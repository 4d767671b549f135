#include "prover/minimal/obstruction.h"

#include <algorithm>

namespace plprove {

namespace {

int star_obstruction(const Features& problem) {
    const auto star = std::ranges::max_element(
        problem, {}, [](const Feature& feature) { return feature.has_point ? feature.lines : 0; });
    if (star == problem.end() || !star->has_point || star->lines < 3) return 0;
    if (star->lines >= 8) return 2;
    const bool free_line =
        std::ranges::any_of(problem, [](const Feature& feature) { return !feature.has_point; });
    if (star->lines == 7 || (star->lines == 6 && free_line)) return 1;
    for (std::size_t view = 0; view < star->sights.size(); ++view) {
        // Only the star itself is seen: camera `view` can slide along its ray to the star.
        const auto seen = std::ranges::count_if(
            problem, [&](const Feature& feature) { return feature.sights[view] != Sight{}; });
        if (seen == 1) return 1;
    }
    return 0;
}

} // namespace

int Obstruction::deficiency() const {
    return std::max(excess[0] + excess[1] + excess[2], star);
}

std::array<int, 3> shared_points(const Features& problem) {
    std::array<int, 3> shared{};
    for (const Feature& feature : problem)
        for (std::size_t pair = 0; pair < view_pairs.size(); ++pair) {
            const auto [first, second] = view_pairs[pair];
            shared[pair] +=
                second < feature.views() && feature.sees_point(first) && feature.sees_point(second);
        }
    return shared;
}

Obstruction obstruction(const Features& problem) {
    Obstruction result;
    const std::array<int, 3> shared = shared_points(problem);
    std::ranges::transform(shared, result.excess.begin(), [](int m) { return std::max(0, m - 5); });
    result.star = star_obstruction(problem);
    return result;
}

} // namespace plprove
