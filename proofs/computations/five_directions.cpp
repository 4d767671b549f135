// What Theorem J needs computed (proofs/upright_focal_views.md, sections 6 and 8): the degree of a
// variety in a projective space of dimension 11 is at most 62; and where all lines through a point
// satisfy its equation the variety has the dimension 1 at most. Modulo q = 2^61 - 1. From the
// folder that holds checker/ and proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/five_directions.cpp -lgmp -o five_directions
//
// Each line of the output is a fact; exit status 1 if one fails.
#include "proofs/computations/report.h"
#include "proofs/computations/upright_directions.h"

#include <algorithm>
#include <array>
#include <string>

namespace {

using namespace proofs;

/// At a point of a linear space, given by numbers z and its coordinates: all products of an
/// equation and a monomial in z that have this degree.
ResidueRow multiples_at(const std::vector<Equation>& equations, const ResidueRow& values,
                        const ResidueRow& z, std::size_t degree) {
    ResidueRow row;
    for (const Equation& equation : equations) {
        const Residue factor = equation.at(values);
        for (const Monomial& other : monomials(z.size(), degree - equation.monomials[0].size()))
            row.push_back(factor * value(other, z));
    }
    return row;
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
        ResidueRow values;
        for (const ResidueRow& form : linear_forms)
            values.push_back(product(form, z));
        ResidueRow row = multiples_at(equations, values, z, degree);
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
    for (std::size_t choice = 0; choice < 8; ++choice)
        forms.push_back(direction_form(
            {lines[0][choice & 1], lines[1][choice >> 1 & 1], lines[2][choice >> 2]}));
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
        multiples.push_back(multiples_at(equations, values, z, degree));
    }
    return {space.size() - 1, rank_of(multiples)};
}
} // namespace

int main() {
    Report report;
    std::vector<Equation> equations;
    for (const std::size_t degree : {3U, 4U}) {
        const std::vector<Equation> found =
            equations_of(pairs, degree, [](const Monomial&) { return true; });
        report(hold_over_the_integers(pairs, found),
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
