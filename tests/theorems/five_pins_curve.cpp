// Five pins of one of three points on a line, and a free line: the curve and the quadric of
// proofs/collinear_points_free_line.md, section 2.
#include "tests/theorems/axis_frame.h"

#include <doctest/doctest.h>

#include <array>
#include <optional>
#include <random>
#include <vector>

using namespace axis;

namespace {

/// The seven numbers T_{phi_3}.
struct StarTensor {
    Vector3 tau, sigma;
    Number rho;

    StarTensor plus(Number s, const StarTensor& other) const {
        StarTensor sum = *this;
        for (std::size_t v = 0; v < 3; ++v) {
            sum.tau[v] = tau[v] + s * other.tau[v];
            sum.sigma[v] = sigma[v] + s * other.sigma[v];
        }
        sum.rho = rho + s * other.rho;
        return sum;
    }

    Number pi() const { return tau[0] * tau[1] * tau[2]; }

    /// The left side of (2).
    Number delta() const {
        const Vector3 z = {tau[0] * sigma[0], tau[1] * sigma[1], tau[2] * sigma[2]};
        const Number sum = z[0] + z[1] + z[2];
        return sum * sum - Number(4) * (z[0] * z[1] + z[1] * z[2] + z[2] * z[0]) +
               Number(4) * pi() * rho;
    }
};

template <class Random>
StarTensor random_tensor_at(const std::array<Vector3, 5>& pins, Random& random) {
    const Number tau_1 = random_number(random), tau_2 = random_number(random);
    std::vector<std::vector<Number>> system;
    for (const Vector3& a : pins)
        system.push_back(
            {1, a[0], a[1], a[2], a[1] * a[2], -(tau_1 * a[2] * a[0] + tau_2 * a[0] * a[1])});
    const std::vector<Number> x = solve(system);
    return {{x[4], tau_1, tau_2}, {x[1], x[2], x[3]}, x[0]};
}

/// theta on a basis w, w' of c with w x w' = tau, as classes (b_1, b_2, 0) of A.
struct Graph {
    std::array<Vector3, 2> w, b;
};

/// The map with these sigma and beta (Lemma L4).
Graph graph_of(const StarTensor& t, Number beta) {
    Graph graph;
    graph.w = {Vector3{1, 0, -(t.tau[0] * t.tau[2].inverse())}, Vector3{0, t.tau[2], -t.tau[1]}};
    const std::array<Form, 3> e = {Form{1, 0}, Form{0, 1}, Form{-Number(1), -Number(1)}};
    std::array<std::array<Number, 4>, 3> epsilon;
    std::vector<std::vector<Number>> system;
    for (std::size_t v = 0; v < 3; ++v) {
        const Number x = graph.w[0][v], y = graph.w[1][v];
        epsilon[v] = {x * e[v][0], x * e[v][1], y * e[v][0], y * e[v][1]};
        system.push_back(
            {-epsilon[v][3], epsilon[v][2], epsilon[v][1], -epsilon[v][0], t.sigma[v]});
    }
    system.push_back({});
    for (std::size_t k = 0; k < 4; ++k) {
        std::array<Vector3, 3> minor;
        for (std::size_t v = 0; v < 3; ++v)
            for (std::size_t c = 0, place = 0; c < 4; ++c)
                if (c != k) minor[v][place++] = epsilon[v][c];
        system[3].push_back(k % 2 == 0 ? -det(minor) : det(minor));
    }
    system[3].push_back(beta);
    const std::vector<Number> x = solve(system);
    graph.b = {Vector3{x[0], x[1], 0}, Vector3{x[2], x[3], 0}};
    return graph;
}

Number value(const FrameForm& form, const FrameVector& x) {
    Number sum = 0;
    for (std::size_t v = 0; v < 3; ++v)
        sum = sum + form.mu[v][0] * x.z[v][0] + form.mu[v][1] * x.z[v][1] + form.nu[v] * x.w[v];
    return sum;
}

/// A vector of Y with this image in Q_3: phi_3 is b on it.
FrameVector lift(const FrameForm& y, const Vector3& b, const Vector3& w) {
    FrameVector x{{{{0, b[0]}, {0, b[1]}, {0, b[2]}}}, w};
    const Number t = -(value(y, x) * (y.mu[0][0] + y.mu[0][1]).inverse());
    x.z[0] = {t, b[0] + t};
    return x;
}

/// f_3 and lifts of a basis of the plane p.
std::array<FrameVector, 3> lifted(const FrameForm& y, const Graph& p) {
    const Number m_0 = y.mu[0][0] + y.mu[0][1], m_1 = y.mu[1][0] + y.mu[1][1];
    const FrameVector f_3{{{{m_1, m_1}, {-m_0, -m_0}, {0, 0}}}, {}};
    return {f_3, lift(y, p.b[0], p.w[0]), lift(y, p.b[1], p.w[1])};
}

Vector3 values(const FrameForm& form, const std::array<FrameVector, 3>& basis) {
    return {value(form, basis[0]), value(form, basis[1]), value(form, basis[2])};
}

using FormPair = std::array<FrameForm, 2>;

/// Psi(p), as a determinant: g_j(p) is a cross product in the basis.
Number psi(const std::array<FormPair, 3>& pins, const std::array<FrameVector, 3>& basis) {
    std::array<Vector3, 3> g;
    for (std::size_t j = 0; j < 3; ++j)
        g[j] = cross(values(pins[j][0], basis), values(pins[j][1], basis));
    return det(g);
}

/// A linear form in Plücker coordinates of Q_3.
Number linear(const FormPair& forms, const std::array<FrameVector, 3>& basis) {
    return cross(values(forms[0], basis), values(forms[1], basis))[0];
}

/// The degree of the polynomial of least degree with these values (Newton).
std::size_t degree(const std::vector<Number>& at, std::vector<Number> values) {
    for (std::size_t order = 1; order < at.size(); ++order)
        for (std::size_t k = at.size(); k-- > order;)
            values[k] = (values[k] - values[k - 1]) * (at[k] - at[k - order]).inverse();
    std::size_t result = at.size() - 1;
    while (result > 0 && values[result] == Number(0))
        --result;
    return result;
}

std::optional<Number> root(Number square) {
    for (std::uint32_t r = 0; r <= Number::prime / 2; ++r)
        if (Number(r) * Number(r) == square) return Number(r);
    return std::nullopt;
}

} // namespace

// The tensors of the curve are T' + s T''. The product of both values, at beta and -beta, has poles
// where pi = 0, as one of both points is p_v there: simple ones, for a linear form, and for Psi if
// it is 0 at p_v. Times pi it is a polynomial in s, whose zeros are those on the curve.
TEST_CASE("five pins and a free line: the curve has degree 5, and the quadric seven more zeros") {
    constexpr std::size_t samples = 12;
    std::mt19937_64 random(9);
    for (const std::array<std::size_t, 3>& points :
         {std::array<std::size_t, 3>{1, 1, 1}, {0, 1, 1}, {0, 0, 1}}) {
        std::array<Vector3, 5> five;
        for (Vector3& alpha : five)
            alpha = random_vector(random);
        std::array<FormPair, 3> pins;
        for (std::size_t j = 0; j < 3; ++j) {
            const Vector3 alpha = random_vector(random);
            pins[j] = {pin_form(phi(points[j]), alpha, 0, 1),
                       pin_form(phi(points[j]), alpha, 0, 2)};
        }
        const auto random_form = [&](const Form& first, const Form& second) {
            return form_through(first, second,
                                {random_pair(random), random_pair(random), random_pair(random)});
        };
        const FrameForm y = random_form(random_pair(random), random_pair(random));
        const FormPair section = {random_form(phi(2), {0, 0}), random_form({0, 0}, phi(2))};
        const StarTensor first = random_tensor_at(five, random),
                         second = random_tensor_at(five, random);
        std::vector<Number> at, quadric, line;
        std::size_t no_squares = 0;
        for (std::uint32_t s = 1; at.size() < samples; ++s) {
            const StarTensor t = first.plus(s, second);
            if (t.pi() == Number(0)) continue;
            const auto beta = root(t.delta());
            if (!beta) {
                ++no_squares;
                continue;
            }
            const auto one = lifted(y, graph_of(t, *beta)), other = lifted(y, graph_of(t, -*beta));
            at.push_back(s);
            quadric.push_back(psi(pins, one) * psi(pins, other) * t.pi());
            line.push_back(linear(section, one) * linear(section, other) * t.pi());
        }
        CHECK(no_squares > 0); // so delta is no square, nor a multiple of one
        CHECK(degree(at, line) == 5);
        CHECK(degree(at, quadric) == 7);
    }
}
