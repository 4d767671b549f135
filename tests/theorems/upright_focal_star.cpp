// Theorem J, section 7 (proofs/upright_focal_views.md): three cameras modulo a prime that know the
// vertical direction see lines through a point; and how many zeros a determinant has on a curve.
#include "tests/theorems/upright_view.h"

#include <array>
#include <doctest/doctest.h>

using namespace checker;
using namespace residue_vectors;
using namespace upright_view;

namespace {

constexpr std::array<std::size_t, 3> views{0, 1, 2};

std::size_t next(std::size_t v) {
    return (v + 1) % 3;
}

std::size_t previous(std::size_t v) {
    return (v + 2) % 3;
}

/// The product of horizontal parts.
Residue horizontal(const Vector& x, const Vector& y) {
    return x[0] * y[0] + x[2] * y[2];
}

/// A number a + b y, where y^2 is known.
struct Number {
    Residue a, b, square;

    Number operator+(const Number& other) const { return {a + other.a, b + other.b, square}; }
    Number operator-(const Number& other) const { return {a - other.a, b - other.b, square}; }
    Number operator*(const Number& other) const {
        return {a * other.a + b * other.b * square, a * other.b + b * other.a, square};
    }
    Residue norm() const { return a * a - b * b * square; }
    Number inverse() const {
        const Residue scale = norm().inverse();
        return {a * scale, -b * scale, square};
    }
};

/// A trilinear form without the product of all three unknowns: the constant, the coefficients of
/// single unknowns, and of products of all but one.
struct Trilinear {
    Residue constant;
    Vector single, without;

    Residue operator()(const Vector& x) const {
        Residue sum = constant + dot(single, x);
        for (const std::size_t v : views)
            sum = sum + without[v] * x[next(v)] * x[previous(v)];
        return sum;
    }
};

Trilinear random_form(Residues& random) {
    return {random.next(), random_vector(random), random_vector(random)};
}

/// det Psi of section 7 at both points of the curve over a form of the pencil, multiplied, and
/// without the poles and zeros that the section knows.
Residue reduced_norm(const Trilinear& form, const Vector& rho) {
    const Vector& t = form.without;
    // The determinant of the form, bilinear in two unknowns, as a polynomial in the one of a view.
    Residue discriminant;
    std::array<Residue, 3> middle;
    for (const std::size_t v : views) {
        const std::size_t j = next(v), k = previous(v);
        middle[v] = t[v] * form.single[v] - t[k] * form.single[k] - t[j] * form.single[j];
        const Residue last = t[v] * form.constant - form.single[j] * form.single[k];
        discriminant = middle[v] * middle[v] + Residue{4} * t[j] * t[k] * last;
    }
    const auto number = [&](Residue x) { return Number{x, {}, discriminant}; };
    std::array<Number, 3> x, primed, shifted, primed_shifted;
    for (const std::size_t v : views) {
        const Residue scale = (Residue{2} * t[next(v)] * t[previous(v)]).inverse();
        x[v] = {middle[v] * scale, -scale, discriminant};
        primed[v] = {middle[v] * scale, scale, discriminant};
        shifted[v] = x[v] + number(rho[v]);
        primed_shifted[v] = primed[v] + number(rho[v]);
    }
    const Number product = shifted[0] * shifted[1] * shifted[2];
    const Number primed_product = primed_shifted[0] * primed_shifted[1] * primed_shifted[2];

    // (8), where all unknowns are -rho.
    const Residue all_t = t[0] * t[1] * t[2];
    const Residue value = form({-rho[0], -rho[1], -rho[2]});
    const Number difference = primed_product - product;
    CHECK(difference.a == Residue{});
    CHECK(difference.b * all_t == value);

    // The entries on the diagonal agree: three equations for gamma, by columns.
    std::array<Vector3<Number>, 3> columns;
    Vector3<Number> right;
    for (const std::size_t i : views) {
        const std::size_t j = next(i), k = previous(i);
        for (const std::size_t v : views)
            columns[v][i] = number({});
        columns[j][i] = shifted[j] * shifted[j];
        columns[k][i] = number({}) - primed_shifted[k] * primed_shifted[k];
        right[i] = primed[k] * primed[k] - x[j] * x[j];
    }
    const Number scale = determinant(columns[0], columns[1], columns[2]).inverse();
    std::array<Vector3<Number>, 3> psi;
    for (const std::size_t v : views) {
        std::array<Vector3<Number>, 3> replaced = columns;
        replaced[v] = right;
        const Number gamma = determinant(replaced[0], replaced[1], replaced[2]) * scale;
        const std::size_t j = next(v), k = previous(v);
        psi[k][k] = x[v] * x[v] + gamma * shifted[v] * shifted[v];
        psi[j][k] = psi[k][j] = x[v] * primed[v] + gamma * shifted[v] * primed_shifted[v];
    }
    const Residue sum = all_t * (product + primed_product).a;
    const Residue poles = value * power(sum * all_t, 3);
    const Residue zeros = power(discriminant, 4);
    return determinant(psi[0], psi[1], psi[2]).norm() * poles * poles * zeros.inverse();
}

} // namespace

TEST_CASE("three upright cameras see a point with lines as Theorem J says") {
    Residues random(1);
    const std::array<View, 3> all{View(random), View(random), View(random)};
    const Vector direction = random_vector(random);
    std::array<Vector, 3> e;
    for (const std::size_t i : views)
        e[i] = upright(cross(all[next(i)].ray(), all[previous(i)].ray()));
    Residue product{1}, primed_product{1};
    for (const std::size_t v : views) {
        const View& view = all[v];
        const auto place_of = [&](const Vector& plane) {
            return view.place(view.image(cross(view.ray(), plane)));
        };
        const Vector &before = e[previous(v)], &after = e[next(v)];
        const Residue x = place_of(before), primed = place_of(after);
        CHECK(view.normal(view.line(x)) == before);
        CHECK(view.normal(view.line(primed)) == after);

        const Residue any = random.next(), other = random.next();
        const Vector normal = view.normal(view.line(any));
        CHECK(times(x - primed, normal) ==
              minus(times(any - primed, before), times(any - x, after))); // (7)
        const Residue rho = view.q[1] * view.q[0].inverse();
        const Residue root = view.g * view.q[0] * view.q[2].inverse();
        CHECK(horizontal(normal, view.normal(view.line(other))) ==
              any * other + root * root * (any + rho) * (other + rho)); // (9)

        const Residue seen = view.place(view.image(direction));
        CHECK(dot(view.normal(view.line(seen)), direction) == Residue{});
        product = product * (seen - x);
        primed_product = primed_product * (seen - primed);
    }
    CHECK(product == primed_product); // (8)
    std::array<Vector, 3> psi;
    for (const std::size_t i : views)
        for (const std::size_t j : views)
            psi[i][j] = horizontal(e[i], e[j]);
    CHECK(determinant(psi[0], psi[1], psi[2]) == Residue{});
}

TEST_CASE("22 zeros of a determinant are left on the curve of a pencil") {
    Residues random(2);
    const Trilinear first = random_form(random), second = random_form(random);
    const Vector rho = random_vector(random);
    proofs::ResidueRow values;
    for (std::size_t sigma = 0; sigma < 30; ++sigma) {
        const Residue factor = Residue::of(sigma);
        values.push_back(reduced_norm({first.constant + factor * second.constant,
                                       plus(first.single, times(factor, second.single)),
                                       plus(first.without, times(factor, second.without))},
                                      rho));
    }
    const proofs::ResidueRow coefficients = proofs::interpolated(values);
    CHECK(coefficients[22] != Residue{});
    for (std::size_t degree = 23; degree < coefficients.size(); ++degree)
        CHECK(coefficients[degree] == Residue{});
}
