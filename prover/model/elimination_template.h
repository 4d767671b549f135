// An elimination as a template for a solver: with real data in place of random residues, its matrix
// gives the multiplication by a variable, and the eigenvectors of that are the solutions (Kukelova,
// Bujnak and Pajdla, Automatic generator of minimal problem solvers, 2008).
#pragma once

#include "prover/model/certificate.h"
#include "prover/model/data_polynomial.h"
#include "prover/model/monomial.h"

#include <string>
#include <vector>

namespace plprove::model {

/// Columns are numbered: first those that the rows eliminate, as many as there are rows; then the
/// basis; and one more for all other monomials, which cancel in what is needed of the rows.
struct EliminationTemplate {
    struct Equation {
        std::vector<Monomial> monomials;
        std::vector<std::size_t> coefficients; ///< steps of the program, one a monomial
    };
    /// A multiple of an equation: the columns of its terms.
    struct Row {
        std::size_t equation = 0;
        std::vector<std::size_t> columns;
    };
    /// A variable, times an integer: the columns of its products with the monomials of the basis.
    struct Multiplication {
        std::size_t variable = 0;
        int factor = 1;
        std::vector<std::size_t> products;
    };

    std::vector<Named> variables; ///< in their order
    DataProgram program;
    std::vector<Equation> equations;
    std::vector<Row> rows;
    std::vector<Monomial> basis;
    std::vector<Multiplication> action;        ///< the sum tells the solutions apart
    std::vector<std::size_t> variable_columns; ///< one a scalar of the variables
    std::size_t column_of_1 = 0;

    std::size_t columns() const { return rows.size() + basis.size(); }
};

/// Throws BadInput if the model has no elimination, or one whose basis is larger than the number of
/// solutions that the fibre has.
EliminationTemplate make_template(const Study& study);

} // namespace plprove::model
