// Blocks of J. The rows of a component of the scene (a feature, or features that share lines)
// involve its own unknowns and those of the cameras only. So each component is eliminated once;
// what its blocks leave of J has the columns of the cameras alone.
#pragma once

#include "checker/minimal/jacobian.h"

namespace checker {
/// What is left of J, or of a component, modulo q when its own unknowns are eliminated.
struct Block {
    std::size_t unknowns = 0;
    Rows<Residue> left{}; // by camera columns
    /// The determinant of what all blocks leave, times their factors, is det J up to sign.
    Residue factor{};

    std::size_t rows() const { return unknowns + left.size(); } // of J
};

/// Eliminates the own unknowns, the first `unknowns` columns. The block has factor 0 if they are
/// dependent.
Block eliminate(std::size_t unknowns, Rows<Residue> rows);

/// The minor of J modulo q of these blocks, in order, without these camera columns, numbered from 1
/// and ascending: the matrix that is left must be square, or the minor is 0.
Residue minor_of(const std::vector<const Block*>& blocks, std::size_t camera_columns,
                 const Numbers& deleted_columns = {});

/// det J modulo q, of a balanced problem.
Residue jacobian_determinant(const Problem& problem, const Placement& placement);

/// What the motions of the cameras satisfy with which a component can move along and keep its
/// images: coefficients, by camera columns. Over the integers.
Rows<mpz_class> conditions_on_cameras(std::size_t unknowns, Rows<mpz_class> rows);

/// The same matrix modulo q.
Rows<Residue> modulo_q(const Rows<mpz_class>& rows);

/// What a component of the scene contributes to J.
struct Component {
    Rows<mpz_class> rows{}; // of J: own columns, then those of the cameras
    /// Of the motions of the cameras with which it can move along; none if its own columns are
    /// dependent modulo q, and the block has factor 0.
    Rows<mpz_class> conditions{};
    Block block{};
};

Component component_of(std::size_t unknowns, Rows<mpz_class> rows);
} // namespace checker
