// Counting solutions by valuations (proofs/upright_views.md, section 2), against Bernstein's
// theorem and against systems that can be solved by hand.
#include "checker/general_bounds/valuations.h"

#include <doctest/doctest.h>
#include <random>

using namespace checker;

namespace {

Valued term(int x, int y, std::int64_t valuation) {
    Exponents exponents;
    if (x != 0) exponents[0] = x;
    if (y != 0) exponents[1] = y;
    return {{exponents, valuation}};
}

Valued with_random_valuations(const std::vector<std::pair<int, int>>& support,
                              std::mt19937& random) {
    Valued sum;
    for (const auto& [x, y] : support)
        sum = sum + term(x, y, static_cast<std::int64_t>(random() % 100'000));
    return sum;
}

std::optional<std::size_t> solutions(const std::vector<std::vector<std::pair<int, int>>>& supports,
                                     std::mt19937& random) {
    std::vector<Condition> system;
    for (const auto& support : supports)
        system.push_back({Role::equation, with_random_valuations(support, random)});
    return solutions_by_valuations(2, system);
}

} // namespace

TEST_CASE("polynomials whose coefficients do not cancel are added and multiplied") {
    const Valued sum = term(1, 0, 3) + term(0, 1, 5) + term(1, 0, 2);
    CHECK(sum == term(0, 1, 5) + term(1, 0, 2));
    CHECK(sum * term(-1, 0, 4) == term(0, 0, 6) + term(-1, 1, 9));
}

TEST_CASE("two equations have as many solutions as the mixed area of their polygons") {
    const std::vector<std::pair<int, int>> line{{0, 0}, {1, 0}, {0, 1}};
    const std::vector<std::pair<int, int>> square{{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    const std::vector<std::pair<int, int>> conic{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}, {0, 2}};
    const std::vector<std::pair<int, int>> hexagon{{1, 0},  {0, 1},  {-1, 1},
                                                   {-1, 0}, {0, -1}, {1, -1}};
    const std::vector<std::pair<int, int>> binomial{{0, 0}, {2, -3}};
    std::mt19937 random(1);
    for (int i = 0; i < 20; ++i) {
        CAPTURE(i);
        CHECK(solutions({line, line}, random) == 1);
        CHECK(solutions({line, conic}, random) == 2);
        CHECK(solutions({conic, conic}, random) == 4);
        CHECK(solutions({square, square}, random) == 2);
        CHECK(solutions({hexagon, hexagon}, random) == 6);
        CHECK(solutions({hexagon, line}, random) == 3);
        CHECK(solutions({binomial, line}, random) == 3);
        CHECK(solutions({binomial, {{0, 0}, {1, 1}}}, random) == 5);
        CHECK(solutions({binomial, {{0, 0}, {4, -6}}}, random) == 0);
    }
}

TEST_CASE("without two regular least terms at each point there is no number") {
    const Valued line = term(1, 0, 0) + term(0, 1, 0) + term(0, 0, 0);
    // The same line; the same least terms; three least terms at one point.
    CHECK(!solutions_by_valuations(2, {{Role::equation, line}, {Role::equation, line}}));
    CHECK(!solutions_by_valuations(
        2, {{Role::equation, line}, {Role::equation, term(1, 0, 0) + term(0, 1, 0)}}));
    CHECK(!solutions_by_valuations(2, {{Role::equation, line}}));
    CHECK(solutions_by_valuations(
              2, {{Role::equation, line}, {Role::equation, term(1, 0, 5) + term(0, 1, 0)}}) == 1);
}

TEST_CASE("relations may follow from others, and consequences change nothing") {
    // x + y + 1, its multiple with x y^-1, and the sum of both: a line. It meets x y = s once more.
    const Valued line = term(1, 0, 0) + term(0, 1, 0) + term(0, 0, 0);
    const Condition curve{Role::equation, term(1, 1, 0) + term(0, 0, 7)};
    CHECK(solutions_by_valuations(2, {{Role::relation, line}, curve}) == 2);
    CHECK(solutions_by_valuations(2, {{Role::relation, line}, {Role::relation, line}, curve}) == 2);
    CHECK(solutions_by_valuations(
              2, {{Role::consequence, line * line}, {Role::relation, line}, curve}) == 2);
}
