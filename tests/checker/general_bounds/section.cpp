// Bounds of Theorem F: whatever the powers and the images, none is below the degree that monodromy
// found; and each is reached.
#include "checker/general_bounds/section.h"

#include "tests/checker/general_bounds/projective_problems.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

/// Random images of all views, and three times that number of further ones.
std::vector<Numbers> generic_views(const Problem& problem, unsigned seed) {
    const auto cameras = static_cast<std::size_t>(std::popcount(problem.views)) - 1;
    return random_views(problem, 1 + 4 * cameras, seed);
}

/// The bound that these images give; none if the powers do not give one, or need too many monomials
/// for a test.
std::optional<std::size_t> bound_by(const Problem& problem, const std::vector<Numbers>& views,
                                    const Powers& powers, std::uint64_t most_effort = 91) {
    try {
        return solutions_at_most(problem, views, powers, [=](std::uint64_t effort) {
            if (effort > most_effort) throw Refused("too many monomials");
        });
    } catch (const Refused&) {
        return std::nullopt;
    }
}

std::optional<std::size_t> bound_of(const std::string& notation, const Powers& powers,
                                    unsigned seed = 1) {
    const Problem problem = problem_of(notation);
    return bound_by(problem, generic_views(problem, seed), powers);
}

/// An image with coordinates and factors from -1 to 1: many of its places are the same, or three of
/// them on a line.
Numbers special_view(const Problem& problem, Dice& dice) {
    for (int tries = 0; tries < 10'000; ++tries)
        try {
            Numbers image(numbers_of_view(problem));
            for (int& number : image)
                number = dice.from_to(-1, 1);
            scene_system(problem, {image, image});
            return image;
        } catch (const Refused&) {
            continue; // does not meet the conditions of the format
        }
    FAIL("no image");
    return {};
}

} // namespace

TEST_CASE("no bound is below the degree on file, and many meet it") {
    std::size_t bounds = 0, sharp = 0;
    for (const auto& [notation, degree] : projective_degrees()) {
        CAPTURE(notation);
        bool is_sharp = false;
        for (const auto& [cubics, linear] : {Powers{1, 1}, {1, 2}, {2, 1}, {3, 1}}) {
            const auto bound = bound_of(notation, {cubics, linear});
            if (!bound) continue;
            ++bounds;
            CHECK(*bound >= degree);
            is_sharp = is_sharp || *bound == degree;
        }
        sharp += is_sharp;
    }
    CHECK(bounds > 100);
    CHECK(sharp > 50);
}

TEST_CASE("a bound does not depend on the images") {
    // In view 1 of the first images a point on the line is where another one is.
    for (const unsigned seed : {1U, 2U})
        CHECK(!bound_of("projective: 3*PL/PL/PL + 5*a/a/a", {1, 1}, seed));
    for (const unsigned seed : {2U, 3U, 4U}) {
        CHECK(bound_of("projective: 6*P/P/P", {1, 2}, seed) == 3U);
        CHECK(bound_of("projective: 2*P/P/P + 3*Pa/Pa/Pa", {2, 1}, seed) == 4U);
        CHECK(bound_of("projective: 2*PL/PL/PL + PLabcd/PLabcd/PLabcd + 2*P/P/P", {2, 1}, seed) ==
              2U);
    }
}

TEST_CASE("a special image in view 1 never makes a bound smaller than the degree") {
    Dice dice(1);
    std::size_t bounds = 0;
    for (const auto& [notation, degree] : projective_degrees()) {
        CAPTURE(notation);
        const Problem problem = problem_of(notation);
        std::vector<Numbers> views = generic_views(problem, 1);
        for (int tries = 0; tries < 5; ++tries) {
            views[0] = special_view(problem, dice);
            const auto bound = bound_by(problem, views, {1, 1}, 1);
            if (!bound) continue;
            ++bounds;
            CHECK(*bound >= degree);
        }
    }
    CHECK(bounds > 10);
}

TEST_CASE("view 1 may not show a point off a line where it shows one of the line") {
    // An axis through the two points off the line is in a plane with point 2 and the centre.
    const Problem problem = problem_of("projective: PL/PL/PL + 2*PLab/PLab/PLab + 2*P/P/P");
    std::vector<Numbers> views = generic_views(problem, 1);
    const auto any = [](std::size_t) {};
    CHECK(solutions_at_most(problem, views, {2, 1}, any) == 3);
    std::copy_n(views[0].begin() + 3, 3, views[0].begin() + 8); // point 4 as point 2
    std::string reason;
    try {
        solutions_at_most(problem, views, {2, 1}, any);
    } catch (const Refused& refused) {
        reason = refused.reason;
    }
    CHECK(reason == "view 1 is too special: take other images there");
}

TEST_CASE("a problem with too many cubic forms is refused before they are computed") {
    const std::string point = "P" + std::string("abcdefghijkl");
    const Problem problem = problem_of("projective: 6*P/P + " + point + "/" + point);
    std::string reason;
    try {
        solutions_at_most(problem, random_views(problem, 30, 1), {1, 1}, [](std::size_t) {});
    } catch (const Refused& refused) {
        reason = refused.reason;
    }
    CHECK(reason.starts_with("it takes more than 20000000 values of cubic forms"));
}

TEST_CASE("too few powers give no bound, or a larger one") {
    CHECK(bound_of("projective: 4*Pa/Pa/Pa/Pa/Pa", {3, 1}) == 7U);
    CHECK(bound_of("projective: 4*Pa/Pa/Pa/Pa/Pa", {2, 1}) != 7U);
}

TEST_CASE("monomials are looked for in a limited number of steps") {
    const Problem problem = problem_of("projective: 7*P/P + 20*a/a");
    const SceneSystem system = scene_system(problem, random_views(problem, 3, 1));
    const SceneCoordinates coordinates(system, {});
    // Half of the coordinates leave room for a degree of 11, the other half likewise: 23 is missed
    // at the end of each of very many ways.
    BaseScenes base{.few_depths = {{.order = 12}, {.order = 12}}};
    for (std::size_t i = 0; i < coordinates.kept().size(); ++i)
        base.few_depths[i % 2].depths.push_back(coordinates.kept()[i]);
    std::string reason;
    try {
        monomials_that_fit(base, coordinates, {1, 20});
    } catch (const Refused& refused) {
        reason = refused.reason;
    }
    CHECK(contains(reason, "it takes more than 300000 steps"));
}
