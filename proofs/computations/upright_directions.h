// The variety of Theorems J and X: coordinates, and equations over the integers.
#pragma once

#include "proofs/computations/residue_matrices.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace proofs {

/// Pairs of views v, w. Each has four coordinates: S, g_w C, g_v C, g_v g_w S, with sine and cosine
/// of the angle from v to w.
using Pairs = std::vector<std::array<std::size_t, 2>>;

inline constexpr std::size_t coordinates_of_pair = 4;
inline const Pairs pairs{{0, 1}, {1, 2}, {2, 0}}; // of three views
inline constexpr std::size_t coordinates = 3 * coordinates_of_pair;

using Monomial = std::vector<std::size_t>; // coordinates, ascending
using Powers = std::vector<int>;           // of g_1, g_2, ...

inline std::size_t views_of(const Pairs& some) {
    std::size_t views = 0;
    for (const auto& [v, w] : some)
        views = std::max({views, v + 1, w + 1});
    return views;
}

/// A point of the variety, all g being 1: with the tangents of half of the angles from view 1 to
/// the others. Each coordinate is a polynomial of degree 2 in each tangent.
inline ResidueRow point_with(const Pairs& some, const ResidueRow& tangents) {
    const Residue one{1};
    ResidueRow sine{Residue{}}, cosine{one}, unit{one}; // times the unit
    for (const Residue t : tangents) {
        sine.push_back(t + t);
        cosine.push_back(one - t * t);
        unit.push_back(one + t * t);
    }
    ResidueRow point;
    for (const auto& [v, w] : some) {
        Residue others = one;
        for (std::size_t u = 0; u < unit.size(); ++u)
            if (u != v && u != w) others = others * unit[u];
        const Residue s = others * (sine[w] * cosine[v] - cosine[w] * sine[v]);
        const Residue c = others * (cosine[v] * cosine[w] + sine[v] * sine[w]);
        point.insert(point.end(), {s, c, c, s});
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

inline Powers powers_of(const Pairs& some, const Monomial& monomial) {
    Powers powers(views_of(some));
    for (const std::size_t coordinate : monomial) {
        const auto& [v, w] = some[coordinate / coordinates_of_pair];
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
std::vector<Equation> equations_of(const Pairs& some, std::size_t degree, Allowed allowed) {
    std::map<Powers, std::vector<Monomial>> by_powers;
    for (const Monomial& monomial : monomials(coordinates_of_pair * some.size(), degree))
        if (allowed(monomial)) by_powers[powers_of(some, monomial)].push_back(monomial);
    Residues random(2);
    std::vector<Equation> equations;
    for (const auto& [powers, terms] : by_powers) {
        ResidueMatrix values;
        for (std::size_t i = 0; i < terms.size(); ++i) {
            const ResidueRow point = point_with(some, random.row(views_of(some) - 1));
            values.emplace_back();
            for (const Monomial& term : terms)
                values.back().push_back(value(term, point));
        }
        for (const ResidueRow& row : kernel_of(values, terms.size())) {
            Equation& equation = equations.emplace_back();
            for (std::size_t i = 0; i < terms.size(); ++i)
                if (row[i] != Residue{}) {
                    equation.monomials.push_back(terms[i]);
                    equation.coefficients.push_back(row[i]);
                }
        }
    }
    return equations;
}

/// Whether the equations hold over the integers: if their coefficients are small, they are
/// polynomials in the tangents with coefficients below q. So it is enough that these are 0 modulo
/// q; and as they have at most twice the degree in each tangent, that they vanish where all are
/// numbers from 0 to that.
inline bool hold_over_the_integers(const Pairs& some, const std::vector<Equation>& equations) {
    const auto is_small = [](Residue a) {
        return a == Residue{1} || a == -Residue{1} || a == Residue{2} || a == -Residue{2};
    };
    std::size_t degree = 0;
    for (const Equation& equation : equations) {
        if (!std::ranges::all_of(equation.coefficients, is_small)) return false;
        degree = std::max(degree, equation.monomials.front().size());
    }
    const Residue end = Residue::of(2 * degree + 1);
    ResidueRow tangents(views_of(some) - 1);
    for (std::size_t place = 0; place < tangents.size();) {
        const ResidueRow point = point_with(some, tangents);
        for (const Equation& equation : equations)
            if (equation.at(point) != Residue{}) return false;
        for (place = 0; place < tangents.size(); ++place) { // count on, from the first place
            tangents[place] = tangents[place] + Residue{1};
            if (tangents[place] != end) break;
            tangents[place] = {};
        }
    }
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
