// Theorem Q of proofs/moduli.md: all degrees that monodromy found, all problems that it speaks of,
// and its conditions at their borders.
#include "checker/general_bounds/three_views.h"

#include "checker/problem/notation.h"
#include "tests/checker/general_bounds/degrees_on_file.h"
#include "tests/checker/problem/visible_problem.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

std::optional<std::size_t> degree_of(const std::string& notation) {
    return degree_in_three_views(parse_problem(notation));
}

/// Calls `visit` with all lists of numbers of pins, 4 at most and ascending, of points that leave
/// some of the 18 dimensions of cameras to free lines.
template <class Visit>
void for_each_choice(std::vector<std::size_t>& pins, std::size_t open, const Visit& visit) {
    visit(open);
    const std::size_t least = pins.empty() ? 0 : pins.back();
    for (std::size_t k = least; k <= 4 && 3 + k <= open; ++k) {
        pins.push_back(k);
        for_each_choice(pins, open - 3 - k, visit);
        pins.pop_back();
    }
}

} // namespace

TEST_CASE("the degrees that monodromy found are those of Theorem Q, wherever it applies") {
    std::size_t problems = 0;
    for (const OnFile& row : family_degrees_on_file()) {
        CAPTURE(row.problem);
        const std::optional<std::size_t> degree = degree_of(row.problem);
        if (!degree) continue;
        CHECK(*degree == std::stoul(row.degree));
        ++problems;
    }
    CHECK(problems == 46);
}

TEST_CASE("of all balanced problems of Theorem Q, one is not minimal: the others are on file") {
    std::vector<std::size_t> pins;
    std::size_t minimal = 0;
    for_each_choice(pins, 18, [&](std::size_t open) {
        if (open % 2 != 0) return;
        CAPTURE(open);
        CAPTURE(pins.size());
        const auto degree = degree_in_three_views(visible_problem(3, pins, open / 2));
        REQUIRE(degree);
        minimal += *degree > 0;
        CHECK((*degree == 0) == (pins == std::vector<std::size_t>{0, 0, 0, 4}));
    });
    CHECK(minimal == 46);
}

TEST_CASE("nine lines have 36 solutions, and six points have three") {
    CHECK(degree_of("projective: 9*a/a/a") == 36U);
    CHECK(degree_of("projective: 6*P/P/P") == 3U);
}

TEST_CASE("Theorem Q is for projective cameras in three views") {
    CHECK(degree_of("3*P/P/P + a/a/a") == std::nullopt);
    CHECK(degree_of("projective: 7*P/P") == std::nullopt);
    CHECK(degree_of("projective: 5*P/P/P/P + a/a/a/a") == std::nullopt);
}

TEST_CASE("Theorem Q is for balanced problems") {
    CHECK(degree_of("projective: 5*P/P/P") == std::nullopt);
    CHECK(degree_of("projective: 6*P/P/P + a/a/a") == std::nullopt);
}

TEST_CASE("Theorem Q is for views that see everything") {
    CHECK(degree_of("projective: 5*P/P/P + 3*P/P/-") == std::nullopt);
    CHECK(degree_of("projective: 6*P/P/P + a/a/-") == std::nullopt);
}

TEST_CASE("Theorem Q is for lines with one point at most") {
    CHECK(degree_of("projective: 2*PL/PL/PL + 4*P/P/P") == std::nullopt);
    CHECK(degree_of("projective: 3*PL/PL/PL + 3*PM/PM/PM + a/a/a") == std::nullopt);
}

TEST_CASE("Theorem Q is for points with four lines at most") {
    CHECK(degree_of("projective: 2*Pabcd/Pabcd/Pabcd + 2*a/a/a") == 16U);
    CHECK(degree_of("projective: Pabcde/Pabcde/Pabcde + 5*a/a/a") == std::nullopt);
}
