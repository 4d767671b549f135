// Six and five lines through a point (proofs/lines_through_a_point.md): the trilinear
// forms of three rotations lie on a quartic hypersurface, over the integers; and what determines
// the rotations of a form.
#include "checker/degrees/evaluation.h"
#include "prover/minimal/placement.h"
#include "prover/three_views/degree.h"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

using namespace plprove;

namespace {

mpz_class determinant(const std::array<std::array<mpz_class, 3>, 3>& m) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// A trilinear form on pairs: entry 4 i + 2 j + k is the coefficient of u_i v_j w_k.
using Form = std::array<mpz_class, 8>;

/// det(M_1^T u, M_2^T v, M_3^T w), M_i being the first two rows of a multiple of a rotation.
Form form_of(const std::array<Matrix3, 3>& rotations) {
    Form form;
    for (std::size_t n = 0; n < 8; ++n) {
        std::array<std::array<mpz_class, 3>, 3> m;
        for (std::size_t c = 0; c < 3; ++c) {
            m[0][c] = rotations[0][n >> 2 & 1][c];
            m[1][c] = rotations[1][n >> 1 & 1][c];
            m[2][c] = rotations[2][n & 1][c];
        }
        form[n] = determinant(m);
    }
    return form;
}

/// The polarized determinant of two slices u = e_i, u = e_j of two forms.
mpz_class mixed(const Form& a, std::size_t i, const Form& b, std::size_t j) {
    return a[4 * i] * b[4 * j + 3] + a[4 * i + 3] * b[4 * j] - a[4 * i + 1] * b[4 * j + 2] -
           a[4 * i + 2] * b[4 * j + 1];
}

/// Half the derivative of the hyperdeterminant mixed(t,0,t,1)^2 - mixed(t,0,t,0) mixed(t,1,t,1)
/// in the direction of t with each argument turned by a right angle.
mpz_class quartic(const Form& t) {
    Form s;
    for (std::size_t n = 0; n < 8; ++n) {
        const bool odd = (n >> 2 ^ n >> 1 ^ n) & 1;
        s[7 - n] = odd ? mpz_class(-t[n]) : t[n];
    }
    return mixed(t, 0, t, 1) * (mixed(s, 0, t, 1) + mixed(t, 0, s, 1)) -
           mixed(s, 0, t, 0) * mixed(t, 1, t, 1) - mixed(t, 0, t, 0) * mixed(s, 1, t, 1);
}

} // namespace

TEST_CASE("six lines through a point: forms of three rotations are on a quartic, others are not") {
    std::mt19937_64 random(7);
    const auto small = [&] { return static_cast<std::int64_t>(random() % 19) - 9; };
    for (int trial = 0; trial < 100; ++trial) {
        std::array<Matrix3, 3> rotations{};
        for (Matrix3& rotation : rotations)
            rotation = rotation_matrix({10, small(), small(), small()});
        Form form = form_of(rotations);
        CHECK(quartic(form) == 0);
        form[random() % 8] += 1;
        CHECK(quartic(form) != 0);
    }
}

TEST_CASE("six lines through a point: the quartic in terms of a sum of two products") {
    // a1 a2 a3 + b1 b2 b3: the product of det(a_i, b_i), times the difference of the products of
    // the squares a_i . a_i and b_i . b_i.
    const std::array<std::array<std::int64_t, 2>, 3> a{{{3, -1}, {2, 5}, {-4, 1}}};
    const std::array<std::array<std::int64_t, 2>, 3> b{{{1, 7}, {-2, 3}, {6, 5}}};
    Form form;
    for (std::size_t n = 0; n < 8; ++n)
        form[n] = a[0][n >> 2 & 1] * a[1][n >> 1 & 1] * a[2][n & 1] +
                  b[0][n >> 2 & 1] * b[1][n >> 1 & 1] * b[2][n & 1];
    mpz_class determinants = 1;
    mpz_class squares_a = 1;
    mpz_class squares_b = 1;
    for (std::size_t v = 0; v < 3; ++v) {
        determinants *= a[v][0] * b[v][1] - a[v][1] * b[v][0];
        squares_a *= a[v][0] * a[v][0] + a[v][1] * a[v][1];
        squares_b *= b[v][0] * b[v][0] + b[v][1] * b[v][1];
    }
    CHECK(quartic(form) == determinants * (squares_a - squares_b));
}

TEST_CASE("six lines through a point: the 64 certified solutions have four forms, 16 each") {
    using Complex = std::complex<double>;
    const DegreeRun run = compute_degree(4, {.at_least = 64}); // Pabcdef/Pabcdef/Pabcdef + a/P/Pa
    REQUIRE(run.certificate);
    REQUIRE(run.certificate->degree() == 64);
    checker::CameraSystem system; // two lines through the image of the point in each view
    for (unsigned view = 0; view < 3; ++view) {
        const auto x = run.certificate->images[0].views[view].point.value();
        const checker::Image point{x[0], x[1], x[2]};
        checker::add_vector(system, view, checker::cross(point, {1, 0, 0}));
        checker::add_vector(system, view, checker::cross(point, {0, 1, 0}));
    }
    std::vector<std::pair<std::array<Complex, 8>, int>> forms; // how many solutions have each
    const auto count = [&](const checker::CameraCoordinates<Complex>& cameras) {
        checker::BackProjections<Complex> space;
        checker::back_project(system, cameras, space);
        const auto normal = [&](std::size_t place) { return space.vectors[place].vector; };
        std::array<Complex, 8> form;
        for (std::size_t n = 0; n < 8; ++n)
            form[n] = checker::dot(normal(n >> 2 & 1),
                                   checker::cross(normal(2 + (n >> 1 & 1)), normal(4 + (n & 1))));
        for (std::size_t n = 8; n-- > 0;)
            form[n] /= form[0];
        const auto same = [&](const auto& known) {
            double apart = 0; // the certificate has three or four digits
            for (std::size_t n = 0; n < 8; ++n)
                apart = std::max(apart, std::abs(form[n] - known.first[n]) /
                                            (0.1 + std::abs(known.first[n])));
            return apart < 0.15;
        };
        const auto known = std::ranges::find_if(forms, same);
        if (known == forms.end())
            forms.emplace_back(form, 1);
        else
            ++known->second;
    };
    for (const StartingValues& solution : run.certificate->solutions) {
        checker::CameraCoordinates<Complex> cameras, conjugate;
        for (std::size_t k = 0; k < cameras.size(); ++k) {
            const auto value = [&](std::size_t i) {
                return std::ldexp(static_cast<double>(solution.values[i]), -solution.bits);
            };
            cameras[k] =
                solution.real ? Complex(value(k)) : Complex(value(2 * k), value(2 * k + 1));
            conjugate[k] = std::conj(cameras[k]);
        }
        count(cameras);
        if (!solution.real) count(conjugate);
    }
    REQUIRE(forms.size() == 4);
    for (const auto& [form, times] : forms)
        CHECK(times == 16);
}

namespace {

using Spinor = std::array<mpz_class, 2>;
using Matrix2 = std::array<std::array<mpz_class, 2>, 2>;

mpz_class bracket(const Spinor& a, const Spinor& b) {
    return a[0] * b[1] - a[1] * b[0];
}

/// The vector of C^3 of the symmetric product of two spinors, twice.
std::array<mpz_class, 3> product(const Spinor& a, const Spinor& b) {
    return {2 * a[0] * b[0], a[0] * b[1] + a[1] * b[0], 2 * a[1] * b[1]};
}

/// The form on S^2 C^2 that takes the squares of two spinors to the square of their bracket.
mpz_class scalar(const std::array<mpz_class, 3>& x, const std::array<mpz_class, 3>& y) {
    return x[0] * y[2] - 2 * x[1] * y[1] + x[2] * y[0];
}

/// Spinors of three views, each a basis of determinant 1, and their brackets.
struct Frames {
    std::array<std::array<Spinor, 2>, 3> psi;
    Matrix2 a, b, c;

    explicit Frames(std::mt19937_64& random) {
        const auto small = [&] { return static_cast<long>(random() % 9) - 4; };
        for (auto& [first, second] : psi) {
            first = {1, 0};
            second = {0, 1};
            for (int step = 0; step < 4; ++step) {
                const long factor = small();
                for (std::size_t k = 0; k < 2; ++k)
                    (step % 2 == 0 ? first : second)[k] +=
                        factor * (step % 2 == 0 ? second : first)[k];
            }
        }
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t j = 0; j < 2; ++j) {
                a[i][j] = bracket(psi[0][i], psi[1][j]);
                b[i][j] = bracket(psi[1][i], psi[2][j]);
                c[i][j] = bracket(psi[2][i], psi[0][j]);
            }
    }

    bool has_zeros() const {
        const auto any = [](const Matrix2& m) {
            return m[0][0] == 0 || m[0][1] == 0 || m[1][0] == 0 || m[1][1] == 0;
        };
        return any(a) || any(b) || any(c);
    }
};

} // namespace

TEST_CASE("five lines through a point: brackets of spinors") {
    std::mt19937_64 random(11);
    for (int trial = 0; trial < 50; ++trial) {
        const Frames f(random);
        Form form;
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t j = 0; j < 2; ++j)
                for (std::size_t k = 0; k < 2; ++k) {
                    CHECK(f.c[k][i] == f.a[i][0] * f.b[1][k] - f.a[i][1] * f.b[0][k]);
                    CHECK(f.a[i][j] == f.b[j][0] * f.c[1][i] - f.b[j][1] * f.c[0][i]);
                    CHECK(f.b[j][k] == f.c[k][0] * f.a[1][j] - f.c[k][1] * f.a[0][j]);
                    form[4 * i + 2 * j + k] = f.a[i][j] * f.b[j][k] * f.c[k][i];
                    // Each vector is twice a square; the sign depends on the order of coordinates.
                    CHECK(determinant(
                              {product(f.psi[0][i], f.psi[0][i]), product(f.psi[1][j], f.psi[1][j]),
                               product(f.psi[2][k], f.psi[2][k])}) == -8 * form[4 * i + 2 * j + k]);
                }
        CHECK(form[0] * form[3] * form[5] * form[6] == form[1] * form[2] * form[4] * form[7]);
    }
}

TEST_CASE("five lines through a point: a quadratic equation for the rotations of a form") {
    std::mt19937_64 random(12);
    int tried = 0;
    while (tried < 50) {
        const Frames f(random);
        if (f.has_zeros()) continue;
        ++tried;
        const auto ratio = [](const Matrix2& m) {
            return mpq_class(mpq_class(m[0][0] * m[1][1]) / mpq_class(m[0][1] * m[1][0]));
        };
        const mpq_class xa = ratio(f.a), xb = ratio(f.b), xc = ratio(f.c);
        CHECK(mpq_class(f.a[0][0] * f.a[1][1]) == xa / (xa - 1));
        CHECK(mpq_class(f.a[0][1] * f.a[1][0]) == 1 / (xa - 1));
        const mpq_class h(f.a[0][0] * f.a[1][0] * f.b[1][0] * f.b[1][1]);
        const mpq_class sum = xc / (xc - 1) + (xa + xb) / ((xa - 1) * (xb - 1));
        const mpq_class norm = xa * xb / ((xa - 1) * (xa - 1) * (xb - 1) * (xb - 1));
        CHECK(h * h - sum * h + norm == 0);
    }
}

TEST_CASE("five lines through a point: the condition that two points put on two views") {
    std::mt19937_64 random(13);
    const auto small = [&] { return static_cast<long>(random() % 9) - 4; };
    for (int trial = 0; trial < 50; ++trial) {
        const Frames f(random);
        const auto& [u, v] = f.psi[1]; // view 2
        const auto& [w, z] = f.psi[2]; // view 3
        const auto combine = [](const auto& frame, long a, long c, long d) {
            std::array<mpz_class, 3> x;
            for (std::size_t k = 0; k < 3; ++k)
                x[k] = a * product(frame[0], frame[0])[k] + c * product(frame[0], frame[1])[k] +
                       d * product(frame[1], frame[1])[k];
            return x;
        };
        const long a2 = small(), c2 = small(), d2 = small();
        const long a3 = small(), c3 = small(), d3 = small();
        const auto y2 = combine(f.psi[1], a2, c2, d2), n2 = combine(f.psi[1], a2, 0, -d2);
        const auto y3 = combine(f.psi[2], a3, c3, d3), n3 = combine(f.psi[2], a3, 0, -d3);
        // n is orthogonal to y and to the ray to the common point, the product of the basis.
        CHECK(scalar(n2, product(u, v)) == 0);
        CHECK(scalar(n2, y2) == 0);
        CHECK(scalar(n3, product(w, z)) == 0);
        CHECK(scalar(n3, y3) == 0);
        const auto& b = f.b;
        const mpz_class phi =
            a2 * (a3 * b[0][0] * b[0][0] + c3 * b[0][0] * b[0][1] + d3 * b[0][1] * b[0][1]) -
            d2 * (a3 * b[1][0] * b[1][0] + c3 * b[1][0] * b[1][1] + d3 * b[1][1] * b[1][1]);
        const mpz_class chi =
            a3 * (a2 * b[0][0] * b[0][0] + c2 * b[0][0] * b[1][0] + d2 * b[1][0] * b[1][0]) -
            d3 * (a2 * b[0][1] * b[0][1] + c2 * b[0][1] * b[1][1] + d2 * b[1][1] * b[1][1]);
        CHECK(scalar(n2, y3) == 4 * phi);
        CHECK(scalar(n3, y2) == 4 * chi);
    }
}
