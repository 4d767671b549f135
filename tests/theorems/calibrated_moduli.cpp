// The integrals of Theorem Y (proofs/calibrated_moduli.md) by second methods: numbers of invariants
// give one of them, and no choice matters. The program proofs/computations/calibrated_moduli.cpp,
// which is a test, too, compares the numbers of the theorem with the checker's table.
#include "proofs/computations/isotropic_planes.h"
#include "proofs/computations/moduli_space.h"

#include <doctest/doctest.h>

#include <array>
#include <vector>

using namespace proofs;

namespace {

/// How many times each weight of the torus of SL_2 occurs, from the lowest weight, in steps of 2.
using Multiplicities = std::vector<std::int64_t>;

Multiplicities product(const Multiplicities& a, const Multiplicities& b) {
    Multiplicities result(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            result[i + j] += a[i] * b[j];
    return result;
}

/// Polynomials of this degree in four coordinates, two of each weight 1 and -1.
Multiplicities of_quaternion(std::int64_t degree) {
    Multiplicities result;
    for (std::int64_t k = 0; k <= degree; ++k)
        result.push_back((k + 1) * (degree - k + 1));
    return result;
}

/// The dimension of the invariants: how much more often the weight 0 occurs than 2.
std::int64_t invariants(const Multiplicities& all) {
    if (all.size() % 2 == 0) return 0;
    const std::size_t middle = all.size() / 2;
    return all[middle] - (middle == 0 ? 0 : all[middle - 1]);
}

/// All products of polynomials of these degrees less 2 m_v in the quaternions, and of degrees m_v
/// in the translations, which are three to a view, for all m_v with this sum.
Multiplicities polynomials(const std::array<std::int64_t, 3>& degrees, std::int64_t sum) {
    const auto factor = [&](std::size_t view, std::int64_t m) {
        Multiplicities all = of_quaternion(degrees[view] - 2 * m);
        for (std::int64_t& one : all)
            one *= (m + 1) * (m + 2) / 2;
        return all;
    };
    Multiplicities total(static_cast<std::size_t>(degrees[0] + degrees[1] + degrees[2] - 2 * sum) +
                         1);
    for (std::int64_t m1 = 0; m1 <= sum; ++m1) {
        for (std::int64_t m2 = 0; m1 + m2 <= sum; ++m2) {
            const Multiplicities term =
                product(factor(0, m1), product(factor(1, m2), factor(2, sum - m1 - m2)));
            for (std::size_t i = 0; i < total.size(); ++i)
                total[i] += term[i];
        }
    }
    return total;
}

/// The Euler characteristic of the n-th power of the line bundle of this character: translations of
/// space are divided out, by exterior powers of their three coordinates, of the weights 2, 0, -2.
std::int64_t euler_characteristic(const Character& bundle, std::int64_t n) {
    const std::array<std::int64_t, 3> degrees{n * bundle[a1], n * bundle[a2], n * bundle[a3]};
    const std::array<Multiplicities, 4> exterior{{{1}, {1, 1, 1}, {1, 1, 1}, {1}}};
    std::int64_t sum = 0;
    for (std::int64_t j = 0; j <= 3 && j <= n * bundle[s]; ++j) {
        const auto all =
            product(exterior[static_cast<std::size_t>(j)], polynomials(degrees, n * bundle[s] - j));
        sum += j % 2 == 0 ? invariants(all) : -invariants(all);
    }
    return sum;
}

/// The difference of order 11, that is 11! times the leading coefficient of a polynomial of degree
/// 11: the integral of the power of the first Chern class.
std::int64_t top_difference(const Character& bundle) {
    std::vector<std::int64_t> values;
    for (std::int64_t n = 0; n <= 12; ++n)
        values.push_back(euler_characteristic(bundle, n));
    for (int order = 0; order < 11; ++order) {
        for (std::size_t i = 0; i + 1 < values.size(); ++i)
            values[i] = values[i + 1] - values[i];
        values.pop_back();
    }
    CHECK(values[0] == values[1]); // it is a polynomial of degree 11
    return values[0];
}

} // namespace

namespace {

/// The integral of the 11th power of the first Chern class.
std::int64_t top_power(const std::vector<FixedPoint>& points, const Character& bundle) {
    Residue sum;
    for (const auto& [weight, roots] : points) {
        Residue chern = residue_of(-bundle[s]) * roots.x[3];
        for (std::size_t view = 0; view < 3; ++view)
            chern = chern + residue_of(bundle[a1 + view] / 2) * roots.h[view];
        Residue term = weight;
        for (int i = 0; i < 11; ++i)
            term = term * chern;
        sum = sum + term;
    }
    return number_of(sum);
}

/// The degree of the class of the features: the number of their constraints.
unsigned degree_of(const VisibleFeatures& features) {
    unsigned degree = 2 * features.lines;
    for (const unsigned pins : features.pins)
        degree += 3 + pins;
    return degree;
}

/// All with at most 4 pins at a point, and with this degree at most.
std::vector<VisibleFeatures> features_up_to(unsigned most) {
    std::vector<VisibleFeatures> all{{}};
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (unsigned pins = all[i].pins.empty() ? 0 : all[i].pins.back(); pins <= 4; ++pins) {
            VisibleFeatures more = all[i];
            more.pins.push_back(pins);
            if (degree_of(more) <= most) all.push_back(more);
        }
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        VisibleFeatures more = all[i];
        ++more.lines;
        if (degree_of(more) <= most) all.push_back(more);
    }
    return all;
}

/// The numbers of all features of degree 11.
std::vector<std::int64_t> numbers(const std::vector<FixedPoint>& points) {
    std::vector<std::int64_t> found;
    for (const VisibleFeatures& features : features_up_to(11))
        if (degree_of(features) == 11) found.push_back(intersection_number(points, features));
    return found;
}

/// The class of a free line from the fixed points of the Grassmannian of lines.
Residue localized_line(const Roots& roots) {
    Residue sum;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) {
            Residue above{1}, below{1};
            for (const Residue h : roots.h)
                above = above * (h - roots.x[i]) * (h - roots.x[j]);
            for (std::size_t l = 0; l < 4; ++l)
                if (l != i && l != j)
                    below = below * (roots.x[l] - roots.x[i]) * (roots.x[l] - roots.x[j]);
            sum = sum + above * below.inverse();
        }
    }
    return sum;
}

/// The class of a pin of the j-th point, from the fixed points of the plane of lines through it.
Residue localized_pin(const Roots& roots, std::size_t j) {
    Residue sum;
    for (std::size_t l = 0; l < 4; ++l) {
        if (l == j) continue;
        Residue above{1}, below{1};
        for (const Residue h : roots.h)
            above = above * (h - roots.x[l]);
        for (std::size_t k = 0; k < 4; ++k)
            if (k != j && k != l) below = below * (roots.x[k] - roots.x[l]);
        sum = sum + above * below.inverse();
    }
    return sum;
}

Residue localized_point(const Roots& roots, unsigned pins) {
    Residue sum;
    for (std::size_t j = 0; j < 4; ++j) {
        Residue above{1}, below{1};
        for (const Residue h : roots.h)
            above = above * (h - roots.x[j]) * (h - roots.x[j]);
        for (unsigned i = 0; i < pins; ++i)
            above = above * localized_pin(roots, j);
        for (std::size_t l = 0; l < 4; ++l)
            if (l != j) below = below * (roots.x[l] - roots.x[j]);
        sum = sum + above * below.inverse();
    }
    return sum;
}

} // namespace

TEST_CASE("integrals over the space of cameras: dimensions of spaces of invariants give the same") {
    for (const Character& bundle : {Character{0, 4, 4, 4, 1}, Character{0, 6, 6, 4, 1}})
        CHECK(top_power(fixed_points(bundle), bundle) == top_difference(bundle));
}

TEST_CASE("the classes of features by localisation on the spaces of points and lines") {
    for (const FixedPoint& point : fixed_points()) {
        CHECK(class_of_incident_line(point.roots.x, point.roots.h) == localized_line(point.roots));
        for (unsigned pins = 0; pins <= 4; ++pins)
            CHECK(class_of_point(point.roots, pins) == localized_point(point.roots, pins));
    }
}

TEST_CASE("intersection numbers depend neither on the shifts nor on small changes of stability") {
    const std::vector<std::int64_t> expected = numbers(fixed_points());
    CHECK(expected.size() == 11); // all minimal problems but the one with five pins at a point
    CHECK(numbers(fixed_points(stability, 2026)) == expected);
    CHECK(numbers(fixed_points({13, 1020, 1000, 970, 100})) == expected);
    CHECK(numbers(fixed_points({0, 4, 4, 4, 1})) == expected);
    CHECK_THROWS_AS(fixed_points({0, 2, 1, 1, 0}), std::logic_error); // not all are stable
}

TEST_CASE("products of classes of degree less than 11 have the integral 0") {
    const std::vector<FixedPoint> points = fixed_points();
    std::size_t count = 0;
    for (const VisibleFeatures& features : features_up_to(10)) {
        CHECK(intersection_number(points, features) == 0);
        ++count;
    }
    CHECK(count > 30);
}

TEST_CASE(
    "of problems of which Theorem Y does not speak the intersection number is not the degree") {
    const std::vector<FixedPoint> points = fixed_points();
    struct Other {
        VisibleFeatures features;
        std::int64_t degree, number;
    };
    const std::vector<Other> others{{{{5, 0}, 0}, 64, -24},     {{{2, 1}, 1}, 432, 480},
                                    {{{2, 0, 0}, 0}, 224, 320}, {{{1, 1, 0}, 0}, 312, 408},
                                    {{{1, 0}, 2}, 264, 360},    {{{0, 0, 0}, 1}, 216, 288}};
    for (const auto& [features, degree, number] : others) {
        CHECK(intersection_number(points, features) == number);
        CHECK(number != degree);
    }
}

TEST_CASE("two views see as many planes that touch the absolute conic, whatever their images are") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        CHECK(isotropic_planes(seed) == 8);
}
