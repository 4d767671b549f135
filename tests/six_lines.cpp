// Six lines through a point (proofs/upper_bounds.md, section 8): the trilinear forms of three
// rotations lie on a quartic hypersurface, over the integers.
#include "prover/geometry/camera.h"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <array>
#include <complex>
#include <fstream>
#include <random>
#include <sstream>
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
    std::ifstream file(CERTS_DIR "/degrees/small.plc");
    std::string line;
    while (std::getline(file, line) && !line.starts_with("degree 4 ")) {
    }
    REQUIRE(std::getline(file, line));
    REQUIRE(line.starts_with("image Pabcdef/Pabcdef/Pabcdef "));
    std::vector<Vector3> points; // the images of the point, by view
    std::istringstream words(line);
    for (std::string word; words >> word;) {
        if (word != "point") continue;
        Vector3& x = points.emplace_back();
        words >> x[0] >> x[1] >> x[2];
    }
    REQUIRE(points.size() == 3);

    using Vector = std::array<Complex, 3>;
    const auto normal = [&](std::size_t view, std::size_t i, const Vector& q) {
        const Vector3 l = cross(points[view], i == 0 ? Vector3{1, 0, 0} : Vector3{0, 1, 0});
        Vector n{}; // R^T l for the quaternion (1, q), by Rodrigues' formula
        Complex qq, ql;
        for (std::size_t k = 0; k < 3; ++k) {
            qq += q[k] * q[k];
            ql += q[k] * static_cast<double>(l[k]);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t a = (k + 1) % 3;
            const std::size_t b = (k + 2) % 3;
            const Complex turned =
                q[a] * static_cast<double>(l[b]) - q[b] * static_cast<double>(l[a]);
            n[k] = (1.0 - qq) * static_cast<double>(l[k]) + 2.0 * ql * q[k] - 2.0 * turned;
        }
        return n;
    };
    std::vector<std::pair<std::array<Complex, 8>, int>> forms; // how many solutions have each
    const auto count = [&](const std::array<Complex, 11>& cameras) {
        const std::array<Vector, 3> quaternions{
            Vector{}, {cameras[0], cameras[1], cameras[2]}, {cameras[3], cameras[4], cameras[5]}};
        std::array<Complex, 8> form;
        for (std::size_t n = 0; n < 8; ++n) {
            const Vector a = normal(0, n >> 2 & 1, quaternions[0]);
            const Vector b = normal(1, n >> 1 & 1, quaternions[1]);
            const Vector c = normal(2, n & 1, quaternions[2]);
            form[n] = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                      a[2] * (b[0] * c[1] - b[1] * c[0]);
        }
        for (std::size_t n = 8; n-- > 0;)
            form[n] /= form[0];
        for (auto& [known, times] : forms) {
            double apart = 0; // the certificate has three or four digits
            for (std::size_t n = 0; n < 8; ++n)
                apart = std::max(apart, std::abs(form[n] - known[n]) / (0.1 + std::abs(known[n])));
            if (apart < 0.15) {
                ++times;
                return;
            }
        }
        forms.emplace_back(form, 1);
    };
    while (std::getline(file, line) && !line.starts_with("degree")) {
        std::istringstream numbers(line);
        std::string kind;
        int bits = 0;
        numbers >> kind >> bits;
        std::array<Complex, 11> cameras;
        for (Complex& x : cameras) {
            double real = 0;
            double imaginary = 0;
            numbers >> real;
            if (kind == "pair") numbers >> imaginary;
            x = std::ldexp(1.0, -bits) * Complex(real, imaginary);
        }
        if (kind != "real" && kind != "pair") continue;
        count(cameras);
        if (kind == "real") continue;
        for (Complex& x : cameras)
            x = std::conj(x);
        count(cameras);
    }
    REQUIRE(forms.size() == 4);
    for (const auto& [form, times] : forms)
        CHECK(times == 16);
}
