#include "prover/bounds/rotation_ring.h"

namespace plprove::bounds {

namespace {

void add_term(Polynomial& total, const Monomial& monomial, Residue coefficient) {
    const auto place = total.try_emplace(monomial, 0).first;
    place->second = nmod_add(place->second, coefficient, modulus_context());
    if (place->second == 0) total.erase(place);
}

} // namespace

BiDegree RotationRing::degree(const Monomial& m) const {
    if (rotations_ == Rotations::all) return {(m[0] + m[1] + m[2] + m[3]) / 2, 0};
    return {m[0] + m[1], m[2] + m[3]};
}

std::vector<Monomial> RotationRing::monomials(const BiDegree& bound) const {
    std::vector<Monomial> found;
    const bool all = rotations_ == Rotations::all;
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
    if (rotations_ == Rotations::all) {
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

std::array<Polynomial, 9> RotationRing::matrix() const {
    std::array<Polynomial, 4> u; // the coordinates, though on all rotations not functions
    for (std::size_t i = 0; i < 4; ++i) {
        Monomial m{};
        m[i] = 1;
        u[i][m] = 1;
    }
    const auto times = [&](std::size_t i, std::size_t j) { return product(u[i], u[j]); };
    if (rotations_ == Rotations::two_circles)
        return {u[0],
                scaled(times(1, 2), -1),
                times(1, 3), // the first circle turns
                u[1],
                times(0, 2),
                scaled(times(0, 3), -1), // what the second has
                {},
                u[3],
                u[2]}; // turned
    std::array<Polynomial, 9> entries;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        entries[4 * i] = difference(sum(times(0, 0), times(i + 1, i + 1)),
                                    sum(times(j + 1, j + 1), times(k + 1, k + 1)));
        entries[3 * i + j] = scaled(difference(times(i + 1, j + 1), times(0, k + 1)), 2);
        entries[3 * j + i] = scaled(sum(times(i + 1, j + 1), times(0, k + 1)), 2);
    }
    return entries;
}

Polynomial constant(std::int64_t value) {
    Polynomial total;
    add_term(total, {}, residue(value));
    return total;
}

Polynomial scaled(const Polynomial& a, std::int64_t factor) {
    Polynomial total;
    for (const auto& [m, x] : a)
        add_term(total, m, nmod_mul(x, residue(factor), modulus_context()));
    return total;
}

Polynomial sum(const Polynomial& a, const Polynomial& b) {
    Polynomial total = a;
    for (const auto& [m, x] : b)
        add_term(total, m, x);
    return total;
}

Polynomial difference(const Polynomial& a, const Polynomial& b) {
    return sum(a, scaled(b, -1));
}

} // namespace plprove::bounds
