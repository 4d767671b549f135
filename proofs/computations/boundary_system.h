// The system (8) of proofs/two_points.md, modulo q = 2^61 - 1, for images whose
// coordinates at alpha_v, beta_v and n_v are arbitrary.
#pragma once

#include "checker/algebra/modular.h"
#include "checker/algebra/vector3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace proofs {

using checker::Residue;
using Vector3 = checker::Vector3<Residue>;

inline constexpr Residue zero{}, one{1};

/// s a + t b
inline Vector3 combination(Residue s, const Vector3& a, Residue t, const Vector3& b) {
    return plus(times(s, a), times(t, b));
}

/// A line l in a view, by its products with alpha_v, beta_v and n_v.
struct ImageLine {
    std::size_t view;
    Vector3 line;
};
/// The image lines whose planes have a relation: three, or four.
using Condition = std::vector<ImageLine>;

/// Random images of X in the coordinates of alpha_v, beta_v and n_v, of which the last is 0; the
/// numbers p_v; and random image lines.
class Images {
public:
    explicit Images(std::uint64_t seed) : random_(seed) {
        for (std::size_t v = 0; v < 3; ++v) {
            point_[v] = {number(), number(), zero};
            factor_[v] = number();
        }
    }

    Vector3 vector() { return {number(), number(), number()}; }
    Condition free_line() { return {{0, vector()}, {1, vector()}, {2, vector()}}; }

    /// A line through an image point whose coordinate at n_v is not 0.
    ImageLine through(std::size_t view, const Vector3& point) {
        const Residue a = number(), b = number();
        const Residue rest = a * point[0] + b * point[1];
        return {view, {a, b, -rest * point[2].inverse()}};
    }

    /// Lines through the images of X.
    Condition pin() {
        Condition lines = free_line();
        for (ImageLine& l : lines) {
            const Vector3& x = point_[l.view];
            l.line[1] = -(l.line[0] * x[0]) * x[1].inverse();
        }
        return lines;
    }

    /// p_v l . x_v
    Residue first_coefficient(const ImageLine& l) const {
        const Vector3& x = point_[l.view];
        return factor_[l.view] * (l.line[0] * x[0] + l.line[1] * x[1]);
    }

private:
    Residue number() { return {random_() % checker::modulus}; }

    std::mt19937_64 random_;
    std::array<Vector3, 3> point_{}; // x_v
    Vector3 factor_{};               // p_v
};

/// The unknowns of (8): b_v, and sigma_v with sigma_1 = 0.
struct Unknowns {
    Vector3 b{}, sigma{};
};

/// Two free lines and a third condition, for which (8) reads A_1 = A_2 = Q_2 = K = 0.
struct System {
    const Images& images;
    Condition first, second, third;

    /// The four coefficients of w' at a plane in (8).
    std::array<Residue, 4> row(const ImageLine& l, const Unknowns& at) const {
        const auto& [a, a1, a2] = l.line; // a, a', a''
        const Residue b = at.b[l.view], sigma = at.sigma[l.view];
        const Residue quadratic =
            a * sigma * sigma + Residue{2} * a2 * sigma * b - Residue{4} * a1 * b * b;
        return {images.first_coefficient(l), a, a * sigma + a2 * b, quadratic};
    }

    /// The factors w' of a free line, from the first two equations.
    Vector3 factors(const Condition& planes) const {
        Vector3 top, next;
        for (std::size_t v = 0; v < 3; ++v) {
            const auto coefficients = row(planes[v], {});
            top[v] = coefficients[0];
            next[v] = coefficients[1];
        }
        return cross(top, next);
    }

    /// The left side of an equation of (8) for a free line: A for 2, Q for 3.
    Residue side(const Condition& planes, std::size_t equation, const Unknowns& at) const {
        const Vector3 w = factors(planes);
        Residue sum;
        for (std::size_t v = 0; v < 3; ++v)
            sum = sum + w[v] * row(planes[v], at)[equation];
        return sum;
    }

    /// The linear form A as a function of sigma_2, sigma_3, and its value at b and sigma = 0.
    Vector3 linear(const Condition& planes, const Vector3& b) const {
        return {side(planes, 2, {{}, {zero, one, zero}}), side(planes, 2, {{}, {zero, zero, one}}),
                side(planes, 2, {b, {}})};
    }

    /// The determinant of A_1, A_2 as functions of sigma_2, sigma_3.
    Residue scale() const { return cross(linear(first, {}), linear(second, {}))[2]; }

    /// The point with these b_v at which A_1 = A_2 = 0, if scale() is not 0: linear in b.
    Unknowns solve(const Vector3& b) const {
        const auto [s2, s3, divisor] = cross(linear(first, b), linear(second, b));
        const Residue inverse = divisor.inverse();
        return {b, {zero, s2 * inverse, s3 * inverse}};
    }

    /// Q of a free line on the plane A_1 = A_2 = 0, a quadratic form of b.
    Residue form(const Condition& planes, const Vector3& b) const {
        return side(planes, 3, solve(b));
    }
    /// Twice its polar form.
    Residue polar(const Vector3& b, const Vector3& c) const {
        return form(second, combination(one, b, one, c)) - form(second, b) - form(second, c);
    }

    /// The matrix whose determinant is K: without the first equation for a pin, which has three
    /// planes.
    std::vector<std::vector<Residue>> matrix(const Vector3& b) const {
        const Unknowns at = solve(b);
        const std::ptrdiff_t skipped = third.size() == 3 ? 1 : 0;
        std::vector<std::vector<Residue>> rows;
        for (const ImageLine& l : third) {
            const auto coefficients = row(l, at);
            rows.emplace_back(coefficients.begin() + skipped, coefficients.end());
        }
        return rows;
    }

    /// The product of all that must not be 0 at the zeros: Q_1, the b_v, the factors of the lines,
    /// and those of the third condition, which are minors of its first equations.
    Residue excluded(const Vector3& b) const {
        Residue product = form(first, b) * b[0] * b[1] * b[2];
        for (const Condition& line : {first, second})
            for (const Residue w : factors(line))
                product = product * w;
        for (std::size_t plane = 0; plane < third.size(); ++plane) {
            auto minor = matrix(b);
            minor.erase(minor.begin() + static_cast<std::ptrdiff_t>(plane));
            for (auto& entries : minor)
                entries.pop_back();
            product = product * checker::determinant(std::move(minor));
        }
        return product;
    }

    /// The determinant of the conic Q_2 = 0 in the plane A_1 = A_2 = 0.
    Residue discriminant() const {
        constexpr std::array<Vector3, 3> unit{
            {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
        std::vector<std::vector<Residue>> gram;
        for (const Vector3& b : unit) {
            gram.emplace_back();
            for (const Vector3& c : unit)
                gram.back().push_back(polar(b, c));
        }
        return checker::determinant(std::move(gram));
    }

    /// A point of the conic, with b_2 a small multiple of b_3; the caller checks that it is one.
    Vector3 point_of_conic() const {
        constexpr Vector3 along{one, zero, zero};
        Vector3 start{zero, one, one};
        for (; start[1].value < 100; start[1] = start[1] + one) {
            const Residue a = form(second, along), b = polar(start, along);
            const Residue square = b * b - Residue{4} * a * form(second, start);
            Residue root = square; // its power (q + 1) / 4 = 2^59 is a root, if there is one
            for (int n = 0; n < 59; ++n)
                root = root * root;
            if (root * root != square) continue;
            start[0] = (root - b) * (a + a).inverse();
            break;
        }
        return start;
    }
};

} // namespace proofs
