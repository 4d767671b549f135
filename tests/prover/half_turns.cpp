// The theorem on half-turns (proofs/half_turns.md) and the groups on file.
#include "checker/permutations/half_turns.h"
#include "prover/catalogue/groups.h"
#include "prover/minimal/families.h"
#include "prover/problem/signature.h"

#include <algorithm>
#include <bit>
#include <doctest/doctest.h>
#include <set>

using namespace plprove;

namespace {

/// Of a feature that is not the point with all else: whether the view sees it in one of the ways
/// (a) and (b) of the theorem.
bool is_little(const Feature& feature, std::size_t view) {
    const auto& [point, pins] = feature.sights[view];
    if (point) return pins == 0;
    if (!feature.has_point || std::popcount(pins) != 1) return false;
    int others = 0;
    for (std::size_t other = 0; other < 3; ++other)
        others += other != view && (feature.sights[other].pins & pins) != 0;
    return others == 1;
}

/// Whether the view sees the point of this feature, lines through it, and one thing besides.
bool has_half_turn(const Features& problem, std::size_t star, std::size_t view) {
    if (!problem[star].sights[view].point) return false;
    int things = 0;
    for (std::size_t i = 0; i < problem.size(); ++i) {
        const auto& [point, pins] = problem[i].sights[view];
        if (i == star || (!point && pins == 0)) continue;
        if (!is_little(problem[i], view)) return false;
        ++things;
    }
    return things == 1;
}

bool has_half_turn(const Features& problem) {
    for (std::size_t star = 0; star < problem.size(); ++star)
        for (std::size_t view = 0; view < 3; ++view)
            if (has_half_turn(problem, star, view)) return true;
    return false;
}

checker::Signature for_checker(const Signature& signature) {
    checker::Signature result{};
    std::ranges::copy(signature, result.begin());
    return result;
}

struct Expected {
    std::set<std::size_t> with_half_turn; ///< constraint classes
    std::set<std::size_t> with_five_points;
    int label_classes = 0; ///< that have a half-turn
};

Expected expected() {
    Expected result;
    const std::vector<Signature>& classes = label_classes();
    for (const Signature& signature : classes) {
        const Features problem = problem_of(signature);
        const bool of_checker =
            checker::views_beside_half_turns(for_checker(signature)).has_value();
        CHECK(of_checker == has_half_turn(problem));
        if (obstruction(problem).deficiency() > 0) continue;
        const bool five_points = families_of(signature, true).five_point_extension;
        if (!five_points && !has_half_turn(problem)) continue;
        const std::size_t number = class_number(classes, constraint_representative(signature));
        if (five_points) result.with_five_points.insert(number);
        if (!has_half_turn(problem)) continue;
        result.with_half_turn.insert(number);
        ++result.label_classes;
    }
    return result;
}

} // namespace

TEST_CASE("solutions stay together in blocks where five points, six lines or a half-turn say so") {
    const auto [with_half_turn, with_five_points, label_classes] = expected();
    CHECK(label_classes == 28);
    CHECK(with_half_turn.size() == 24);
    CHECK(with_five_points.size() == 938);
    for (const auto& [constraint_class, group] : groups_on_file()) {
        CAPTURE(constraint_class);
        const bool decomposes = group.name.find(" wr ") != std::string_view::npos;
        const bool has_six_lines = group.width == 3;
        CHECK(decomposes == (with_half_turn.contains(constraint_class) ||
                             with_five_points.contains(constraint_class) || has_six_lines));
        if (!with_half_turn.contains(constraint_class)) continue;
        const bool has_pairs = group.name.starts_with("S2 wr") || group.name.starts_with("<S2 wr");
        CHECK(has_pairs);
    }
}
