// Eliminations: multiples of a model's equations that express all monomials up to a degree by those
// of a basis (FORMAT.md, section 16). They prove upper bounds on the number of solutions.
#pragma once

#include "checker/model/fibre.h"
#include "checker/model/sparse_polynomial.h"

namespace checker {
struct Elimination {
    /// The degree in the variables of some names is bounded.
    struct Group {
        int degree = 0;
        std::vector<std::string> names{};
    };
    struct Rows {
        std::size_t equation = 0; // from 0
        Numbers monomials{};      // from 1
    };
    std::vector<Residue> data{};
    std::vector<Group> groups{};
    Numbers basis{}; // monomials, from 1
    std::vector<Rows> rows{};
    Residue minor{};
};

Elimination read_elimination(Reader& reader, const Layout& layout);

/// The bound that the elimination proves. Throws Refused.
std::size_t check_elimination(const Program& program, const Layout& layout,
                              const Elimination& elimination,
                              const SparsePolynomials<Residue>::Spend& spend);
} // namespace checker
