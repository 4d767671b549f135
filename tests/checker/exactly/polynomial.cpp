// Integrals over projective bundles: by Segre classes, as the checker has them, and by the fixed
// points of a torus, where the roots are different.
#include "checker/exactly/polynomial.h"

#include <doctest/doctest.h>

using namespace checker;
using namespace checker::exactly;

namespace {
const std::vector<Residue> roots{Residue{2}, Residue{7}, Residue{30}, Residue{101}};
const Polynomial f{{Residue{3}, Residue{1}, Residue{4}, Residue{1}, Residue{5}, Residue{9}}};
const Polynomial g{{Residue{2}, Residue{7}, Residue{1}, Residue{8}, Residue{2}}};

/// The product of the other roots less this one, but for one that is left out.
Residue tangents(const std::vector<Residue>& all, Residue at, Residue without) {
    Residue product{1};
    for (const Residue root : all)
        if (root != at && root != without) product = product * (root - at);
    return product;
}
} // namespace

TEST_CASE("integrals over the points of a bundle") {
    Residue sum;
    for (const Residue x : roots)
        sum = sum + value_at(f, x) * tangents(roots, x, x).inverse();
    CHECK(integral_over_points(f, roots) == sum);
    // On P^3, -x is the class of a plane.
    const std::vector<Residue> trivial(4);
    CHECK(integral_over_points({{{}, {}, {}, -Residue{1}}}, trivial) == Residue{1});
    CHECK(integral_over_points({{Residue{1}, Residue{1}}}, trivial) == Residue{});
}

TEST_CASE("integrals over the lines through a point, and over points on lines") {
    Residue flags;
    for (const Residue x : roots) {
        Residue lines;
        for (const Residue l : roots)
            if (l != x) lines = lines + value_at(g, l) * tangents(roots, l, x).inverse();
        CHECK(value_at(integral_over_quotient(g, roots), x) == lines);
        flags = flags + value_at(f, x) * lines * tangents(roots, x, x).inverse();
    }
    CHECK(integral_over_flags(f, g, roots) == flags);
}

TEST_CASE("a polynomial is the sum and the difference of others") {
    const Residue x{12345};
    CHECK(value_at(f + g, x) == value_at(f, x) + value_at(g, x));
    CHECK(value_at(f - g, x) == value_at(f, x) - value_at(g, x));
    CHECK(value_at(f * g, x) == value_at(f, x) * value_at(g, x));
    CHECK(value_at(Polynomial{}, x) == Residue{});
}
