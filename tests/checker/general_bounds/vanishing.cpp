// A wrong condition on forms is noticed: base scenes that Lemmas F3 to F5 do not know, or to a
// higher order.
#include "checker/general_bounds/vanishing.h"

#include "tests/checker/general_bounds/projective_problems.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

/// A problem with images, and its base scenes, which a test may change.
struct Attempt {
    Problem problem;
    SceneSystem system = scene_system(problem, random_views(problem, 4, 1));
    BaseScenes base = base_scenes(problem, system);

    /// Why the lemmas are refused; empty if they hold.
    std::string refusal() const {
        std::vector<Resection> resections;
        for (std::size_t camera = 0; camera < system.cameras; ++camera)
            resections.emplace_back(system, camera);
        try {
            try_lemmas(problem, system, base, SceneCoordinates(system, base.few_depths),
                       resections);
        } catch (const Refused& refused) {
            return refused.reason;
        }
        return {};
    }
};

Attempt attempt(const std::string& notation) {
    return {.problem = problem_of(notation)};
}

const std::string noticed = "forms do not vanish as Lemmas F3 to F5 say: report this";

} // namespace

TEST_CASE("the lemmas hold for all projective problems") {
    for (const auto& [notation, degree] : projective_degrees()) {
        CAPTURE(notation);
        const Problem problem = problem_of(notation);
        if (problem.points.size() == 7) continue; // on two lines or more: too few equations
        CHECK(Attempt{.problem = problem}.refusal().empty());
    }
}

TEST_CASE("each order that is too high is noticed") {
    for (const auto& [notation, degree] : projective_degrees()) {
        CAPTURE(notation);
        const Problem problem = problem_of(notation);
        if (problem.points.size() == 7) continue;
        Attempt wrong{.problem = problem};
        // Of one depth alone, all forms vanish to order 2: some camera [0 | t] is left free.
        for (FewDepths& few : wrong.base.few_depths) {
            if (few.order == 2 || few.depths.size() == 1) continue;
            few.order = 2;
            CHECK(wrong.refusal() == noticed);
            few.order = 1;
        }
    }
}

TEST_CASE("few depths that are one too many are noticed") {
    Attempt wrong = attempt("projective: 6*P/P/P");
    wrong.base.few_depths[0].depths.push_back(1);
    CHECK(wrong.refusal() == noticed);
}

TEST_CASE("a pencil that asks less of the scene is noticed") {
    const auto has_one_point = [](const Line& line) { return line.points.size() == 1; };
    std::size_t pencils = 0;
    for (const auto& [notation, degree] : projective_degrees()) {
        CAPTURE(notation);
        const Problem problem = problem_of(notation);
        // Where lines have one point, cameras of rank 1 may see what those of rank 2 do not.
        if (std::ranges::any_of(problem.lines, has_one_point)) continue;
        if (problem.points.size() == 7) continue;
        Attempt wrong{.problem = problem};
        for (Pencil& pencil : wrong.base.pencils) {
            if (pencil.lines.empty()) continue;
            const std::size_t line = pencil.lines.back();
            pencil.lines.pop_back();
            CHECK(wrong.refusal() == noticed);
            pencil.lines.push_back(line);
            ++pencils;
        }
    }
    CHECK(pencils > 10);
}

TEST_CASE("a tangent at a point with three lines is noticed") {
    Attempt wrong =
        attempt("projective: PLa/PLa/PLa + PLabc/PLabc/PLabc + PLabcdef/PLabcdef/PLabcdef");
    REQUIRE(wrong.base.tangents.size() == 1);
    CHECK(wrong.refusal().empty());
    wrong.base.tangents[0].point = 2;
    CHECK(wrong.refusal() == noticed);
}
