#include "prover/solver/templates/rotation_ring.h"

namespace plprove::templates {

namespace {

void add_term(Polynomial& total, const Monomial& monomial, Residue coefficient) {
    const auto place = total.try_emplace(monomial, 0).first;
    place->second = nmod_add(place->second, coefficient, modulus_context());
    if (place->second == 0) total.erase(place);
}

} // namespace

BiDegree RotationRing::degree(const Monomial& m) const {
    if (frame_ == Frame::general) return {(m[0] + m[1] + m[2] + m[3]) / 2, 0};
    return {m[0] + m[1], m[2] + m[3]};
}

std::vector<Monomial> RotationRing::monomials(const BiDegree& bound) const {
    std::vector<Monomial> found;
    const bool all = frame_ == Frame::general;
    const int largest = all ? 2 * bound[0] : std::max(bound[0], bound[1]);
    for (int a = 0; a <= 1; ++a)
        for (int b = 0; b <= largest; ++b)
            for (int c = 0; c <= (all ? largest : 1); ++c)
                for (int d = 0; d <= largest; ++d) {
                    if (all && (a + b + c + d) % 2 != 0) continue;
                    if (at_most(degree({a, b, c, d}), bound)) found.push_back({a, b, c, d});
                }
    return found;
}

void RotationRing::add_normal(Polynomial& total, Monomial m, Residue coefficient) const {
    const Residue opposite = nmod_neg(coefficient, modulus_context());
    if (frame_ == Frame::general) {
        if (m[0] < 2) return add_term(total, m, coefficient);
        m[0] -= 2; // w² = 1 - x² - y² - z²; products of normal monomials have w² at most
        add_term(total, m, coefficient);
        for (std::size_t i = 1; i < 4; ++i) {
            Monomial higher = m;
            higher[i] += 2;
            add_term(total, higher, opposite);
        }
        return;
    }
    for (const std::size_t i : {std::size_t{0}, std::size_t{2}})
        if (m[i] >= 2) { // c² = 1 - s²
            m[i] -= 2;
            add_normal(total, m, coefficient);
            m[i + 1] += 2;
            return add_normal(total, m, opposite);
        }
    add_term(total, m, coefficient);
}

Polynomial RotationRing::product(const Polynomial& a, const Polynomial& b) const {
    Polynomial total;
    for (const auto& [m, x] : a)
        for (const auto& [n, y] : b)
            add_normal(total, {m[0] + n[0], m[1] + n[1], m[2] + n[2], m[3] + n[3]},
                       nmod_mul(x, y, modulus_context()));
    return total;
}

std::array<RotationFunction, 9> RotationRing::matrix() const {
    const auto coordinate = [&](std::size_t i) { // a function only in products on all rotations
        Monomial m{};
        m[i] = 1;
        return RotationFunction(*this, {{m, 1}});
    };
    const std::array u{coordinate(0), coordinate(1), coordinate(2), coordinate(3)};
    if (frame_ != Frame::general)
        return {u[0],
                u[1] * u[2] * -1,
                u[1] * u[3], // the first circle turns
                u[1],
                u[0] * u[2],
                u[0] * u[3] * -1, // what the second has
                one() * 0,
                u[3],
                u[2]}; // turned
    const auto square = [&](std::size_t i) { return u[i] * u[i]; };
    const auto off = [&](std::size_t i, std::size_t j, std::size_t k, int sign) {
        return (u[i] * u[j] + u[0] * u[k] * sign) * 2;
    };
    return {square(0) + square(1) - square(2) - square(3),
            off(1, 2, 3, -1),
            off(1, 3, 2, 1),
            off(2, 1, 3, 1),
            square(0) + square(2) - square(3) - square(1),
            off(2, 3, 1, -1),
            off(3, 1, 2, -1),
            off(3, 2, 1, 1),
            square(0) + square(3) - square(1) - square(2)};
}

RotationFunction RotationRing::one() const {
    return {*this, {{Monomial{}, 1}}};
}

RotationFunction operator+(const RotationFunction& a, const RotationFunction& b) {
    Polynomial total = a.polynomial_;
    for (const auto& [m, x] : b.polynomial_)
        add_term(total, m, x);
    return {*a.ring_, std::move(total)};
}

RotationFunction operator-(const RotationFunction& a, const RotationFunction& b) {
    return a + b * -1;
}

RotationFunction operator*(const RotationFunction& a, const RotationFunction& b) {
    return {*a.ring_, a.ring_->product(a.polynomial_, b.polynomial_)};
}

RotationFunction operator*(const RotationFunction& a, std::int64_t factor) {
    Polynomial total;
    for (const auto& [m, x] : a.polynomial_)
        add_term(total, m, nmod_mul(x, residue(factor), modulus_context()));
    return {*a.ring_, std::move(total)};
}

} // namespace plprove::templates
