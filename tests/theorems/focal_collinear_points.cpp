// Theorem Z (proofs/focal_collinear_points.md): three cameras modulo a prime, with a focal length
// each, that see three points on a line; orders on a curve of no solutions; intersection numbers.
#include "tests/theorems/isotropic_view.h"

#include <doctest/doctest.h>

using namespace checker;
using namespace isotropic;
using proofs::Residues;
using residue_vectors::determinant;

namespace {

constexpr Vector along{Residue{}, {}, {1}}; // from P to Q

/// What a view says of P, Q and P + kappa (Q - P).
struct Seen {
    Vector p, q;    ///< the images of P and Q, times xi and eta
    Vector g, a, b; ///< g, A and B of section 1
};

Seen seen_by(const View& view, const Vector& point, Residue kappa, Residue factor) {
    const Vector isotropic{Residue{1}, {}, {}}, other{Residue{}, {1}, {}};
    const Residue rest = Residue{1} - kappa, scale = factor * kappa * rest;
    Seen seen;
    seen.p = times(factor * rest, view.point(point));
    seen.q = times(factor * kappa, view.point(plus(point, along)));
    seen.g = minus(times(rest, seen.q), times(kappa, seen.p));
    CHECK(seen.g == times(scale, view.direction(along)));
    seen.a = times(scale, view.direction(isotropic));
    seen.b = times(scale, view.direction(other));
    return seen;
}

/// A power series up to the third power.
struct Series {
    std::array<Residue, 4> coefficients{};

    Series operator+(const Series& b) const {
        Series sum;
        for (std::size_t i = 0; i < 4; ++i)
            sum.coefficients[i] = coefficients[i] + b.coefficients[i];
        return sum;
    }
    Series operator-(const Series& b) const { return *this + Series{{-Residue{1}}} * b; }
    Series operator*(const Series& b) const {
        Series product;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; i + j < 4; ++j)
                product.coefficients[i + j] =
                    product.coefficients[i + j] + coefficients[i] * b.coefficients[j];
        return product;
    }
    /// If it begins with 1.
    Series inverse() const {
        const Series rest = Series{{Residue{1}}} - *this;
        return Series{{Residue{1}}} + rest + rest * rest + rest * rest * rest;
    }
};

using Moving = Vector3<Series>;

Moving constant(const Vector& x) {
    return {Series{{x[0]}}, Series{{x[1]}}, Series{{x[2]}}};
}

/// A and B near a point of the curve of section 4, for tau and chi times the variable.
struct Nearby {
    Moving a, b;
};

Nearby nearby(const Vector& g, Residue tau, Residue chi) {
    const Series one{{Residue{1}}}, turn{{Residue{}, chi}}, scale = one + Series{{Residue{}, tau}};
    const Series third = one - turn * turn;
    const Moving at = constant(g);
    const Moving a{at[0] * (one - turn), at[1] * (one + turn), at[2] * third};
    const Moving b{at[0] * (one + turn), at[1] * (one - turn), at[2] * third};
    return {times(scale, a), times((scale * third).inverse(), b)};
}

} // namespace

TEST_CASE(
    "isotropic vectors are seen where Theorem Z says, and lines and pins meet its equations") {
    Residues random(1);
    const Vector point = random_vector(random);
    const Residue kappa = random.next();
    const Vector one = random_vector(random), other = random_vector(random);
    const Vector end = random_vector(random);
    std::array<Residue, 3> h, products;
    Vector first, second, at_a, at_b;          // the columns of (5) for a line without points
    std::array<std::array<Vector, 2>, 3> pins; // the rows of (8) for pins through P and Q
    for (std::size_t v = 0; v < 3; ++v) {
        const View view(random);
        const Residue w = view.w();
        const Seen seen = seen_by(view, point, kappa, random.next());
        for (const Vector& x : {seen.a, seen.b}) {
            CHECK(form(x, x, w) == Residue{});
            CHECK(form(x, seen.g, w) == Residue{});
        }
        h[v] = form(seen.a, seen.b, w) * form(seen.g, seen.g, w).inverse();

        // (4) gives c by A, and then w, B and the product.
        const Residue c = seen.g[0] * seen.a[2] * seen.a[0].inverse() - seen.g[2];
        const Residue p = c - seen.g[2], m = c + seen.g[2];
        CHECK(p * m * w == seen.g[0] * seen.g[1]);
        const Residue t = seen.a[2] * (p * m).inverse(), t_bar = seen.b[2] * (p * m).inverse();
        CHECK(seen.a == times(t, Vector{seen.g[0] * p, -(seen.g[1] * m), p * m}));
        CHECK(seen.b == times(t_bar, Vector{-(seen.g[0] * m), seen.g[1] * p, p * m}));
        products[v] = t * t_bar * p * m;

        const Vector line = times(random.next(), view.line(one, other));
        first[v] = dot(line, seen.p);
        second[v] = dot(line, seen.q);
        at_a[v] = dot(line, seen.a);
        at_b[v] = dot(line, seen.b);
        const Vector through_p = view.line(point, end);
        const Vector through_q = view.line(plus(point, along), end);
        pins[v][0] = {dot(through_p, seen.q), dot(through_p, seen.a), dot(through_p, seen.b)};
        pins[v][1] = {dot(through_q, seen.p), dot(through_q, seen.a), dot(through_q, seen.b)};
    }
    CHECK(h[0] == h[1]);
    CHECK(h[0] == h[2]);
    CHECK(products[0] == products[1]);
    CHECK(products[0] == products[2]);
    CHECK(determinant(first, second, at_a) == Residue{});
    CHECK(determinant(first, second, at_b) == Residue{});
    CHECK(determinant(first, at_a, at_b) == Residue{});
    for (std::size_t pin = 0; pin < 2; ++pin)
        CHECK(determinant(pins[0][pin], pins[1][pin], pins[2][pin]) == Residue{});
}

TEST_CASE("a point outside of the line, and lines through it, meet the equations of Theorem Z") {
    Residues random(3);
    const Vector point = random_vector(random), place = random_vector(random);
    const Residue kappa = random.next();
    const Vector end = random_vector(random);
    // R is P + phi_1 (Q - P) + phi_2 iota + phi_3 iota', with these for the first two axes.
    const Vector from_p = minus(place, point);
    std::array<std::array<Vector, 2>, 3> lines; // through r
    std::array<Vector, 3> pin;
    std::array<Seen, 3> seen;
    for (std::size_t v = 0; v < 3; ++v) {
        const View view(random);
        seen[v] = seen_by(view, point, kappa, random.next());
        const Vector r = times(random.next(), view.point(place));
        for (Vector& line : lines[v])
            line = cross(r, random_vector(random));
        pin[v] = times(random.next(), view.line(place, end));
    }
    // Elements of the space C belong to lines of different views, as in (6).
    for (std::size_t choice = 0; choice < 8; ++choice)
        for (const bool right : {true, false}) {
            const Residue x = right ? from_p[0] : random.next(), y = from_p[1];
            Vector first, second, third;
            for (std::size_t v = 0; v < 3; ++v) {
                const Vector& line = lines[v][choice >> v & 1];
                first[v] = dot(line, seen[v].p);
                second[v] = dot(line, seen[v].q);
                third[v] = dot(line, plus(times(x, seen[v].a), times(y, seen[v].b)));
            }
            CHECK((determinant(first, second, third) == Residue{}) == right); // (14)
        }
    Vector first, second, at_a, at_b;
    for (std::size_t v = 0; v < 3; ++v) {
        first[v] = dot(pin[v], seen[v].p);
        second[v] = dot(pin[v], seen[v].q);
        at_a[v] = dot(pin[v], seen[v].a);
        at_b[v] = dot(pin[v], seen[v].b);
    }
    CHECK(determinant(first, second, at_a) == Residue{});
    CHECK(determinant(first, second, at_b) == Residue{});
}

TEST_CASE("near the curve of no solutions lines and pins vanish as Theorem Z says") {
    Residues random(2);
    Series at_a, at_b; // L and its twin
    Residue first_order, second_order;
    std::array<Moving, 3> pin;
    std::array<Vector, 3> leading;
    std::array<Vector, 3> g, u;
    for (std::size_t v = 0; v < 3; ++v) {
        g[v] = random_vector(random);
        u[v] = random_vector(random);
    }
    u[2][0] = -(dot(u[0], g[0]) + dot(u[1], g[1]) + u[2][1] * g[2][1] + u[2][2] * g[2][2]) *
              g[2][0].inverse(); // (7)
    const Residue of_first_column = random.next();
    for (std::size_t v = 0; v < 3; ++v) {
        const Residue tau = random.next(), chi = random.next();
        const Nearby near = nearby(g[v], tau, chi);
        const Vector n{-g[v][0], g[v][1], Residue{}}, epsilon{Residue{}, {}, g[v][2]};
        const Vector delta = plus(times(tau, g[v]), times(chi, n));
        const Vector psi =
            minus(plus(times(tau * tau + chi * chi, g[v]), times(two * tau * chi, n)),
                  times(two * chi * chi, epsilon));
        at_a = at_a + dot(constant(u[v]), near.a);
        at_b = at_b + dot(constant(u[v]), near.b);
        first_order = first_order + dot(u[v], delta);
        second_order = second_order + dot(u[v], psi);

        const Vector line = random_vector(random);
        const Residue column = of_first_column * dot(line, g[v]);
        const Moving moving = constant(line);
        pin[v] = {Series{{column}}, dot(moving, near.a), dot(moving, near.b)};
        leading[v] = {column, dot(line, delta), dot(line, psi)};
    }
    CHECK(at_a.coefficients[0] == Residue{});
    CHECK(at_a.coefficients[1] == first_order);
    CHECK(first_order != Residue{});
    const Series sum = at_a + at_b;
    CHECK(sum.coefficients[0] == Residue{});
    CHECK(sum.coefficients[1] == Residue{});
    CHECK(sum.coefficients[2] == second_order);
    CHECK(second_order != Residue{});

    const Series of_pin = determinant(pin[0], pin[1], pin[2]);
    const Residue third = determinant(leading[0], leading[1], leading[2]);
    for (std::size_t order = 0; order < 3; ++order)
        CHECK(of_pin.coefficients[order] == Residue{});
    CHECK(of_pin.coefficients[3] == third);
    CHECK(third != Residue{});
}

namespace {

/// A class on the surface of a view: multiples of the class of lines, of the exceptional curve of
/// the bundle, and of E_0, ..., E_4.
struct Class {
    long lines;
    std::array<long, 6> curves;

    long operator*(const Class& b) const {
        long product = lines * b.lines;
        for (std::size_t i = 0; i < 6; ++i)
            product -= curves[i] * b.curves[i];
        return product;
    }
};

constexpr Class fibre{1, {-1, 0, 0, 0, 0, 0}};
constexpr Class under_a{2, {0, -1, -1, -1, 0, 0}}, under_b{2, {0, -1, 0, 0, -1, -1}};

/// The integral over the product of the three surfaces of fibres^power and, for each view, so many
/// factors of the classes under a and b.
long over_base(long power, const std::array<std::array<long, 2>, 3>& factors) {
    long product = 1, points = power;
    for (const auto& [of_a, of_b] : factors) {
        if (of_a + of_b == 1) {
            product *= (of_a == 1 ? under_a : under_b) * fibre;
        } else if (of_a + of_b == 2) {
            product *= of_a == 2   ? under_a * under_a
                       : of_b == 2 ? under_b * under_b
                                   : under_a * under_b;
            ++points;
        } else {
            return 0; // three classes of one view, or none
        }
    }
    return points == 1 ? product : 0;
}

/// The integral over fibres of T^(2 + i) T'^(2 + j), then over the base with fibres^power.
long over_bundle(long i, long j, long power) {
    long sum = 0;
    for (long a = 0; a <= i; ++a)
        for (long b = 0; a + b <= i; ++b)
            for (long c = 0; c <= j; ++c)
                for (long d = 0; c + d <= j; ++d)
                    sum += over_base(power, {{{a, c}, {b, d}, {i - a - b, j - c - d}}});
    return sum;
}

/// The integral over X of T^i T'^j: its class is (T + T' - 2 fibres)^2.
long over_x(long i, long j) {
    const auto with = [](long a, long b, long power) { return over_bundle(a - 2, b - 2, power); };
    return with(i + 2, j, 0) + 2 * with(i + 1, j + 1, 0) + with(i, j + 2, 0) -
           4 * (with(i + 1, j, 1) + with(i, j + 1, 1));
}

} // namespace

TEST_CASE("intersection numbers: 42 solutions with three lines, 140 with two lines and two pins") {
    CHECK(over_x(3, 3) == 120);
    const long two_pins = over_x(4, 2) + 2 * over_x(3, 3) + over_x(2, 4);
    CHECK(two_pins == 440);

    const auto off_curve = [](long total, long lines, long pins) {
        // The degrees on the curve, 1 or 2, times the orders of the other sections.
        long orders = 1;
        for (long i = 0; i < lines; ++i)
            orders *= 2;
        for (long i = 0; i < pins; ++i)
            orders *= 3;
        return total - lines * orders - lines * (orders / 2) - 2 * pins * (orders / 3);
    };
    CHECK(off_curve(120, 3, 0) == 2 * 42);
    CHECK(off_curve(two_pins, 2, 2) - 4 == 2 * 140);
}

TEST_CASE("intersection numbers: 98 and 128 solutions with a point outside of the line") {
    // The integral of (T - Z)^i (T' - 2 Z)^j.
    const auto off_curve = [](long i, long j) {
        const auto power = [](long exponent) { return 1L << exponent; };
        return over_x(i, j) - i * power(j) - j * power(j - 1);
    };
    const long squares = off_curve(4, 2) + off_curve(2, 4), mixed = off_curve(3, 3);
    CHECK(squares + mixed - 4 == 2 * 98);
    CHECK(squares + 2 * mixed - 4 - 24 == 2 * 128);
}
