// The lemmas of proofs/calibrated_collinear_points.md by examples: cameras that are made up and see
// a scene, and zeros that are no solutions, modulo a prime or in complex numbers.
#include "proofs/computations/polynomials.h"
#include "proofs/computations/residue_matrices.h"
#include "tests/theorems/complex_vectors.h"

#include <doctest/doctest.h>
#include <map>

using namespace proofs;

namespace {

// Two views: section 2.

/// The images of a point in two views.
struct Pair {
    std::array<Residue, 3> x{}, y{};
};

/// A spurious essential matrix (1), with a = 3, b = 4, c = 5, d = 0.
using Matrix3 = std::array<std::array<Residue, 3>, 3>;
const Matrix3 spurious{{{0, 0, 3}, {0, 0, 4}, {5, 0, 0}}};

Matrix3 product(const Matrix3& a, const Matrix3& b) {
    Matrix3 c{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k)
                c[i][j] = c[i][j] + a[i][k] * b[k][j];
    return c;
}

Residue value(const Matrix3& f, const Pair& images) {
    Residue sum;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            sum = sum + images.y[i] * f[i][j] * images.x[j];
    return sum;
}

/// Off the line, with the equation for `spurious`: 3 y_1 + 4 y_2 + 5 x_1 = 0.
Pair pair_of(Residue x1, Residue x2, Residue y2) {
    const Residue y1 = -(Residue{4} * y2 + Residue{5} * x1) * Residue{3}.inverse();
    return {{x1, x2, 1}, {y1, y2, 1}};
}

Pair on_line(Residue x1, Residue x2, Residue y1, Residue y2) {
    return {{x1, x2, 0}, {y1, y2, 0}};
}

/// The direction of the line through two points.
Pair direction(const Pair& a, const Pair& b) {
    return on_line(b.x[0] - a.x[0], b.x[1] - a.x[1], b.y[0] - a.y[0], b.y[1] - a.y[1]);
}

/// The rank of the equations on the tangent space: 5 if the zero is isolated and simple.
std::size_t rank_at_spurious(const std::array<Pair, 5>& images) {
    ResidueMatrix rows;
    for (const Pair& pair : images) {
        REQUIRE(value(spurious, pair) == Residue{});
        ResidueRow& row = rows.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Matrix3 turn{};
            turn[(axis + 1) % 3][(axis + 2) % 3] = Residue{1};
            turn[(axis + 2) % 3][(axis + 1) % 3] = -Residue{1};
            row.push_back(value(product(turn, spurious), pair));
            row.push_back(value(product(spurious, turn), pair));
        }
    }
    return rank_of(rows);
}

// Three and four views: sections 3 to 7, in complex numbers.

using namespace complex_vectors;

Vector combination(Complex s, const Vector& a, Complex t, const Vector& b) {
    return s * a + t * b;
}

/// The frame of a view at some rho: sections 3 and 4.
struct View {
    Vector a, b; // image vectors of A and B; their sum is that of C
    Vector normal() const { return cross(a, b); }
    Complex nu() const { return std::sqrt(dot(normal(), normal())); }
    Vector r(Complex rho0, Complex rho1) const { return combination(rho0, b, -rho1, a); }
    Complex q(Complex rho0, Complex rho1) const { return dot(r(rho0, rho1), r(rho0, rho1)); }
    /// w; with -s for s it is the other one.
    Complex w(const Vector& y, Complex rho0, Complex rho1, Complex s) const {
        return (dot(y, cross(normal(), r(rho0, rho1))) + i_unit * s * dot(y, normal())) / nu();
    }
};

/// A camera of a scene whose points A, B are 0 and the first unit vector.
struct Camera {
    std::array<Vector, 3> rows; // a rotation
    Vector t;
    Vector see(const Vector& p) const {
        return {dot(rows[0], p) + t[0], dot(rows[1], p) + t[1], dot(rows[2], p) + t[2]};
    }
    Vector see_line(const Vector& p, const Vector& q) const { return cross(see(p), see(q)); }
};

Camera random_camera(Numbers& numbers) {
    Vector u = numbers.real_vector(), v = numbers.real_vector();
    u = combination(1.0 / std::sqrt(dot(u, u)), u, 0, u);
    v = combination(1, v, -dot(u, v), u);
    v = combination(1.0 / std::sqrt(dot(v, v)), v, 0, v);
    return {{u, v, cross(u, v)}, numbers.real_vector()};
}

const Vector point_a{0, 0, 0}, point_b{1, 0, 0};

/// A scene as section 3 describes it: C is (rho_0 A + rho_1 B) with rho_0 + rho_1 = 1.
struct Seen {
    View view;
    Complex s, tau;
};

Seen seen_by(const Camera& camera, double rho1) {
    // Image vectors with x_A + x_B = x_C: the vectors of A and B times rho_0 and rho_1.
    const Vector a = camera.see(point_a), b = camera.see(point_b);
    Seen seen{{combination(1 - rho1, a, 0, a), combination(rho1, b, 0, b)}, {}, {}};
    // kappa rho_1 x_A is the vector of A, so kappa = 1 / (rho_0 rho_1), and s is its inverse.
    seen.s = (1 - rho1) * rho1;
    const Vector normal = seen.view.normal();
    // The third vector of the basis, N / nu, as seen in space: (0, -sin, cos).
    Vector in_space{};
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t j = 0; j < 3; ++j)
            in_space[k] += camera.rows[j][k] * normal[j] / seen.view.nu();
    seen.tau = in_space[2] - i_unit * in_space[1];
    return seen;
}

Complex determinant(std::vector<std::vector<Complex>> m) {
    Complex result = 1;
    for (std::size_t c = 0; c < m.size(); ++c) {
        std::size_t pivot = c;
        for (std::size_t r = c; r < m.size(); ++r)
            if (std::abs(m[r][c]) > std::abs(m[pivot][c])) pivot = r;
        if (pivot != c) {
            std::swap(m[pivot], m[c]);
            result = -result;
        }
        result *= m[c][c];
        if (m[c][c] == Complex{}) return 0;
        for (std::size_t r = c + 1; r < m.size(); ++r) {
            const Complex factor = m[r][c] / m[c][c];
            for (std::size_t k = c; k < m.size(); ++k)
                m[r][k] -= factor * m[c][k];
        }
    }
    return result;
}

bool vanishes(Complex x) {
    return std::abs(x) < 1e-9;
}

// Integrals on the product of the curve and the space of tau.

/// Coefficients by the powers of h, T, T'.
using Class = std::map<std::array<unsigned, 3>, long>;

Class operator*(const Class& a, const Class& b) {
    Class result;
    for (const auto& [e, x] : a)
        for (const auto& [f, y] : b)
            result[{e[0] + f[0], e[1] + f[1], e[2] + f[2]}] += x * y;
    return result;
}
Class operator+(Class a, const Class& b) {
    for (const auto& [e, x] : b)
        a[e] += x;
    return a;
}

const Class h{{{1, 0, 0}, 1}}, t{{{0, 1, 0}, 1}}, t_inverse{{{0, 0, 1}, 1}};

/// In so many views: one h, and the degrees of the Cremona map.
long integral(const Class& c, unsigned views) {
    long sum = 0;
    for (const auto& [e, x] : c) {
        if (e[0] != 1) continue;
        REQUIRE(e[1] + e[2] == views - 1);
        long binomial = 1;
        for (unsigned k = 0; k < e[2]; ++k)
            binomial = binomial * (views - 1 - k) / (k + 1);
        sum += x * binomial;
    }
    return sum << views;
}

} // namespace

TEST_CASE(
    "spurious essential matrices are isolated zeros of the equations of five points, three on "
    "a line, unless the images satisfy an equation") {
    Residues numbers(1);
    const auto next = [&] { return numbers.next(); };
    for (int i = 0; i < 5; ++i) {
        const Pair four = pair_of(next(), next(), next()), five = pair_of(next(), next(), next());
        const auto point = [&] { return on_line(next(), next(), next(), next()); };
        const Pair one = point(), two = point(), three = point();
        CHECK(rank_at_spurious({one, two, three, four, five}) == 5);
        // On a line with points 4 and 5.
        CHECK(rank_at_spurious({direction(four, five), two, three, four, five}) == 5);
        // That line through the epipoles, n = (0, 5) and n' = (-4, 3).
        const Residue s = next(), u = next();
        Pair through = four;
        through.x[1] = through.x[1] + s * Residue{5};
        through.y[0] = through.y[0] - u * Residue{4};
        through.y[1] = through.y[1] + u * Residue{3};
        CHECK(rank_at_spurious({direction(four, through), two, three, four, through}) == 4);
    }
}

TEST_CASE("pins and free lines that cameras see satisfy the equations of the frame of a line") {
    Numbers numbers(2);
    for (int i = 0; i < 10; ++i) {
        const double rho1 = 0.3 + 0.2 * numbers.real();
        const Complex rho0 = 1 - rho1;
        const Vector p = numbers.real_vector(), q = numbers.real_vector();
        const std::array<Vector, 3> points{point_a, point_b, {rho1, 0, 0}};
        std::array<std::vector<std::vector<Complex>>, 3> pins;
        std::vector<std::vector<Complex>> line, squares;
        for (int v = 0; v < 4; ++v) {
            const Camera camera = random_camera(numbers);
            const auto [view, s, tau] = seen_by(camera, rho1);
            CHECK(vanishes(s * s - view.q(rho0, rho1)));
            for (std::size_t k = 0; k < 3; ++k) {
                const Vector y = camera.see_line(points[k], p);
                pins[k].push_back({k == 1 ? dot(y, view.a) : dot(y, view.b),
                                   view.w(y, rho0, rho1, s) * tau,
                                   view.w(y, rho0, rho1, -s) / tau});
            }
            const Vector y = camera.see_line(p, q);
            const Complex on_a = dot(y, view.a), on_b = dot(y, view.b);
            const Complex w = view.w(y, rho0, rho1, s), other = view.w(y, rho0, rho1, -s);
            line.push_back({on_a, on_b, w * tau, other / tau});
            const Vector r = view.r(rho0, rho1);
            CHECK(vanishes(w * other - dot(cross(y, r), cross(y, r))));
            squares.push_back({w * other, on_b * on_b, on_a * on_b, on_a * on_a});
        }
        for (auto& pin : pins) {
            pin.pop_back();
            CHECK(vanishes(determinant(pin)));
            pin[0][0] *= 2;
            CHECK(!vanishes(determinant(pin)));
        }
        CHECK(vanishes(determinant(squares)));
        for (std::size_t omitted = 0; omitted < 4; ++omitted) {
            std::vector<std::vector<Complex>> three(line.begin(), line.begin() + 3);
            for (auto& row : three)
                row.erase(row.begin() + static_cast<std::ptrdiff_t>(omitted));
            CHECK(vanishes(determinant(three)));
        }
    }
}

TEST_CASE(
    "a pin is a class 2h + T + T' in three views; the integrals are twice the degrees, with 256 "
    "zeros more for two pins in four views") {
    const Class a = h + t, b = h + t_inverse;
    CHECK(integral((a + b) * (a + b) * (a + b), 3) == 2 * 144);
    CHECK(integral(a * b * (a + b), 3) == 2 * 40);
    const Class pin = a * a + a * b + b * b;
    CHECK(integral(pin * pin, 4) == 2 * 544 + 2 * 4 * 2 * 16);
}

TEST_CASE("zeros over the boundary are simple: two pins in four views") {
    // The six equations near such a zero, with six coordinates.
    Numbers numbers(3);
    for (int round = 0; round < 5; ++round) {
        std::array<View, 4> views;
        std::array<std::array<Vector, 4>, 2> pin{}; // of A
        std::array<std::array<Complex, 4>, 2> p{};
        for (std::size_t v = 0; v < 4; ++v) {
            views[v] = {numbers.complex_vector(), numbers.complex_vector()};
            for (std::size_t k = 0; k < 2; ++k) {
                pin[k][v] = cross(views[v].a, numbers.complex_vector());
                p[k][v] = dot(pin[k][v], views[v].b);
            }
        }
        // K = 0 for pin 1 in view 1, at rho = (1 : z).
        const auto k_at = [&](Complex z) {
            const Vector c = cross(pin[0][0], views[0].r(1, z));
            return dot(c, c);
        };
        const Complex c0 = k_at(0), c1 = (k_at(1) - k_at(-1)) / 2.0, c2 = k_at(1) - c0 - c1;
        const Complex z = (-c1 + std::sqrt(c1 * c1 - 4.0 * c0 * c2)) / (2.0 * c2);
        std::array<Complex, 4> root;
        for (std::size_t v = 0; v < 4; ++v)
            root[v] = std::sqrt(views[v].q(1, z));
        if (std::abs(views[0].w(pin[0][0], 1, z, root[0])) > 1e-6) root[0] = -root[0];
        CHECK(vanishes(views[0].w(pin[0][0], 1, z, root[0])));
        std::array<Complex, 4> tau;
        for (std::size_t v = 1; v < 4; ++v)
            tau[v] = views[v].w(pin[1][v], 1, z, -root[v]) / p[1][v];
        for (const std::size_t v : {3U, 2U, 1U})
            tau[v] /= tau[1];
        const Complex sigma = [&] { // of pin 2: sigma' for sigma = 1
            const Complex c = views[0].w(pin[1][0], 1, z, root[0]) / p[1][0];
            return c * p[1][1] / views[1].w(pin[1][1], 1, z, -root[1]);
        }();
        using Six = std::array<Complex, 6>;
        const Six zero{z, 0, tau[2], tau[3], 0, sigma};
        const auto equations = [&](const Six& at) {
            const std::array<Complex, 4> place{1, 1, at[2], at[3]};
            Six values;
            for (std::size_t k = 0; k < 2; ++k) {
                std::array<Complex, 4> sum;
                for (std::size_t v = 0; v < 4; ++v) {
                    Complex s = std::sqrt(views[v].q(1, at[0]));
                    if (std::abs(s - root[v]) > std::abs(s + root[v])) s = -s;
                    const Complex first = v == 0 ? 1 : at[1] * place[v];
                    const Complex second = v == 0 ? at[1] : 1.0 / place[v];
                    sum[v] = views[v].w(pin[k][v], 1, at[0], s) * first +
                             at[4 + k] * views[v].w(pin[k][v], 1, at[0], -s) * second;
                }
                for (std::size_t v = 1; v < 4; ++v)
                    values[3 * k + v - 1] = sum[v] * p[k][0] - sum[0] * p[k][v];
            }
            return values;
        };
        for (const Complex value : equations(zero))
            CHECK(vanishes(value));
        std::vector<std::vector<Complex>> jacobian;
        for (std::size_t j = 0; j < 6; ++j) {
            constexpr double step = 1e-5;
            Six more = zero, less = zero;
            more[j] += step;
            less[j] -= step;
            const Six up = equations(more), down = equations(less);
            std::vector<Complex>& row = jacobian.emplace_back();
            for (std::size_t e = 0; e < 6; ++e)
                row.push_back((up[e] - down[e]) / (2 * step));
        }
        CHECK(std::abs(determinant(jacobian)) > 1e-6);
    }
}

TEST_CASE(
    "three points on a line and a point in three views: the equations of section 8 have 24 zeros, "
    "16 of them with three different points") {
    // At rho = (1 : z) the three equations are g_v = S k_v, with g_v quadratic in Z. The resultant
    // of g_2 k_1 - g_1 k_2 and g_3 k_1 - g_1 k_3 in Z also has twice the zeros of k_1.
    Residues numbers(4);
    using Poly = Polynomial;
    using PolyVector = std::array<Poly, 3>;
    const auto poly_dot = [](const PolyVector& a, const PolyVector& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    std::array<std::array<Poly, 3>, 3> g; // by view and the power of Z
    std::array<Poly, 3> k;
    for (std::size_t v = 0; v < 3; ++v) {
        PolyVector xa, y, r; // xa is rho_1 x_A
        for (std::size_t i = 0; i < 3; ++i) {
            const Residue a = numbers.next(), b = numbers.next();
            xa[i] = Poly(std::vector<Residue>{Residue{}, a});
            y[i] = Poly(numbers.next());
            r[i] = Poly(std::vector<Residue>{b, -a});
        }
        const Poly q = poly_dot(r, r), yr = poly_dot(y, r), xr = poly_dot(xa, r);
        PolyVector constant; // the vector of (8) at Z = 0; Z has the coefficient q y
        for (std::size_t i = 0; i < 3; ++i)
            constant[i] = xr * y[i] - yr * xa[i];
        g[v] = {poly_dot(constant, constant), Poly(Residue{2}) * q * poly_dot(constant, y),
                q * q * poly_dot(y, y)};
        k[v] = q * yr * yr;
    }
    const auto without_s = [&](std::size_t v) {
        std::array<Poly, 3> f;
        for (std::size_t i = 0; i < 3; ++i)
            f[i] = g[v][i] * k[0] - g[0][i] * k[v];
        return f;
    };
    const auto f = without_s(1), e = without_s(2);
    const Poly zero;
    Poly all = trimmed(laplace<Poly>({{f[2], f[1], f[0], zero},
                                      {zero, f[2], f[1], f[0]},
                                      {e[2], e[1], e[0], zero},
                                      {zero, e[2], e[1], e[0]}}));
    // As a form in rho it has the degree 32; four zeros are at rho_0 = 0, four at rho_1 = 0.
    CHECK(degree(all) == 32 - 4);
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(all[i] == Residue{});
    CHECK(all[4] != Residue{});
    Poly rest(std::vector<Residue>(all.coefficients.begin() + 4, all.coefficients.end()));
    CHECK(degree(k[0]) == 4);
    CHECK(trimmed(remainder(rest, k[0] * k[0])).coefficients.empty());
    // What is left has the degree 16: no zeros with k_1 and no multiple ones.
    Poly quotient(std::vector<Residue>(degree(rest) - 8 + 1));
    const Poly square = trimmed(k[0] * k[0]);
    while (!trimmed(rest).coefficients.empty()) {
        const std::size_t shift = degree(rest) - 8;
        const Residue factor = rest[degree(rest)] * square[8].inverse();
        quotient.coefficients[shift] = factor;
        Poly term(std::vector<Residue>(shift + 1));
        term.coefficients[shift] = factor;
        rest = trimmed(rest - term * square);
    }
    CHECK(degree(quotient) == 16);
    CHECK(has_simple_roots(quotient));
    CHECK(degree(gcd(quotient, k[0])) == 0);
}
