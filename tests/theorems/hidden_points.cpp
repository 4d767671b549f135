// Lemma R17 of proofs/relations.md by a second method: how often the forms T_2 and F_1 vanish along
// arcs to a random point below e, to one of Y_2 and to one with n_2 = 0, and that they vanish at
// what cameras see. Modulo q = 2^61 - 1, as power series in the parameter of the arc.
#include "checker/algebra/modular.h"

#include <doctest/doctest.h>

#include <array>
#include <random>

using checker::Residue;

namespace {
/// A power series modulo its fifth power.
struct Series {
    std::array<Residue, 5> at{};

    /// The exponent of its first term; 5 if it has none.
    std::size_t order() const {
        std::size_t n = 0;
        while (n < at.size() && at[n] == Residue{0})
            ++n;
        return n;
    }
};

Series operator+(Series a, const Series& b) {
    for (std::size_t n = 0; n < a.at.size(); ++n)
        a.at[n] = a.at[n] + b.at[n];
    return a;
}

Series operator-(Series a, const Series& b) {
    for (std::size_t n = 0; n < a.at.size(); ++n)
        a.at[n] = a.at[n] - b.at[n];
    return a;
}

Series operator*(const Series& a, const Series& b) {
    Series product;
    for (std::size_t n = 0; n < a.at.size(); ++n)
        for (std::size_t m = 0; n + m < a.at.size(); ++m)
            product.at[n + m] = product.at[n + m] + a.at[n] * b.at[m];
    return product;
}

using Vector = std::array<Series, 3>;
using Quaternion = std::array<Series, 4>;
using Matrix = std::array<Vector, 3>;

Series dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector times(const Series& s, const Vector& a) {
    return {s * a[0], s * a[1], s * a[2]};
}

Vector plus(const Vector& a, const Vector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Matrix transposed(const Matrix& m) {
    Matrix result;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            result[i][j] = m[j][i];
    return result;
}

Vector times(const Matrix& m, const Vector& a) {
    return {dot(m[0], a), dot(m[1], a), dot(m[2], a)};
}

Series norm(const Quaternion& q) {
    return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
}

/// The matrix of quadratic forms of a quaternion.
Matrix rotation(const Quaternion& q) {
    const auto& [w, x, y, z] = q;
    const Series wx = w * x, wy = w * y, wz = w * z, xy = x * y, xz = x * z, yz = y * z;
    const Series ww = w * w, xx = x * x, yy = y * y, zz = z * z;
    return {{{ww + xx - yy - zz, xy + xy - wz - wz, xz + xz + wy + wy},
             {xy + xy + wz + wz, ww - xx + yy - zz, yz + yz - wx - wx},
             {xz + xz - wy - wy, yz + yz + wx + wx, ww - xx - yy + zz}}};
}

Quaternion product(const Quaternion& p, const Quaternion& q) {
    return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
            p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
            p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
            p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}

/// Cameras [R_v | s_v t_v], v = 2, 3, along an arc.
struct Arc {
    std::array<Quaternion, 2> rotations{};
    std::array<Vector, 2> epipoles{};
    std::array<Series, 2> scales{};
};

/// Random numbers, and arcs.
class Random {
public:
    explicit Random(std::uint64_t seed) : random_(seed) {}

    Series constant() { return {{Residue{random_() % checker::modulus}}}; }
    Vector vector() { return {constant(), constant(), constant()}; }
    Quaternion quaternion() { return {constant(), constant(), constant(), constant()}; }

    /// A random multiple of the parameter.
    Series small() {
        Series result;
        result.at[1] = Residue{random_() % checker::modulus};
        return result;
    }
    Vector moved(const Vector& a) { return plus(a, {small(), small(), small()}); }
    Quaternion moved(Quaternion q) {
        for (Series& coordinate : q)
            coordinate = coordinate + small();
        return q;
    }

    /// A quaternion of norm 0: with q = 3 modulo 4, r has the root r^((q + 1) / 4), or none.
    Quaternion isotropic() {
        while (true) {
            Quaternion result = quaternion();
            result[3] = {};
            const Residue square = Residue{0} - norm(result).at[0];
            Residue root = square;
            for (int n = 0; n < 59; ++n) // (q + 1) / 4 = 2^59
                root = root * root;
            result[3].at[0] = root;
            if (root * root == square) return result;
        }
    }

    /// An arc of random cameras.
    Arc arc() {
        return {.rotations = {quaternion(), quaternion()},
                .epipoles = {vector(), vector()},
                .scales = {constant(), constant()}};
    }

private:
    std::mt19937_64 random_;
};

/// A nonzero column of a matrix of rank 1.
Vector column(const Matrix& m) {
    return transposed(m)[0];
}

/// Image points and lines.
struct Data {
    Vector x1, x2, x3, l1, l2, l3;
};

/// T, T_2 and F_1 along an arc, before any division.
std::array<Series, 3> forms(const Arc& arc, const Data& data) {
    const Matrix r2 = rotation(arc.rotations[0]), r3 = rotation(arc.rotations[1]);
    const Series n2 = norm(arc.rotations[0]), n3 = norm(arc.rotations[1]);
    const auto& [t2, t3] = arc.epipoles;
    const auto& [s2, s3] = arc.scales;
    const auto& [x1, x2, x3, l1, l2, l3] = data;
    const Vector d2 = times(transposed(r2), x2), d3 = times(transposed(r3), x3);
    const Vector f2 = times(transposed(r2), cross(x2, t2));
    const Vector f3 = times(transposed(r3), cross(x3, t3));
    const Vector m3 = times(transposed(r3), l3);
    return {s3 * dot(l2, times(r2, x1)) * dot(l3, t3) - s2 * dot(l2, t2) * dot(l3, times(r3, x1)),
            s3 * n2 * dot(l3, t3) * dot(l1, d2) - s2 * dot(cross(l1, m3), f2),
            n3 * s2 * dot(f2, d3) + n2 * s3 * dot(f3, d2)};
}

/// Their orders at random data.
std::array<std::size_t, 3> orders(const Arc& arc, Random& random) {
    const Data data{random.vector(), random.vector(), random.vector(),
                    random.vector(), random.vector(), random.vector()};
    const auto [t, t_2, f_1] = forms(arc, data);
    return {t.order(), t_2.order(), f_1.order()};
}

using Orders = std::array<std::size_t, 3>;
} // namespace

TEST_CASE("Lemma R17: the orders of the forms along e, Y_2 and n_2 = 0") {
    Random random(17);
    CHECK(orders(random.arc(), random) == Orders{0, 0, 0});

    // Below e: n_2 = n_3 = 0, t_v = u_v, v_2 = v_3 and s_2 = s_3. With y_2 once, and y_2 y_3 once,
    // T_2 has order 1 + 1, and F_1 2 + 2.
    Arc arc = random.arc();
    const Quaternion isotropic = random.isotropic();
    const Quaternion other = product(random.quaternion(), isotropic); // R_3 = S R_2
    arc.epipoles = {random.moved(column(rotation(isotropic))),
                    random.moved(column(rotation(other)))};
    arc.rotations = {random.moved(isotropic), random.moved(other)};
    arc.scales[1] = arc.scales[0] + random.small();
    CHECK(orders(arc, random) == Orders{1, 2, 4});

    // Y_2: n_2 = 0, t_2 = u_2. T_2 and F_1 have order 1, that of y_2.
    Arc exceptional = random.arc();
    exceptional.rotations[0] = arc.rotations[0];
    exceptional.epipoles[0] = arc.epipoles[0];
    CHECK(orders(exceptional, random) == Orders{0, 1, 1});

    // n_2 = 0 elsewhere.
    Arc degenerate = random.arc();
    degenerate.rotations[0] = arc.rotations[0];
    CHECK(orders(degenerate, random) == Orders{0, 0, 0});
}

TEST_CASE("Lemma R17: the forms vanish at what cameras see") {
    Random random(18);
    const Arc arc = random.arc();
    const Vector x1 = random.vector(); // of the point (x1, 1), which all cameras see
    const auto seen = [&](std::size_t v) {
        return plus(times(rotation(arc.rotations[v]), x1), times(arc.scales[v], arc.epipoles[v]));
    };
    const Vector x2 = seen(0), x3 = seen(1);
    const auto line = [&](const Vector& point) { return cross(point, random.vector()); };
    const Data data{x1, x2, x3, line(x1), line(x2), line(x3)};
    for (const Series& form : forms(arc, data))
        CHECK(form.order() == 5);
}
