// Three points on a line in three views (proofs/three_collinear_points.md): the tensor of cameras
// that are planted in space, its two camera triples, and the number of solutions of random images
// by an elimination that knows no tensor.
#include "tests/theorems/axis_frame.h"
#include "tests/theorems/small_elimination.h"

#include <doctest/doctest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

using namespace axis;

namespace {

/// The 12 numbers: at entry i of sigma and rho, those of the form phi_{i + 1}.
struct Tensor {
    Vector3 tau;
    std::array<Vector3, 3> sigma;
    Vector3 rho;
};

Vector3 value(const Form& phi, const FrameVector& v) {
    return {phi[0] * v.z[0][0] + phi[1] * v.z[0][1], phi[0] * v.z[1][0] + phi[1] * v.z[1][1],
            phi[0] * v.z[2][0] + phi[1] * v.z[2][1]};
}

Number wedge(const Vector3& a, const Vector3& b) {
    return det({{{1, 1, 1}, a, b}});
}

Vector3 unit(std::size_t v, Number factor) {
    Vector3 result{};
    result[v] = factor;
    return result;
}

Tensor tensor_of(const Plane& plane) {
    Tensor t;
    t.tau = cross(plane[0].w, plane[1].w);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3 a = value(phi(i), plane[0]), b = value(phi(i), plane[1]);
        t.rho[i] = wedge(a, b);
        for (std::size_t v = 0; v < 3; ++v)
            t.sigma[i][v] = -(wedge(unit(v, plane[0].w[v]), b) + wedge(a, unit(v, plane[1].w[v])));
    }
    return t;
}

Number product(const Vector3& a) {
    return a[0] * a[1] * a[2];
}

Number omega(const Vector3& z) {
    const Number sum = z[0] + z[1] + z[2];
    return sum * sum - Number(4) * (z[0] * z[1] + z[1] * z[2] + z[2] * z[0]);
}

/// A quadratic form by its coefficients, from the values at phi_1, phi_2 and their sum.
Vector3 from_values(const Vector3& at) {
    return {at[0], at[2] - at[0] - at[1], at[1]};
}

Number polar(const Vector3& x, const Vector3& y) {
    return x[1] * y[1] - Number(2) * (x[0] * y[2] + y[0] * x[2]);
}

/// The values of the first part of (3) at the three forms.
Vector3 first_part(const Tensor& t) {
    Vector3 at;
    for (std::size_t i = 0; i < 3; ++i)
        at[i] =
            omega({t.tau[0] * t.sigma[i][0], t.tau[1] * t.sigma[i][1], t.tau[2] * t.sigma[i][2]});
    return at;
}

Vector3 q_values(const Tensor& t) {
    Vector3 at = first_part(t);
    for (std::size_t i = 0; i < 3; ++i)
        at[i] = at[i] + Number(4) * product(t.tau) * t.rho[i];
    return at;
}

Number quintic(const Tensor& t) {
    const Vector3 b = cross(t.sigma[0], t.sigma[1]); // [23], [31], [12]
    const Vector3 x = from_values(first_part(t)), rho = from_values(t.rho);
    const Number j = t.tau[0] * b[1] * b[2] + t.tau[1] * b[2] * b[0] + t.tau[2] * b[0] * b[1];
    return polar(x, rho) - Number(2) * j + Number(2) * product(t.tau) * polar(rho, rho);
}

Number at_pin(const Tensor& t, std::size_t i, const Vector3& a) {
    return t.rho[i] + t.sigma[i][0] * a[0] + t.sigma[i][1] * a[1] + t.sigma[i][2] * a[2] +
           t.tau[0] * a[1] * a[2] + t.tau[1] * a[2] * a[0] + t.tau[2] * a[0] * a[1];
}

using Vector4 = std::array<Number, 4>;

/// A map from the plane c to A, by the images of both basis vectors.
Vector4 map_of(const Vector3& a, const Vector3& b) {
    return {a[0] - a[2], a[1] - a[2], b[0] - b[2], b[1] - b[2]};
}

/// Rows: the linear forms sigma_1, sigma_2, sigma_3, beta on maps from c to A (Lemma L4).
std::array<Vector4, 4> coordinates(const Plane& plane) {
    std::array<Vector4, 4> rows;
    std::array<Vector4, 3> epsilon;
    for (std::size_t v = 0; v < 3; ++v)
        epsilon[v] = map_of(unit(v, plane[0].w[v]), unit(v, plane[1].w[v]));
    for (std::size_t v = 0; v < 3; ++v)
        rows[v] = {-epsilon[v][3], epsilon[v][2], epsilon[v][1], -epsilon[v][0]};
    for (std::size_t k = 0; k < 4; ++k) {
        std::array<Vector3, 3> minor;
        for (std::size_t v = 0; v < 3; ++v)
            for (std::size_t c = 0, place = 0; c < 4; ++c)
                if (c != k) minor[v][place++] = epsilon[v][c];
        rows[3][k] = k % 2 == 0 ? -det(minor) : det(minor);
    }
    return rows;
}

Number along(const Vector4& row, const Vector4& x) {
    return row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + row[3] * x[3];
}

/// The plane with the same tensor and the other sign of beta.
Plane other_plane(const Plane& plane) {
    const auto rows = coordinates(plane);
    Plane other = plane;
    for (std::size_t i = 0; i < 2; ++i) {
        const Vector4 theta = map_of(value(phi(i), plane[0]), value(phi(i), plane[1]));
        std::vector<std::vector<Number>> system;
        for (std::size_t r = 0; r < 4; ++r) {
            const Number right = along(rows[r], theta);
            system.push_back(
                {rows[r][0], rows[r][1], rows[r][2], rows[r][3], r == 3 ? -right : right});
        }
        const std::vector<Number> x = solve(system);
        // Class (x_1, x_2) of A is that of (x_1, x_2, 0); phi_1 is coordinate 2, phi_2 is -1
        // times 1.
        for (std::size_t k = 0; k < 2; ++k)
            for (std::size_t v = 0; v < 3; ++v) {
                const Number entry = v < 2 ? x[2 * k + v] : Number(0);
                other[k].z[v][i == 0 ? 1 : 0] = i == 0 ? entry : -entry;
            }
    }
    return other;
}

/// Whether the cameras see a line through X_{i + 1} in space at these image lines.
bool see(const Plane& plane, std::size_t i, const Vector3& alpha) {
    std::vector<std::vector<Number>> forms(3);
    for (std::size_t v = 0; v < 3; ++v) {
        forms[v] = {phi(i)[0], phi(i)[1]};
        for (const FrameVector& x : plane)
            forms[v].push_back(value(phi(i), x)[v] - alpha[v] * x.w[v]);
    }
    return rank(forms) == 2;
}

} // namespace

TEST_CASE("three points on a line: cameras in space, their tensor and its other cameras") {
    std::mt19937_64 random(5);
    for (int trial = 0; trial < 20; ++trial) {
        const Scene scene(random, 8);
        const Tensor t = tensor_of(scene.plane);
        CHECK(product(t.tau) != Number(0));
        CHECK(quintic(t) == Number(0));
        const auto rows = coordinates(scene.plane);
        const Plane other = other_plane(scene.plane);
        CHECK(other != scene.plane);
        for (std::size_t i = 0; i < 3; ++i) {
            const Number beta = along(
                rows[3], map_of(value(phi(i), scene.plane[0]), value(phi(i), scene.plane[1])));
            CHECK(beta * beta == q_values(t)[i]);
            for (const Vector3& alpha : scene.pins[i]) {
                CHECK(at_pin(t, i, alpha) == Number(0));
                CHECK(see(scene.plane, i, alpha));
                CHECK(see(other, i, alpha));
                CHECK_FALSE(see(other, i, {alpha[0] + Number(1), alpha[1], alpha[2]}));
            }
        }
    }
}

TEST_CASE("three points on a line: the quintic is a factor of the discriminant") {
    std::mt19937_64 random(6);
    for (int trial = 0; trial < 100; ++trial) {
        Tensor t{random_vector(random), {}, random_vector(random)};
        t.sigma[0] = random_vector(random);
        t.sigma[1] = random_vector(random);
        for (std::size_t v = 0; v < 3; ++v)
            t.sigma[2][v] = t.sigma[0][v] + t.sigma[1][v];
        const Vector3 q = from_values(q_values(t));
        CHECK(polar(q, q) == Number(8) * product(t.tau) * quintic(t));
        CHECK(quintic(t) != Number(0));
    }
}

TEST_CASE("three points on a line: the quintic on the pencils of Theorem L") {
    std::mt19937_64 random(8);
    const auto with_sum = [](Tensor t) {
        for (std::size_t v = 0; v < 3; ++v)
            t.sigma[2][v] = t.sigma[0][v] + t.sigma[1][v];
        return t;
    };
    // t_0 + s t_1 at s = 0, ..., n: the difference of order n, and n! times the leading coefficient
    // of a polynomial of degree n.
    const auto difference = [](const Tensor& t_0, const Tensor& t_1, std::uint32_t n) {
        Number sum = 0, binomial = 1;
        for (std::uint32_t s = 0; s <= n; ++s) {
            Tensor t = t_0;
            for (std::size_t k = 0; k < 3; ++k) {
                t.tau[k] = t.tau[k] + Number(s) * t_1.tau[k];
                t.rho[k] = t.rho[k] + Number(s) * t_1.rho[k];
                for (std::size_t i = 0; i < 3; ++i)
                    t.sigma[i][k] = t.sigma[i][k] + Number(s) * t_1.sigma[i][k];
            }
            sum = binomial * quintic(t) - sum;
            binomial = binomial * Number(n - s) * Number(s + 1).inverse();
        }
        return sum;
    };
    for (int trial = 0; trial < 20; ++trial) {
        const Tensor general = with_sum({random_vector(random),
                                         {random_vector(random), random_vector(random), {}},
                                         random_vector(random)});
        CHECK(difference(general, {{}, {}, {1, 0, 0}}, 2) != Number(0));
        CHECK(difference(general, {{}, {}, {1, 0, 0}}, 3) == Number(0));
        // As mu^3 divides it at mu t + t'', its degree in s is 2 at t + s t''.
        const Tensor no_star = with_sum(
            {{}, {Vector3{}, random_vector(random), Vector3{}}, {0, random_number(random), 1}});
        CHECK(difference(general, no_star, 2) != Number(0));
        CHECK(difference(general, no_star, 3) == Number(0));
        CHECK(difference(general, no_star, 5) == Number(0));
    }
}

TEST_CASE("three points on a line: the number of solutions is that of Theorem L") {
    struct Row {
        Features features;
        std::size_t solutions;
    };
    const std::vector<Row> rows = {
        {{{0, 4, 6}, 0, {}}, 4},     {{{0, 5, 5}, 0, {}}, 4},  {{{1, 3, 6}, 0, {}}, 4},
        {{{2, 2, 6}, 0, {}}, 4},     {{{2, 3, 5}, 0, {}}, 10}, {{{2, 4, 4}, 0, {}}, 10},
        {{{3, 3, 4}, 0, {}}, 10},    {{{1, 4, 5}, 0, {}}, 10}, {{{0, 2, 6}, 1, {}}, 2},
        {{{1, 1, 6}, 1, {}}, 2},     {{{0, 0, 6}, 2, {}}, 2},  {{{0, 0, 5}, 0, {2}}, 2},
        {{{0, 1, 5}, 0, {1}}, 2},    {{{0, 2, 5}, 0, {0}}, 2}, {{{1, 1, 5}, 0, {0}}, 2},
        {{{0, 0, 4}, 0, {0, 0}}, 2}, {{{0, 4, 4}, 1, {}}, 10}, {{{1, 3, 4}, 1, {}}, 10},
        {{{2, 2, 4}, 1, {}}, 10},    {{{2, 3, 3}, 1, {}}, 11}, {{{0, 3, 5}, 1, {}}, 7},
        {{{1, 2, 5}, 1, {}}, 7}};
    std::mt19937_64 random(7);
    for (const Row& row : rows) {
        CAPTURE(row.features.pins);
        CAPTURE(row.features.free_lines);
        CHECK(solutions(conditions(row.features, random), 4) == row.solutions);
    }
}
