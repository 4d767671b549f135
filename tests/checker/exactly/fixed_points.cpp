// The fixed points of the spaces of calibrated cameras, by laws that sums over them obey.
#include "checker/exactly/fixed_points.h"

#include <doctest/doctest.h>

#include <functional>

using namespace checker;
using namespace checker::exactly;

namespace {
Residue power(Residue x, unsigned n) {
    return n == 0 ? Residue{1} : x * power(x, n - 1);
}

Residue sum_over_charts(std::uint64_t seed, const std::function<Residue(const Chart&)>& value) {
    Residue sum;
    for (const Chart& chart : charts_of_second_blow_up(seed))
        sum = sum + chart.at.weight * value(chart);
    return sum;
}

/// A class of degree 1 in which all of the space has a part.
Residue some_class(const Chart& chart) {
    const FixedPoint& at = chart.at;
    return Residue{2} * at.h[0] + Residue{3} * at.h[1] + Residue{7} * at.h[2] +
           Residue{5} * at.x[3] + Residue{11} * chart.both[0] + Residue{13} * chart.both[1] +
           Residue{17} * chart.both[2] + Residue{19} * at.exceptional[0] +
           Residue{23} * at.exceptional[1];
}
} // namespace

TEST_CASE("there are 1,152 fixed points of the first blow-up") {
    std::size_t null = 0, regular = 0;
    for (const FixedPoint& at : fixed_points(5))
        ++(at.x[0] == Residue{} ? null : regular);
    CHECK(null == 432);
    CHECK(regular == 720);
}

TEST_CASE("the space has dimension 11: integrals in lower degrees are 0, in this one a number") {
    for (const unsigned degree : {0U, 1U, 5U, 10U})
        CHECK(sum_over_charts(5, [&](const Chart& chart) {
                  return power(some_class(chart), degree);
              }) == Residue{});
    const auto top = [](const Chart& chart) { return power(some_class(chart), 11); };
    const Residue number = sum_over_charts(5, top);
    CHECK(number != Residue{});
    CHECK(sum_over_charts(77, top) == number); // whatever the weights of the tori are
}

TEST_CASE("what lies over a locus in different views, or over three null views, does not meet") {
    // A point in three of the Y_v there is none: no cameras have V / H in two views at a time.
    const auto product = [](const Chart& chart) {
        const auto& e = chart.at.exceptional;
        return power(e[0] * e[1] * e[2], 3) * power(some_class(chart), 2);
    };
    CHECK(sum_over_charts(5, product) == Residue{});
}

TEST_CASE(
    "the divisor G_uv over two null views goes to 0 below, and its square to minus where both "
    "are null") {
    const auto from_below = [](const Chart& chart) {
        return chart.at.h[0] + Residue{3} * chart.at.x[3] + Residue{7} * chart.at.exceptional[2];
    };
    for (std::size_t third = 0; third < 3; ++third) {
        const auto first = [&](const Chart& chart) {
            return chart.both[third] * power(from_below(chart), 10);
        };
        const auto square = [&](const Chart& chart) {
            const auto& d = chart.at.image; // the classes of the divisors of null cameras
            const Residue both = d[(third + 1) % 3] * d[(third + 2) % 3];
            return (chart.both[third] * chart.both[third] + both) * power(from_below(chart), 9);
        };
        CHECK(sum_over_charts(5, first) == Residue{});
        CHECK(sum_over_charts(5, square) == Residue{});
    }
}
