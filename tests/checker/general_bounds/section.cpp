// Bounds of Theorem F: whatever the powers and the images, none is below the degree that monodromy
// found; and each is reached.
#include "checker/general_bounds/section.h"

#include "tests/checker/general_bounds/projective_problems.h"

#include <doctest/doctest.h>

using namespace checker;
using namespace checker::general;

namespace {

/// A bound; none if the powers do not give one, or need too many monomials for a test.
std::optional<std::size_t> bound_of(const std::string& notation, const Powers& powers,
                                    unsigned seed = 1) {
    const Problem problem = problem_of(notation);
    const auto cameras = static_cast<std::size_t>(std::popcount(problem.views)) - 1;
    try {
        return solutions_at_most(problem, random_views(problem, 1 + 4 * cameras, seed), powers,
                                 [](std::size_t monomials) {
                                     if (monomials > 450) throw Refused("too many monomials");
                                 });
    } catch (const Refused&) {
        return std::nullopt;
    }
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

TEST_CASE("too few powers give no bound, or a larger one") {
    CHECK(bound_of("projective: 4*Pa/Pa/Pa/Pa/Pa", {3, 1}) == 7U);
    CHECK(bound_of("projective: 4*Pa/Pa/Pa/Pa/Pa", {2, 1}) != 7U);
}
