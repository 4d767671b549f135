// What Theorem J needs computed (proofs/upright_focal_views.md, sections 6 and 8): the degree of a
// variety in a projective space of dimension 11 is at most 62; and where all lines through a point
// satisfy its equation the variety has the dimension 1 at most. Modulo q = 2^61 - 1. From the
// folder that holds checker/ and proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/five_directions.cpp -lgmp -o five_directions
//
// Each line of the output is a fact; exit status 1 if one fails.
#include "proofs/computations/report.h"
#include "proofs/computations/residue_matrices.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>

namespace {

using namespace proofs;

/// The coordinates of each pair of views v, w: S, g_w C, g_v C, g_v g_w S, with sine and cosine of
/// an angle.
constexpr std::array<std::array<std::size_t, 2>, 3> pairs{{{0, 1}, {1, 2}, {2, 0}}};
constexpr std::size_t coordinates = 4 * pairs.size();

using Point = std::array<Residue, coordinates>;
using Monomial = std::vector<std::size_t>; // coordinates, ascending
using Powers = std::array<int, 3>;         // of g_1, g_2, g_3

/// A point of the variety, all g being 1: with the tangents s and t of half of the angles from view
/// 1 to 2 and from 2 to 3. Each coordinate is a polynomial of degree 2 in s and in t.
Point point_with(Residue s, Residue t) {
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
std::vector<Monomial> monomials(std::size_t things, std::size_t degree, std::size_t from = 0) {
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

Powers powers_of(const Monomial& monomial) {
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

/// All equations of the variety of this degree, as far as some of its points modulo q show.
std::vector<Equation> equations_of(std::size_t degree) {
    std::map<Powers, std::vector<Monomial>> by_powers;
    for (const Monomial& monomial : monomials(coordinates, degree))
        by_powers[powers_of(monomial)].push_back(monomial);
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
bool holds_over_the_integers(const Equation& equation) {
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

/// On a linear section, where the coordinates are linear forms in seven numbers: how many forms of
/// degree 5 there are, the rank of multiples of equations among them, and that of these and of all
/// products with the first number. Forms are given by their values at as many points.
struct Section {
    std::size_t forms = 0, multiples = 0, all = 0;
};

Section section_of(const std::vector<Equation>& equations) {
    constexpr std::size_t numbers = 7, degree = 5;
    Residues random(1);
    const ResidueMatrix linear_forms = random.matrix(coordinates, numbers);
    const std::size_t forms = monomials(numbers, degree).size();
    ResidueMatrix multiples, all; // a row for each point
    for (std::size_t i = 0; i < forms; ++i) {
        const ResidueRow z = random.row(numbers);
        ResidueRow values, row;
        for (const ResidueRow& form : linear_forms)
            values.push_back(product(form, z));
        for (const Equation& equation : equations) {
            const Residue factor = equation.at(values);
            for (const Monomial& other : monomials(numbers, degree - equation.monomials[0].size()))
                row.push_back(factor * value(other, z));
        }
        multiples.push_back(row);
        for (const Monomial& other : monomials(numbers, degree - 1))
            row.push_back(z[0] * value(other, z));
        all.push_back(row);
    }
    return {forms, rank_of(multiples), rank_of(all)};
}

/// The linear forms F of triples of image lines through given points, one for each view: those of a
/// basis.
ResidueMatrix forms_of_lines_through(const ResidueMatrix& points) {
    std::array<ResidueMatrix, 3> lines;
    for (std::size_t v = 0; v < 3; ++v)
        lines[v] = kernel_of({points[v]}, 3);
    ResidueMatrix forms;
    for (std::size_t choice = 0; choice < 8; ++choice) {
        const auto line = [&](std::size_t v) -> const ResidueRow& {
            return lines[v][choice >> v & 1];
        };
        ResidueRow& form = forms.emplace_back();
        for (const auto& [v, w] : pairs) {
            const Residue height = line(3 - v - w)[1];
            const ResidueRow &first = line(v), &second = line(w);
            form.push_back(height * first[0] * second[0]);
            form.push_back(height * first[0] * second[2]);
            form.push_back(-(height * first[2] * second[0]));
            form.push_back(height * first[2] * second[2]);
        }
    }
    return forms;
}

/// Where all these linear forms vanish: the dimension, and the rank of the multiples of degree 4 of
/// the equations on a plane, among all 15 forms.
struct Base {
    std::size_t dimension = 0, multiples = 0;
};

Base base_of(const std::vector<Equation>& equations) {
    constexpr std::size_t numbers = 3, degree = 4, forms = 15;
    Residues random(3);
    const ResidueMatrix space = kernel_of(forms_of_lines_through(random.matrix(3, 3)), coordinates);
    const ResidueMatrix plane = product(random.matrix(numbers, space.size()), space);
    ResidueMatrix multiples; // a row for each point
    for (std::size_t i = 0; i < forms; ++i) {
        const ResidueRow z = random.row(numbers);
        const ResidueRow values = product({z}, plane)[0];
        ResidueRow& row = multiples.emplace_back();
        for (const Equation& equation : equations) {
            const Residue factor = equation.at(values);
            for (const Monomial& other : monomials(numbers, degree - equation.monomials[0].size()))
                row.push_back(factor * value(other, z));
        }
    }
    return {space.size() - 1, rank_of(multiples)};
}
} // namespace

int main() {
    Report report;
    std::vector<Equation> equations;
    for (const std::size_t degree : {3U, 4U}) {
        const std::vector<Equation> found = equations_of(degree);
        report(std::ranges::all_of(found, holds_over_the_integers),
               std::to_string(found.size()) + " equations of degree " + std::to_string(degree));
        equations.insert(equations.end(), found.begin(), found.end());
    }
    const Section section = section_of(equations);
    const std::size_t left = section.forms - section.multiples;
    report(left == 62, "of " + std::to_string(section.forms) +
                           " forms of degree 5 on a linear section, " + std::to_string(left) +
                           " are left");
    report(section.all == section.forms,
           "with the products of a linear form and forms of degree 4 these are all");
    const Base base = base_of(equations);
    report(base.dimension == 4 && base.multiples == 15,
           "where lines through a point satisfy their equations, in a space of dimension " +
               std::to_string(base.dimension) + ", a plane meets the variety nowhere");
    return report.status();
}
