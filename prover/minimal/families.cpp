#include "prover/minimal/families.h"

#include "prover/problem/complete_visibility.h"

#include <algorithm>

namespace plprove {

namespace {

using View = int;

bool sees_a_line(const Feature& feature, View view) {
    return feature.sights[static_cast<std::size_t>(view)].pins != 0;
}

/// Whether the two views see the same lines, and every point that only one of them sees has a pin
/// that the other sees: with their relative pose, everything they see is known in space.
bool fixes_what_it_sees(const Features& problem, View first, View second) {
    return std::ranges::all_of(problem, [&](const Feature& feature) {
        if (feature.sights[static_cast<std::size_t>(first)].pins !=
            feature.sights[static_cast<std::size_t>(second)].pins)
            return false;
        if (feature.sees_point(first) == feature.sees_point(second)) return true;
        return sees_a_line(feature, feature.sees_point(first) ? second : first);
    });
}

/// Whether the problem, or one that differs from it by swaps, consists of PPP, LLL, PLL, PPL and
/// PLP correspondences with respect to view 1.
bool linear_in_first_view(const Signature& signature) {
    // P/P/P, a/a/a, P/a/a, and the swap pairs whose terminal features are P/a/P and P/P/a.
    constexpr std::array<std::size_t, 7> allowed{7, 11, 14, 15, 16, 17, 21};
    for (std::size_t i = 0; i < feature_count; ++i)
        if (signature[i] > 0 && std::ranges::find(allowed, i) == allowed.end()) return false;
    return true;
}

/// The name in Table 1 of PLMP, if all views see everything.
std::optional<std::string> plmp_name(const Features& problem) {
    for (const Feature& feature : problem) {
        const Sight all{feature.has_point, (1U << feature.lines) - 1};
        if (std::ranges::any_of(feature.sights, [&](const Sight& sight) { return sight != all; }))
            return std::nullopt;
    }
    return name(problem_of(problem));
}

} // namespace

Families families(const Signature& signature) {
    const Features problem = problem_of(signature);
    Families result;
    result.pl0p = std::ranges::all_of(
        problem, [](const Feature& feature) { return !feature.has_point || feature.lines == 0; });
    result.at_most_one_pin = std::ranges::all_of(
        problem, [](const Feature& feature) { return !feature.has_point || feature.lines <= 1; });
    const std::array<int, 3> shared = shared_points(problem);
    for (std::size_t pair = 0; pair < view_pairs.size(); ++pair)
        if (shared[pair] == 5) {
            result.five_point_extension = true;
            result.registration =
                result.registration ||
                fixes_what_it_sees(problem, view_pairs[pair][0], view_pairs[pair][1]);
        }
    result.trifocal_linear = std::ranges::any_of(relabelings(signature), linear_in_first_view);
    result.plmp = plmp_name(problem);
    return result;
}

Families families_of(const Signature& signature, bool minimal) {
    Families result = families(signature);
    if (minimal) return result;
    result.five_point_extension = result.registration = result.trifocal_linear = false;
    result.plmp.reset();
    return result;
}

} // namespace plprove
