// Theorem Y (proofs/focal_planes.md): three cameras modulo a prime, with a focal length each, that
// see a plane and a line through a point of it; and intersection numbers.
#include "tests/theorems/isotropic_view.h"

#include <doctest/doctest.h>

using namespace checker;
using namespace isotropic;
using proofs::Residues;

namespace {

// The plane of the first two coordinates: directions I and J in it, and its normal.
constexpr Vector first_isotropic{Residue{1}, {}, {}}, second_isotropic{Residue{}, {1}, {}};
constexpr Vector normal{Residue{}, {}, {1}};

} // namespace

TEST_CASE("three cameras see the circular points of a plane, and a line, as Theorem Y says") {
    Residues random(1);
    const Vector a{random.next(), random.next(), {}}, end = random_vector(random);
    std::array<Vector, 3> lines, seen_normals; // m_v, by I, J and the origin of the plane
    std::array<Residue, 3> factors;            // of (4), the same ones
    for (std::size_t v = 0; v < 3; ++v) {
        const View view(random);
        const Residue w = view.w(), scale = random.next();
        const Vector i = times(scale, view.direction(first_isotropic));
        const Vector j = times(scale, view.direction(second_isotropic));
        const Vector n = times(scale, view.direction(normal));
        CHECK(form(i, i, w) == Residue{});
        CHECK(form(j, j, w) == Residue{});
        CHECK(i[0] * i[1] * j[2] * j[2] == j[0] * j[1] * i[2] * i[2]); // (1)
        CHECK(form(n, i, w) == Residue{});
        CHECK(form(n, j, w) == Residue{});
        factors[v] = form(n, n, w) * form(i, j, w).inverse(); // (2)

        const Residue c = -two * factors[v]; // 1 for the multiple of n in (4)
        CHECK(n[0] * n[0] == c * i[0] * j[0]);
        CHECK(n[1] * n[1] == c * i[1] * j[1]);
        CHECK(two * n[2] * n[0] == c * (i[2] * j[0] + j[2] * i[0]));
        CHECK(two * n[2] * n[1] == c * (i[2] * j[1] + j[2] * i[1]));

        const Vector line = times(random.next(), cross(view.point(a), view.point(end)));
        lines[v] = {dot(line, i), dot(line, j), scale * dot(line, view.point({}))};
        CHECK(dot(lines[v], Vector{a[0], a[1], {1}}) == Residue{});
        seen_normals[v] = {dot(line, n), {}, {}};
    }
    CHECK(factors[0] == factors[1]);
    CHECK(factors[0] == factors[2]);

    // Lines through one point: their first two entries determine the constants.
    const auto minor = [&](std::size_t u, std::size_t v) {
        return lines[u][0] * lines[v][1] - lines[u][1] * lines[v][0];
    };
    const Vector kappa{minor(1, 2), minor(2, 0), minor(0, 1)};
    Vector sum{};
    Residue f;
    for (std::size_t v = 0; v < 3; ++v) {
        sum = plus(sum, times(kappa[v], lines[v]));
        f = f + kappa[v] * seen_normals[v][0];
    }
    CHECK(sum == Vector{});
    CHECK(f == Residue{}); // (3)
}

namespace {

/// The part of degree two of (1 + of_divisors h)^count / (1 + h)^3, times h^power.
long on_diagonal(long of_divisors, long count, long power) {
    const long first = count * of_divisors;
    const long second = count * (count - 1) / 2 * of_divisors * of_divisors;
    if (power == 0) return second - 3 * first + 6;
    return power == 1 ? first - 3 : 1;
}

} // namespace

TEST_CASE("intersection numbers: 21 pairs of circular points, 66 solutions with three views") {
    const long pairs = 16 * 6 - on_diagonal(4, 4, 0);
    CHECK(pairs * 8 / 2 == 168);

    const long degree = 8 * 3 - on_diagonal(4, 3, 1); // of the curve, in each factor
    CHECK(degree == 15);
    // The curve meets the divisor of pairs of equal points 18 times: (M - E)^4 = 42.
    CHECK(4 * degree - pairs == 18);
    const long poles = 3 * 2 * (8 - 1) * 2;
    // On flags, with the powers of zeta as in section 3.
    const auto on_flags = [](long h) { return 6 + 3 * h * -3 + 3 * h * h; };
    CHECK(on_flags(4) == 18);
    CHECK(4 * (degree + degree) / 2 + poles - 2 * on_flags(3) == 2 * 66);
}
