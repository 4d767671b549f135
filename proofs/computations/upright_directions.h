// The variety of Theorems J and X: coordinates, and equations over the integers.
#pragma once

#include "proofs/computations/residue_matrices.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace proofs {

/// The coordinates of each pair of views v, w: S, g_w C, g_v C, g_v g_w S, with sine and cosine of
/// an angle.
inline constexpr std::array<std::array<std::size_t, 2>, 3> pairs{{{0, 1}, {1, 2}, {2, 0}}};
inline constexpr std::size_t coordinates = 4 * pairs.size();

using Point = std::array<Residue, coordinates>;
using Monomial = std::vector<std::size_t>; // coordinates, ascending
using Powers = std::array<int, 3>;         // of g_1, g_2, g_3

/// A point of the variety, all g being 1: with the tangents s and t of half of the angles from view
/// 1 to 2 and from 2 to 3. Each coordinate is a polynomial of degree 2 in s and in t.
inline Point point_with(Residue s, Residue t) {
    const Residue one{1}, two{2};
    const std::array<Residue, 2> sine{two * s, two * t}, cosine{one - s * s, one - t * t};
    const std::array<Residue, 2> unit{one + s * s, one + t * t};
    const std::array<Residue, 3> sines{sine[0] * unit[1], sine[1] * unit[0],
                                       -(sine[0] * cosine[1] + cosine[0] * sine[1])};
    const std::array<Residue, 3> cosines{cosine[0] * unit[1], cosine[1] * unit[0],
                                         cosine[0] * cosine[1] - sine[0] * sine[1]};
    Point point;
    for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
        point[4 * pair] = point[4 * pair + 3] = sines[pair];
        point[4 * pair + 1] = point[4 * pair + 2] = cosines[pair];
    }
    return point;
}

/// All products of so many of these numbers of things.
inline std::vector<Monomial> monomials(std::size_t things, std::size_t degree,
                                       std::size_t from = 0) {
    if (degree == 0) return {{}};
    std::vector<Monomial> all;
    for (std::size_t first = from; first < things; ++first)
        for (Monomial rest : monomials(things, degree - 1, first)) {
            rest.insert(rest.begin(), first);
            all.push_back(rest);
        }
    return all;
}

template <class Values>
Residue value(const Monomial& monomial, const Values& values) {
    Residue product{1};
    for (const std::size_t factor : monomial)
        product = product * values[factor];
    return product;
}

inline Powers powers_of(const Monomial& monomial) {
    Powers powers{};
    for (const std::size_t coordinate : monomial) {
        const auto& [v, w] = pairs[coordinate / 4];
        powers[w] += static_cast<int>(coordinate % 2);
        powers[v] += static_cast<int>(coordinate % 4 / 2);
    }
    return powers;
}

/// A form in the coordinates all of whose terms have the same powers of the g.
struct Equation {
    std::vector<Monomial> monomials;
    ResidueRow coefficients;

    template <class Values>
    Residue at(const Values& values) const {
        Residue sum;
        for (std::size_t i = 0; i < monomials.size(); ++i)
            sum = sum + coefficients[i] * value(monomials[i], values);
        return sum;
    }
};

/// All equations of the variety of this degree in products that are allowed, as far as some of its
/// points modulo q show.
template <class Allowed>
std::vector<Equation> equations_of(std::size_t degree, Allowed allowed) {
    std::map<Powers, std::vector<Monomial>> by_powers;
    for (const Monomial& monomial : monomials(coordinates, degree))
        if (allowed(monomial)) by_powers[powers_of(monomial)].push_back(monomial);
    Residues random(2);
    std::vector<Equation> equations;
    for (const auto& [powers, terms] : by_powers) {
        ResidueMatrix values;
        for (std::size_t i = 0; i < terms.size(); ++i) {
            const Residue s = random.next();
            const Point point = point_with(s, random.next());
            values.emplace_back();
            for (const Monomial& term : terms)
                values.back().push_back(value(term, point));
        }
        for (const ResidueRow& row : kernel_of(values, terms.size()))
            equations.push_back({terms, row});
    }
    return equations;
}

/// Whether the equation is one over the integers: if its coefficients are small, it is a polynomial
/// in s and t with coefficients below q, so it is enough that it is 0 modulo q; and as that has a
/// degree of 8 at most in either, that it vanishes where both are numbers from 0 to 8.
inline bool holds_over_the_integers(const Equation& equation) {
    const auto is_small = [](Residue a) {
        return a == Residue{} || a == Residue{1} || a == -Residue{1} || a == Residue{2} ||
               a == -Residue{2};
    };
    if (!std::ranges::all_of(equation.coefficients, is_small)) return false;
    for (std::uint64_t s = 0; s <= 8; ++s)
        for (std::uint64_t t = 0; t <= 8; ++t)
            if (equation.at(point_with(Residue{s}, Residue{t})) != Residue{}) return false;
    return true;
}

/// The linear form F of image lines, one for each view: its coefficients.
inline ResidueRow direction_form(const std::array<ResidueRow, 3>& line) {
    ResidueRow form;
    for (const auto& [v, w] : pairs) {
        const Residue height = line[3 - v - w][1];
        const ResidueRow &first = line[v], &second = line[w];
        form.push_back(height * first[0] * second[0]);
        form.push_back(height * first[0] * second[2]);
        form.push_back(-(height * first[2] * second[0]));
        form.push_back(height * first[2] * second[2]);
    }
    return form;
}

} // namespace proofs
