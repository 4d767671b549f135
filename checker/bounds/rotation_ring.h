// Polynomial functions modulo q on the rotations, or on those that take one given direction into
// one given plane (FORMAT.md, section 10): sums of normal monomials in four coordinates. Knows
// nothing of cameras.
#pragma once

#include "checker/algebra/modular.h"

#include <map>
#include <string_view>
#include <vector>

namespace checker {
using Exponents = std::array<unsigned, 4>;
using Bidegree = std::array<unsigned, 2>; // the second is 0 on all rotations
using Polynomial = std::map<Exponents, Residue>;

/// Whether the sum of two degrees is at most a third.
inline bool fits(const Bidegree& a, const Bidegree& b, const Bidegree& most) {
    return a[0] + b[0] <= most[0] && a[1] + b[1] <= most[1];
}

inline Polynomial constant(Residue value) {
    return {{Exponents{}, value}};
}

/// The polynomials in w, x, y, z with w² + x² + y² + z² = 1, of even degree; or in c, s, c', s'
/// with c² + s² = 1 and c'² + s'² = 1. In normal monomials w, or c and c', have exponents below 2.
class RotationRing {
public:
    explicit RotationRing(bool all_rotations) : all_(all_rotations) {}

    /// The degree of the rotation matrix.
    Bidegree unit() const { return {1, all_ ? 0U : 1U}; }

    Bidegree degree(const Exponents& e) const {
        if (all_) return {(e[0] + e[1] + e[2] + e[3]) / 2, 0};
        return {e[0] + e[1], e[2] + e[3]};
    }

    /// The normal monomials up to a degree, in lexicographic order of their exponents.
    std::vector<Exponents> monomials(const Bidegree& most) const {
        std::vector<Exponents> found;
        const unsigned end = 2 * (most[0] + most[1]) + 1; // of all exponents
        const unsigned third_end = all_ ? end : 2;
        for (unsigned first = 0; first < 2; ++first)
            for (unsigned second = 0; second < end; ++second)
                for (unsigned third = 0; third < third_end; ++third)
                    for (unsigned fourth = 0; fourth < end; ++fourth) {
                        const Exponents e{first, second, third, fourth};
                        if (is_even(e) && fits(degree(e), {}, most)) found.push_back(e);
                    }
        return found;
    }

    /// Adds factor * a * b.
    void add_product(Polynomial& sum, const Polynomial& a, const Polynomial& b,
                     Residue factor) const {
        for (const auto& [e, x] : a)
            for (const auto& [f, y] : b) {
                const Exponents exponents{e[0] + f[0], e[1] + f[1], e[2] + f[2], e[3] + f[3]};
                add_term(sum, exponents, factor * x * y);
            }
    }

    /// Adds factor * a.
    void add(Polynomial& sum, const Polynomial& a, Residue factor) const {
        add_product(sum, a, constant({1}), factor);
    }

    /// The rotation matrix, by rows.
    std::array<Polynomial, 9> matrix() const {
        constexpr std::string_view quaternion[9] = {
            "+ww+xx-yy-zz", "+xy+xy-wz-wz", "+xz+xz+wy+wy", // first row
            "+xy+xy+wz+wz", "+ww-xx+yy-zz", "+yz+yz-wx-wx",
            "+xz+xz-wy-wy", "+yz+yz+wx+wx", "+ww-xx-yy+zz"};
        constexpr std::string_view angles[9] = {// c, s, c', s' are written w, x, y, z
                                                "+w",  "-xy", "+xz", "+x", "+wy",
                                                "-wz", "",    "+z",  "+y"};
        std::array<Polynomial, 9> entries;
        for (std::size_t i = 0; i < entries.size(); ++i)
            entries[i] = parse(all_ ? quaternion[i] : angles[i]);
        return entries;
    }

private:
    /// Whether a monomial is a function of the rotation: q and -q are the same one.
    bool is_even(const Exponents& e) const { return !all_ || (e[0] + e[1] + e[2] + e[3]) % 2 == 0; }

    /// A sum of terms, each a sign and letters.
    Polynomial parse(std::string_view terms) const {
        Polynomial sum;
        while (!terms.empty()) {
            const Residue sign = terms[0] == '+' ? Residue{1} : -Residue{1};
            terms.remove_prefix(1);
            Exponents e{};
            while (!terms.empty() && terms[0] >= 'w') {
                ++e[static_cast<std::size_t>(terms[0] - 'w')];
                terms.remove_prefix(1);
            }
            add_term(sum, e, sign);
        }
        return sum;
    }

    /// Adds a multiple of a monomial, made normal by w² = 1 - x² - y² - z², or by c² = 1 - s² and
    /// c'² = 1 - s'².
    void add_term(Polynomial& sum, const Exponents& e, Residue factor) const {
        if (e[0] >= 2) return add_replaced(sum, e, 0, all_ ? 4 : 2, factor);
        if (!all_ && e[2] >= 2) return add_replaced(sum, e, 2, 4, factor);
        sum[e] = sum[e] + factor;
    }

    /// The same with the square of coordinate `i` replaced: by 1 less the squares of those after
    /// it, up to `end`.
    void add_replaced(Polynomial& sum, Exponents e, std::size_t i, std::size_t end,
                      Residue factor) const {
        e[i] -= 2;
        add_term(sum, e, factor);
        for (std::size_t j = i + 1; j < end; ++j) {
            Exponents other = e;
            other[j] += 2;
            add_term(sum, other, -factor);
        }
    }

    bool all_;
};
} // namespace checker
