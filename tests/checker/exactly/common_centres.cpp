// The third blow-up: Lemmas C1 to C3, by the numbers that replace powers of its divisors.
#include "checker/exactly/common_centres.h"
#include "tests/support/all_classes.h"

#include <doctest/doctest.h>

using namespace checker;
using namespace checker::exactly;

namespace {
constexpr std::size_t most = 5;

Residue power(Residue x, unsigned n) {
    return n == 0 ? Residue{1} : x * power(x, n - 1);
}

/// A class of degree 1 from below.
Residue some_class(const Chart& chart) {
    const FixedPoint& at = chart.at;
    return Residue{2} * at.h[0] + Residue{3} * at.h[1] + Residue{7} * at.h[2] +
           Residue{5} * at.x[3] + Residue{11} * chart.both[0] + Residue{13} * chart.both[1] +
           Residue{19} * at.exceptional[0];
}

/// The integral of powers of the three divisors, and of the class from below that leaves degree 11.
Residue integral(const std::array<std::size_t, 3>& exponents) {
    const std::size_t degree = exponents[0] + exponents[1] + exponents[2];
    Residue sum;
    for (const Chart& chart : charts_of_second_blow_up(5)) {
        Residue value = chart.at.weight * power(some_class(chart), unsigned(11 - degree));
        for (std::size_t third = 0; third < 3; ++third)
            value = value * powers_of_common_centres(chart, third, most)[exponents[third]];
        sum = sum + value;
    }
    return sum;
}
} // namespace

TEST_CASE("the loci of common centres have codimension 3, and two of them meet in codimension 6") {
    for (std::size_t third = 0; third < 3; ++third) {
        for (std::size_t i = 1; i < 3; ++i) {
            std::array<std::size_t, 3> exponents{};
            exponents[third] = i;
            CHECK(integral(exponents) == Residue{});
        }
        std::array<std::size_t, 3> cube{}, two{3, 3, 3};
        cube[third] = 3;
        two[third] = 0;
        CHECK(integral(cube) != Residue{});
        CHECK(integral(two) != Residue{});
    }
}

TEST_CASE("no three views have common centres in pairs") {
    CHECK(integral({3, 3, 3}) == Residue{});
    CHECK(integral({3, 3, 4}) == Residue{});
    CHECK(integral({5, 3, 3}) == Residue{});
}

TEST_CASE("at a fixed point on two loci of common centres a normal bundle has three roots") {
    // Where no class was moved, rho^3 is the product of the roots, and rho^4 its product with their
    // sum: so a cubic has the coefficients of the Chern classes, and rho^5 follows from them.
    std::size_t on_locus = 0;
    for (const Chart& chart : charts_of_second_blow_up(5))
        for (std::size_t third = 0; third < 3; ++third) {
            const auto rho = powers_of_common_centres(chart, third, 8);
            if (rho[3] == Residue{}) continue;
            ++on_locus;
            // rho^i = c_1 rho^(i-1) - c_2 rho^(i-2) + c_3 rho^(i-3) for three roots; rho^1 and
            // rho^2 are 0, and rho^0 - the integral over the fibre - does not count here.
            const Residue c1 = rho[4] * rho[3].inverse();
            const Residue c2 = c1 * c1 - rho[5] * rho[3].inverse();
            const Residue c3 = rho[6] * rho[3].inverse() - c1 * c1 * c1 + Residue{2} * c1 * c2;
            CHECK(rho[7] == c1 * rho[6] - c2 * rho[5] + c3 * rho[4]);
        }
    CHECK(on_locus > 0);
}

TEST_CASE("points that two views see satisfy the epipolar constraint: their class is Delta_uv") {
    // The class of -/P/P is that of the form Delta_uv, linear in both image points: it is the
    // determinant of the map of two lines to W_u + W_v modulo the image of V (Lemma C3).
    const Feature& point = features[index_of("-/P/P")];
    for (const Chart& chart : charts_of_second_blow_up(5)) {
        const FixedPoint& at = chart.at;
        Residue determinant = -at.image[1] - at.image[2] - chart.both[0];
        for (const std::size_t view : {1U, 2U})
            for (const Residue w : at.w[view])
                determinant = determinant + w;
        for (const Residue x : at.x)
            determinant = determinant - x;
        const LinearClass found = class_of(chart, point);
        CHECK(found.constant == determinant);
        CHECK(found.common == Triple{-Residue{1}, {}, {}});
    }
}
