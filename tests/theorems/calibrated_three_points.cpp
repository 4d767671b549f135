// The numbers of proofs/calibrated_three_points.md, in four views and in three, and its lemmas by
// examples in complex numbers.
#include "tests/theorems/complex_vectors.h"

#include <cstdint>
#include <doctest/doctest.h>

namespace {

// Sections 3 to 7: curves E for a point i, by the number k of views at e_i.

std::int64_t power(std::int64_t base, unsigned exponent) {
    return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

std::int64_t binomial(unsigned n, unsigned k) {
    return k == 0 ? 1 : binomial(n, k - 1) * (n - k + 1) / k;
}

struct Surface {
    unsigned views;

    std::int64_t h_h() const { return power(2, 3 * (views - 1)); }
    std::int64_t h_d() const { return power(4, views); }
    /// Points over a special triangle of i with just k views at e_i.
    std::int64_t points(unsigned k) const {
        return binomial(views, k) * power(2, k) * power(4, views - k) / 2;
    }
    static std::int64_t e_e(unsigned k) { return -power(2, k - 1); }
    /// The sum of E D over these.
    std::int64_t e_d(unsigned k) const { return binomial(views, k) * power(2, views); }
    std::int64_t d_d() const {
        std::int64_t sum = 4 * h_d() - 3 * e_d(1); // e_d(1) points where D meets a D_v
        for (unsigned k = 2; k <= views; ++k)
            sum -= 2 * 3 * e_d(k);
        return sum;
    }
    /// How many coordinates of T are divided by the equation of E.
    static unsigned divided(bool pinned, unsigned k) { return pinned ? k : k - 1; }
};

/// The integral of c_2(T - F'), for a pin of one of the points.
std::int64_t two_conditions(const Surface& s) {
    std::int64_t sum = 11 * s.h_h() - 6 * s.h_d() + s.d_d();
    for (const unsigned i : {1U, 2U, 3U})
        for (unsigned k = 2; k <= s.views; ++k) {
            const unsigned j = Surface::divided(i == 3, k);
            sum += j * s.e_d(k) + binomial(j, 2) * Surface::e_e(k) * s.points(k);
        }
    return sum;
}

/// The integral of the product of c_1(T - F') for pins of the points p and q.
std::int64_t two_pins(const Surface& s, unsigned p, unsigned q) {
    std::int64_t sum = 16 * s.h_h() - 8 * s.h_d() + s.d_d();
    for (const unsigned i : {1U, 2U, 3U})
        for (unsigned k = 2; k <= s.views; ++k) {
            const unsigned jp = Surface::divided(i == p, k), jq = Surface::divided(i == q, k);
            sum += (jp + jq) * s.e_d(k) + std::int64_t{jp} * jq * Surface::e_e(k) * s.points(k);
        }
    return sum;
}

// Examples.

using namespace complex_vectors;

double size(const Vector& a) {
    return std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]);
}

using Images = std::array<Vector, 3>;

/// A triangle in front of a camera: section 1.
struct Triangle {
    Vector a, b, n;
    Triangle(const Images& x, const Vector& l)
        : a(l[0] * x[0] - l[2] * x[2]), b(l[1] * x[1] - l[2] * x[2]), n(cross(a, b)) {}
};

/// One in the plane of all p with w . p = 1, for an isotropic w.
Vector flat(const Images& x, const Vector& w) {
    return {1.0 / dot(w, x[0]), 1.0 / dot(w, x[1]), 1.0 / dot(w, x[2])};
}

/// The isotropic vector of a line in the isotropic cone.
Vector isotropic(Complex z) {
    return {1.0 - z * z, i_unit * (1.0 + z * z), 2.0 * z};
}

bool vanishes(Complex x, double bound = 1e-9) {
    return std::abs(x) < bound;
}

} // namespace

TEST_CASE("three points and a pin in four views: 2432 zeros, of which 1728 may be solutions") {
    const Surface four{4};
    CHECK(four.h_h() == 512);
    CHECK(four.h_d() == 256);
    CHECK(four.d_d() == -224);
    CHECK(two_conditions(four) == 2432);
    // Lemma B9: N has simple zeros where its view is at some e_i.
    std::int64_t zeros_of_n = 0;
    for (unsigned k = 1; k <= 4; ++k)
        zeros_of_n += 3 * binomial(3, k - 1) * 16;
    const std::int64_t on_flat = 4 * (2 * four.h_d() - zeros_of_n);
    CHECK(on_flat == 512);
    const std::int64_t on_conics = 2 * four.e_d(2); // Lemma B10
    CHECK(on_conics == 192);
    CHECK(two_conditions(four) - on_flat - on_conics == 1728);
}

TEST_CASE("the same surface in three views gives the degrees of two pins: 312 and 224") {
    const Surface three{3};
    CHECK(three.d_d() == -8);
    CHECK(two_pins(three, 1, 3) == 312);
    CHECK(two_pins(three, 3, 3) == 248);
    CHECK(two_pins(three, 3, 3) - (three.points(1) - three.e_d(1)) == 224);
}

TEST_CASE("points over special triangles make up the degree over the plane of triangles; the genus "
          "of D fits") {
    for (const Surface s : {Surface{3}, Surface{4}, Surface{5}}) {
        std::int64_t degree = 0, of_d = 0, canonical = (3 * s.views - 6) * s.h_d();
        for (unsigned k = 0; k <= s.views; ++k) {
            degree += s.points(k) * power(2, k);
            of_d += s.e_d(k);
            if (k >= 2) canonical += 3 * (2 - std::int64_t{k}) * s.e_d(k);
        }
        CHECK(degree == 4 * s.h_h());
        CHECK(of_d == s.h_d());
        // D is the fibre product of maps of degree 4 between projective lines.
        CHECK(s.d_d() + canonical ==
              -2 * s.h_d() + 6 * std::int64_t{s.views} * power(4, s.views - 1));
    }
}

TEST_CASE("cameras that see three points and a pin give a zero") {
    Numbers numbers(1);
    for (int round = 0; round < 5; ++round) {
        const Images points{numbers.real_vector(), numbers.real_vector(), numbers.real_vector()};
        const Vector direction = numbers.real_vector();
        std::array<Vector, 4> rows;
        Triangle first({}, {});
        for (Vector& row : rows) {
            Vector u = numbers.real_vector(), v = numbers.real_vector();
            u = 1.0 / std::sqrt(dot(u, u)) * u;
            v = v - dot(u, v) * u;
            v = 1.0 / std::sqrt(dot(v, v)) * v;
            const Images rotation{u, v, cross(u, v)};
            const Vector t = numbers.real_vector();
            const auto turned = [&](const Vector& p) {
                return Vector{dot(rotation[0], p), dot(rotation[1], p), dot(rotation[2], p)};
            };
            Images x;
            Vector lambda;
            for (std::size_t i = 0; i < 3; ++i) {
                const Vector seen = turned(points[i]) + t;
                lambda[i] = std::sqrt(dot(seen, seen));
                x[i] = 1.0 / lambda[i] * seen;
            }
            const Triangle triangle(x, lambda);
            if (&row == rows.data()) first = triangle;
            CHECK(vanishes(dot(triangle.a, triangle.a) - dot(first.a, first.a)));
            CHECK(vanishes(dot(triangle.a, triangle.b) - dot(first.a, first.b)));
            CHECK(vanishes(dot(triangle.b, triangle.b) - dot(first.b, first.b)));
            const Vector y = cross(x[2], turned(direction));
            row = {dot(y, triangle.a), dot(y, triangle.b), dot(y, triangle.n)};
        }
        CHECK(vanishes(dot(rows[0], cross(rows[1], rows[2]))));
        CHECK(vanishes(dot(rows[1], cross(rows[2], rows[3]))));
        CHECK(size(cross(rows[0], rows[1])) > 1e-9);
    }
}

TEST_CASE("the normal of a flat triangle is a combination of its sides, by (4)") {
    Numbers numbers(2);
    for (int round = 0; round < 5; ++round) {
        const Images x{numbers.unit_vector(), numbers.unit_vector(), numbers.unit_vector()};
        const Vector lambda = flat(x, isotropic(numbers.complex()));
        const Triangle triangle(x, lambda);
        const auto& [a, b, n] = triangle;
        CHECK(vanishes(dot(n, n) / (1 + size(n) * size(n))));
        const Complex u = std::sqrt(dot(a, a)), v = dot(a, b) / u;
        CHECK(vanishes((v * v - dot(b, b)) / (1.0 + std::abs(v * v))));
        const Vector r = v * a - u * b;
        const double plus = size(n - i_unit * r), minus = size(n + i_unit * r);
        CHECK(std::min(plus, minus) < 1e-9 * size(n));
        CHECK(std::max(plus, minus) > size(n));
        // The same vector in terms of all three sides.
        const Vector w{v, -u, u - v};
        CHECK(size(r - (w[0] * lambda[0] * x[0] + w[1] * lambda[1] * x[1] +
                        w[2] * lambda[2] * x[2])) < 1e-9 * (1 + size(n)));
        const Vector third = lambda[0] * x[0] - lambda[1] * x[1];
        CHECK(vanishes((dot(third, third) - w[2] * w[2]) / (1.0 + std::abs(w[2] * w[2]))));
        // Near it F' has a form without poles: with C = 1 the vector f of section 8 is finite.
        const auto f_near = [&](double step) {
            Triangle near(x, lambda + Complex{step} * Vector{1.0, 0.5, 0.3 * i_unit});
            const Complex scale = (minus < plus ? -1.0 : 1.0) / std::sqrt(dot(near.b, near.b)) *
                                  (std::abs(v + std::sqrt(dot(b, b))) < std::abs(v) ? -1.0 : 1.0);
            const Vector p = scale * near.a, q = scale * near.b, m = cross(p, q);
            return 1.0 / dot(m, m) * (m - i_unit * (p - dot(p, q) * q));
        };
        const Vector f = f_near(1e-4), closer = f_near(5e-5);
        CHECK(size(f - closer) < 0.1 * size(f));
    }
}

TEST_CASE("near e_i flat triangles have two branches with opposite signs, at sigma = t^2 / 4") {
    Numbers numbers(3);
    for (int round = 0; round < 5; ++round) {
        const Images x{numbers.unit_vector(), numbers.unit_vector(), numbers.unit_vector()};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
            // The two z with isotropic(z) orthogonal to x_i.
            const Complex c0 = x[i][0] + i_unit * x[i][1], c1 = 2.0 * x[i][2],
                          c2 = i_unit * x[i][1] - x[i][0];
            const Complex root = std::sqrt(c1 * c1 - 4.0 * c0 * c2);
            std::array<Complex, 2> value, place;
            for (std::size_t branch = 0; branch < 2; ++branch) {
                const Complex z = ((branch == 0 ? root : -root) - c1) / (2.0 * c2);
                CHECK(vanishes(dot(isotropic(z), x[i])));
                Vector lambda = flat(x, isotropic(z + 1e-5));
                const auto side = [&](std::size_t p, std::size_t q) {
                    const Vector d = lambda[p] * x[p] - lambda[q] * x[q];
                    return dot(d, d);
                };
                lambda = 1.0 / std::sqrt(side(i, j)) * lambda;
                if (std::abs(lambda[i] + 1.0) < 0.5) lambda = Complex{-1} * lambda;
                CHECK(vanishes(lambda[i] - 1.0, 1e-3));
                const Complex t = side(i, j) - side(i, l);
                CHECK(vanishes(side(j, l) / (t * t) - 0.25, 1e-3));
                place[branch] = lambda[j] / lambda[l];
                // zeta modulo x_i is an eigenvector of lambda_i x_i times.
                Vector zeta = lambda[j] * x[j] - lambda[l] * x[l];
                zeta = zeta - dot(zeta, x[i]) * x[i];
                const Vector image = lambda[i] * cross(x[i], zeta);
                const std::size_t big = std::abs(zeta[0]) > std::abs(zeta[1]) ? 0 : 1;
                value[branch] = image[big] / zeta[big];
                CHECK(size(image - value[branch] * zeta) < 1e-3 * size(zeta));
                CHECK(vanishes(value[branch] * value[branch] + 1.0, 1e-3));
            }
            CHECK(vanishes(value[0] + value[1], 1e-3));
            CHECK(std::abs(place[0] - place[1]) > 1e-3); // beta is not 1/4
        }
    }
}

TEST_CASE("the rows of views at e_1 differ by (10), at e_3 they are those of (9)") {
    Numbers numbers(4);
    constexpr double small = 1e-6;
    for (int round = 0; round < 5; ++round) {
        const Images x{numbers.unit_vector(), numbers.unit_vector(), numbers.unit_vector()};
        const Vector y = cross(x[2], numbers.complex_vector());
        const Complex beta = numbers.complex(), gamma = numbers.complex();
        const Complex first = numbers.complex(), second = numbers.complex();
        const auto part = [](const Vector& p, const Vector& axis, Complex sign) {
            const Vector flat_part = p - dot(p, axis) * axis; // half of it, and half of its turn
            return 0.5 * (flat_part - sign * i_unit * cross(axis, flat_part));
        };
        {
            const Triangle triangle(x, {1.0, small * first, small * second});
            const Vector zeta = 1.0 / small * triangle.b;
            const Complex mu = dot(y, x[0]);
            const Complex formula = ((beta + i_unit * gamma) * dot(y, part(zeta, x[0], 1)) +
                                     (beta - i_unit * gamma) * dot(y, part(zeta, x[0], -1))) /
                                        mu +
                                    beta * dot(triangle.a, triangle.b) / small;
            const Complex row = dot(y, beta * triangle.b + gamma * triangle.n) / small / mu;
            CHECK(vanishes(row - formula, 1e-3));
        }
        {
            const Triangle triangle(x, {small * first, small * second, 1.0});
            const Complex alpha = numbers.complex();
            const Vector w1 = first * x[0], w2 = second * x[1];
            Complex formula = 0;
            for (const double sign : {1.0, -1.0})
                formula += dot(y, (alpha + sign * i_unit * gamma) * part(w1, x[2], sign) +
                                      (beta - sign * i_unit * gamma) * part(w2, x[2], sign));
            const Complex row =
                dot(y, alpha * triangle.a + beta * triangle.b + gamma * triangle.n) / small;
            CHECK(vanishes(row - formula, 1e-3));
        }
    }
}
