// The cubic forms of an image vanish at solutions, and at base scenes to the order that
// proofs/fixed_forms.md says (Lemmas F3 and F4); tried with all problems and random images.
#include "checker/general_bounds/base_scenes.h"

#include "checker/general_bounds/resection.h"
#include "tests/checker/general_bounds/projective_problems.h"
#include "tests/checker/general_degrees/known_scene.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

bool all_zero(const SmallRow& numbers) {
    return std::ranges::all_of(numbers, [](Small x) { return x == Small{}; });
}

/// To which order at least, at most 2, all cubic forms vanish at these own depths on the line in
/// some direction: by their values there, which are polynomials of degree 3.
std::size_t order_in(const SceneSystem& system, const Resection& resection, const SmallRow& own,
                     const SmallRow& direction) {
    std::vector<SmallRow> values;
    for (const std::uint32_t step : {0U, 1U, 2U, 3U}) {
        SmallRow moved = own;
        for (std::size_t i = 0; i < own.size(); ++i)
            moved[i] = moved[i] + Small{step} * direction[i];
        values.push_back(resection.cubics(place_depths(system, moved)));
    }
    if (!all_zero(values[0])) return 0;
    SmallRow derivatives; // six times: -11 f(0) + 18 f(1) - 9 f(2) + 2 f(3)
    for (std::size_t i = 0; i < values[0].size(); ++i)
        derivatives.push_back(Small{18} * values[1][i] - Small{9} * values[2][i] +
                              Small{2} * values[3][i]);
    return all_zero(derivatives) ? 2 : 1;
}

/// The same in an arbitrary direction.
std::size_t order_at(const SceneSystem& system, const Resection& resection, const SmallRow& own,
                     Choices& choices) {
    return order_in(system, resection, own, choices.row(own.size()));
}

/// Why this is refused; empty if it is not.
std::string refusal(const auto& attempt) {
    try {
        attempt();
    } catch (const Refused& refused) {
        return refused.reason;
    }
    return {};
}

} // namespace

TEST_CASE("the cubic forms of all views vanish at a solution, and not at other depths") {
    for (const std::string notation :
         {"projective: 9*a/a/a", "projective: 3*Pab/Pab/Pab/Pab/Pab/Pab",
          "projective: 2*PL/PL/PL + PLabcd/PLabcd/PLabcd + 2*P/P/P",
          "projective: 2*P/P/P + 2*Pabc/Pabc/Pabc"}) {
        CAPTURE(notation);
        const KnownScene scene = known_scene(notation);
        const SceneSystem system = scene_system(scene.problem, scene.views);
        SmallRow own;
        for (std::size_t i = scene.coordinates.size() - system.depths; i < scene.coordinates.size();
             ++i)
            own.push_back(Small::of_integer(scene.coordinates[i].get_num().get_si()));
        for (std::size_t camera = 0; camera < system.cameras; ++camera) {
            const Resection resection(system, camera);
            CHECK(all_zero(resection.cubics(place_depths(system, own))));
            SmallRow other = own;
            other[0] = other[0] + Small{1};
            CHECK(!all_zero(resection.cubics(place_depths(system, other))));
        }
    }
}

TEST_CASE("the cubic forms of any image vanish at base scenes, and only there to that order") {
    Choices choices;
    std::size_t pencils = 0, tangents = 0;
    for (const auto& [notation, degree] : projective_degrees()) {
        CAPTURE(notation);
        const Problem problem = problem_of(notation);
        if (problem.points.size() == 7) continue; // on two lines or more: too few equations
        const SceneSystem system = scene_system(problem, random_views(problem, 3, 1));
        const BaseScenes base = base_scenes(problem, system);
        for (std::size_t camera = 0; camera < 2; ++camera) {
            const Resection resection(system, camera);
            CHECK(order_at(system, resection, choices.row(system.depths), choices) == 0);
            for (const FewDepths& few : base.few_depths) {
                const SmallRow own = choose_scene(system, few, choices);
                CHECK(order_at(system, resection, own, choices) >= few.order);
            }
            for (const Pencil& pencil : base.pencils) {
                const SmallRow own = choose_scene(system, pencil, choices);
                CHECK(order_at(system, resection, own, choices) >= 1);
            }
            for (const Tangent& tangent : base.tangents) {
                const auto [own, direction] = choose_tangent(problem, system, tangent, choices);
                CHECK(order_in(system, resection, own, direction) == 2);
            }
        }
        pencils += base.pencils.size();
        tangents += base.tangents.size();
    }
    CHECK(pencils > 100);
    CHECK(tangents > 10);
}

TEST_CASE("an image with fewer than 12 equations has no cubic forms") {
    const auto tried = [](const std::string& notation) {
        const Problem problem = problem_of(notation);
        const SceneSystem system = scene_system(problem, random_views(problem, 2, 1));
        return say(system.equations.size(), ": ",
                   refusal([&] { const Resection resection(system, 0); }));
    };
    CHECK(tried("projective: 3*PL/PL + 3*PM/PM + P/P") == "12: ");
    CHECK(tried("projective: PLMN/PLMN + 2*PL/PL + 2*PM/PM + 2*PN/PN") ==
          "11: an image has fewer than 12 equations");
}

TEST_CASE("view 1 may not show another point of the line where it shows the one of a tangent") {
    const Problem problem = problem_of("projective: 2*PLab/PLab/PLab + PLabc/PLabc/PLabc + P/P/P");
    std::vector<Numbers> views = random_views(problem, 3, 1);
    views[0][6] = 0; // factors of points 0 and 1
    views[0][7] = 1; // so point 2 is where point 1 is
    const SceneSystem system = scene_system(problem, views);
    const std::vector<Tangent> tangents = base_scenes(problem, system).tangents;
    REQUIRE(tangents.size() == 2);
    for (const Tangent& tangent : tangents) {
        CAPTURE(tangent.point);
        Choices choices;
        CHECK(refusal([&] { choose_tangent(problem, system, tangent, choices); }) ==
              (tangent.point == 0 ? "" : "view 1 is too special: take other images there"));
    }
}
