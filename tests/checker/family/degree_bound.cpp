// Theorem 16 of proofs/families.md: each item at its border, and all degrees that monodromy found.
#include "checker/family/degree_bound.h"

#include "checker/general_bounds/hilbert.h"
#include "checker/general_bounds/proved_degrees.h"
#include "checker/general_bounds/three_views.h"
#include "checker/problem/notation.h"
#include "tests/checker/general_bounds/degrees_on_file.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

using Bound = std::optional<std::size_t>;

Bound bound_of(const std::string& notation) {
    return degree_bound(parse_problem(notation));
}

} // namespace

TEST_CASE("two axes that share a point bound the degree by one, two that do not share one do not") {
    CHECK(bound_of("projective: PLM/PLM + 2*PL/PL + 2*PM/PM + 2*P/P") == 1U);
    CHECK(bound_of("projective: PLM/PLM/PLM + 2*PL/PL/PL + 2*PMab/PMab/PMab") == 1U);
    CHECK(bound_of("projective: 2*PL/PL/PL + PLa/PLa/PLa + 2*PM/PM/PM + PMa/PMa/PMa") != 1U);
}

TEST_CASE("without another line at the axis, the bound counts the lines that meet subspaces") {
    // Three planes through the axis or fewer: one line. In the last two, there is another axis.
    CHECK(bound_of("projective: 3*PL/PL/PL + 5*a/a/a") == 1U);
    CHECK(bound_of("projective: 2*PL/PL/PL/PL + PLa/PLa/PLa/PLa + 2*Pa/Pa/Pa/Pa") == 1U);
    CHECK(bound_of("projective: 3*PL/PL/PL + 3*PM/PM/PM + a/a/a") == 1U);
    CHECK(bound_of("projective: 3*PL/PL/PL + PM/PM/PM + 2*PMa/PMa/PMa") == 1U);
    // Lines in space that meet four lines: two.
    CHECK(bound_of("projective: 3*PL/PL + 4*P/P") == 2U);
    CHECK(bound_of("projective: 2*PLa/PLa/PLa + PLab/PLab/PLab + 3*a/a/a") == 2U);
    // In dimension 4, six planes; in dimension 6, ten subspaces of dimension 4.
    CHECK(bound_of("projective: 2*PL/PL/PL + PLabcdef/PLabcdef/PLabcdef + 2*a/a/a") == 5U);
    CHECK(bound_of("projective: PL/PL/PL + 2*PLabcde/PLabcde/PLabcde") == 42U);
    // In dimension 4, four planes and a line.
    CHECK(bound_of("projective: 2*PL/PL/PL + PLabcd/PLabcd/PLabcd + Pa/Pa/Pa + a/a/a") == 3U);
}

TEST_CASE(
    "the bound by an axis wants a balanced problem, and no other line of points at the axis") {
    CHECK(bound_of("projective: 3*PL/PL/PL + 6*a/a/a") == std::nullopt);
    CHECK(bound_of("projective: 3*PL/PL/PL + 4*P/P/P") == std::nullopt);
    CHECK(bound_of("projective: 3*PL/PL/PL + Pabcdef/Pabcdef/Pabcdef") == std::nullopt);
    CHECK(bound_of("projective: 2*PL/PL/PL + PLM/PLM/PLM + PM/PM/PM + P/P/P") == std::nullopt);
}

TEST_CASE("two uncalibrated views have at most three solutions") {
    CHECK(bound_of("projective: 7*P/P") == 3U);
    CHECK(bound_of("projective: 6*P/P/P") == std::nullopt);
}

TEST_CASE("two views with a focal length each have at most twice as many as uncalibrated ones") {
    CHECK(bound_of("focal: 7*P/P") == 6U);
    CHECK(bound_of("focal: 3*PL/PL + 4*P/P") == 4U);
    CHECK(bound_of("focal: 6*P/P + P/-") == std::nullopt);
    CHECK(bound_of("focal: 3*PL/PL/PL + 3*a/a/a") == std::nullopt);
    CHECK(bound_of("upright-focal: 5*P/P") == std::nullopt);
}

TEST_CASE("known verticals leave few solutions in two views, and where three views see two lines") {
    CHECK(bound_of("upright: 3*P/P") == 4U);
    CHECK(bound_of("upright: P/P/P + 2*a/a/a") == 6U);
    CHECK(bound_of("upright: P/P/P + Pa/Pa/Pa") == 6U);
    CHECK(bound_of("upright: P/P/P/P + 2*a/a/a/a") == std::nullopt);
    CHECK(bound_of("upright: Pa/Pa/Pa") == std::nullopt);
    CHECK(bound_of("upright: P/-/P + a/a/a + Pa/Pa/Pa") == std::nullopt);
    CHECK(bound_of("upright-shared-focal: 4*P/P") == 5U);
    CHECK(bound_of("upright-shared-focal: 3*PL/PL + P/P") == 4U);
    CHECK(bound_of("upright-shared-focal: 2*Pa/Pa/Pa") == 14U);
    CHECK(bound_of("upright-shared-focal: Pa/Pa/Pa + 2*a/a/a") == 14U);
    CHECK(bound_of("upright-shared-focal: 3*PL/PL/PL") == 6U);
    CHECK(bound_of("upright-shared-focal: 2*P/P/P + a/a/a") == std::nullopt);
}

TEST_CASE("the theorem is for projective cameras that all see everything") {
    CHECK(bound_of("5*P/P") == std::nullopt);
    CHECK(bound_of("PLM/PLM + 2*PL/PL + 2*PM/PM") == std::nullopt);
    CHECK(bound_of("projective: PLM/PLM/PLM + 2*PL/PL/PL + 2*PM/PM/PM + P/P/P") == 1U);
    CHECK(bound_of("projective: PLM/PLM/PLM + 2*PL/PL/PL + 2*PM/PM/PM + P/P/-") == std::nullopt);
}

TEST_CASE(
    "no degree that monodromy found is above its bound; the file says `by theorem` where a "
    "theorem bounds it and as many solutions are certified; and the bound is one wherever the "
    "degree is") {
    std::size_t ones = 0, certified = 0, all_certified = 0;
    for (const OnFile& row : family_degrees_on_file()) {
        CAPTURE(row.problem);
        const Bound bound = bound_of(row.problem);
        const std::size_t degree = std::stoul(row.degree);
        if (bound) CHECK(degree <= *bound);
        const auto problem = parse_problem(row.problem);
        const auto proved = proved_degree(problem);
        if (proved) CHECK(proved->at_most == degree);
        const bool by_theorem = bound == degree || degree_in_three_views(problem) == degree ||
                                degree_by_invariants(problem) == degree || proved;
        CHECK(row.source.starts_with("by theorem") == by_theorem);
        if (by_theorem) CHECK(row.certified == row.degree);
        all_certified += by_theorem;
        if (bound == degree) CHECK(row.status == "certified");
        CHECK((row.family == "projective" && degree == 1) == (bound == 1U));
        ones += bound == 1U;
        certified += bound == degree;
    }
    CHECK(ones == 75);
    CHECK(certified == 142);
    CHECK(all_certified == 286);
}
