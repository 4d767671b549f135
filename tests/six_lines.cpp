// Six lines through a point (proofs/upper_bounds.md, section 8): the trilinear forms of three
// rotations lie on a quartic hypersurface, over the integers.
#include "checker/degree_system.h"
#include "prover/degree/degree.h"
#include "prover/geometry/camera.h"

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
        form[n] = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                  m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                  m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
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
    const DegreeRun run = compute_degree(4, {}); // Pabcdef/Pabcdef/Pabcdef + a/P/Pa
    REQUIRE(run.certificate);
    REQUIRE(run.certificate->degree() == 64);
    checker::System system; // two lines through the image of the point in each view
    for (unsigned view = 0; view < 3; ++view) {
        const auto x = run.certificate->images[0].views[view].point.value();
        const checker::Image point{x[0], x[1], x[2]};
        system.sights.push_back({view, checker::cross(point, {1, 0, 0})});
        system.sights.push_back({view, checker::cross(point, {0, 1, 0})});
    }
    std::vector<std::pair<std::array<Complex, 8>, int>> forms; // how many solutions have each
    const auto count = [&](const checker::Coordinates<Complex>& cameras) {
        checker::Scene<Complex> scene;
        checker::look(system, cameras, scene);
        std::array<Complex, 8> form;
        for (std::size_t n = 0; n < 8; ++n)
            form[n] =
                checker::dot(scene.ray(n >> 2 & 1),
                             checker::cross(scene.ray(2 + (n >> 1 & 1)), scene.ray(4 + (n & 1))));
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
    for (const ApproximateSolution& solution : run.certificate->solutions) {
        checker::Coordinates<Complex> cameras, conjugate;
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
