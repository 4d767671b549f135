// Polynomial functions modulo q on the rotations, or on those that take one given direction into
// one given plane (FORMAT.md, section 10): sums of normal monomials in four coordinates, in which
// squares of the first, or of the first and third, do not occur. Knows nothing of cameras.
#pragma once

#include "checker/modular.h"

#include <map>
#include <sstream>
#include <vector>

namespace checker {
using Exponents = std::array<unsigned, 4>;
using Bidegree = std::array<unsigned, 2>; // the second is 0 on all rotations
using Polynomial = std::map<Exponents, Residue>;

/// Whether the sum of two degrees is at most a third.
inline bool fits(const Bidegree& a, const Bidegree& b, const Bidegree& most) {
    return a[0] + b[0] <= most[0] && a[1] + b[1] <= most[1];
}

struct RotationRing {
    bool all; // all rotations: (w, x, y, z) of norm 1; else (c, s, c', s') on two circles

    Bidegree unit() const { return {1, all ? 0U : 1U}; } // of the rotation matrix
    Bidegree degree(const Exponents& e) const {
        return all ? Bidegree{(e[0] + e[1] + e[2] + e[3]) / 2, 0}
                   : Bidegree{e[0] + e[1], e[2] + e[3]};
    }

    /// The normal monomials up to a degree, in lexicographic order of their exponents.
    std::vector<Exponents> monomials(const Bidegree& most) const {
        std::vector<Exponents> found;
        const unsigned end = 2 * (most[0] + most[1]) + 1; // of all exponents
        for (Exponents e{}; e[0] < 2; ++e[0])
            for (e[1] = 0; e[1] < end; ++e[1])
                for (e[2] = 0; e[2] < (all ? end : 2); ++e[2])
                    for (e[3] = 0; e[3] < end; ++e[3])
                        if (fits(degree(e), {}, most) && !(all && (e[0] + e[1] + e[2] + e[3]) % 2))
                            found.push_back(e);
        return found;
    }

    /// Adds a multiple of a monomial, made normal: w² = 1 - x² - y² - z², or c² = 1 - s² twice.
    void add(Polynomial& sum, Exponents e, Residue factor) const {
        for (std::size_t i = 0; i < (all ? 1 : 4); i += 2) {
            if (e[i] < 2) continue;
            e[i] -= 2;
            add(sum, e, factor);
            for (std::size_t j = i + 1; j < (all ? 4 : i + 2); ++j, e[j - 1] -= 2) {
                e[j] += 2;
                add(sum, e, -factor);
            }
            return;
        }
        sum[e] = Residue::of(Wide{sum[e].value} + factor.value);
    }

    /// Adds factor * a * b.
    void add(Polynomial& sum, const Polynomial& a, const Polynomial& b, Residue factor) const {
        for (const auto& [e, x] : a)
            for (const auto& [f, y] : b)
                add(sum, {e[0] + f[0], e[1] + f[1], e[2] + f[2], e[3] + f[3]}, factor * x * y);
    }

    /// The rotation matrix, row by row: its terms, each with its place, its sign and its factors.
    std::array<Polynomial, 9> matrix() const {
        std::istringstream terms(
            all ? "0+ww 0+xx 0-yy 0-zz 1+xy 1+xy 1-wz 1-wz 2+xz 2+xz 2+wy 2+wy 3+xy 3+xy 3+wz 3+wz "
                  "4+ww 4-xx 4+yy 4-zz 5+yz 5+yz 5-wx 5-wx 6+xz 6+xz 6-wy 6-wy 7+yz 7+yz 7+wx 7+wx "
                  "8+ww 8-xx 8-yy 8+zz"
                : "0+w 1-xy 2+xz 3+x 4+wy 5-wz 7+z 8+y"); // c, s, c', s' are written w, x, y, z
        std::array<Polynomial, 9> entries;
        for (std::string term; terms >> term;) {
            Exponents e{};
            for (const char factor : term.substr(2)) ++e[static_cast<std::size_t>(factor - 'w')];
            const auto place = static_cast<std::size_t>(term[0] - '0');
            add(entries[place], e, term[1] == '+' ? Residue{1} : -Residue{1});
        }
        return entries;
    }
};
} // namespace checker
