// The Jacobian J of the joint camera map at the point that a pool describes (FORMAT.md, sections 2,
// 3). A feature's rows of J involve its own unknowns and the 11 camera unknowns only. So each
// feature is eliminated once, which leaves `weight` rows on the camera unknowns, and a problem is
// 11 such rows.
#pragma once

#include "checker/modular.h"
#include "checker/problem.h"
#include "checker/reader.h"

#include <gmpxx.h>

#include <span>

namespace checker {

/// Why a certificate does not hold; thrown where this is found.
struct Refused {
    std::string reason;
};

/// One instance of a feature. Its own unknowns have the first columns of its rows, the cameras 11
/// more.
struct Block {
    std::size_t unknowns = 0;
    Matrix<mpz_class> rows{};       // of J
    Matrix<mpz_class> conditions{}; // on a motion of the cameras, for the feature to move with it
    Matrix<Residue> residues{};     // the conditions, scaled: det J is their determinant times
    Residue factor{}; // the factors of all blocks, up to sign; if one is 0, so is det J
};

/// The rows of a feature: a point (on a free line) and directions, `vectors`; `cameras` 2 and 3,
/// each a quaternion and a translation. Throws Refused if these violate a requirement of section 2.
Matrix<mpz_class> jacobian_rows(const Feature& feature, const std::vector<Numbers>& vectors,
                                const std::array<Numbers, 2>& cameras);

/// Eliminates the first `unknowns` columns, with pivots that are nonzero modulo q.
Block eliminate(std::size_t unknowns, const Matrix<mpz_class>& rows);

/// The minor, modulo q, of the J of a balanced problem of these features, in order. It leaves out
/// `rows` of J and camera `columns`: equally many, strictly ascending, within J, numbered from 1.
Residue minor(const std::vector<const Block*>& blocks, std::span<const std::int64_t> rows,
              std::span<const std::int64_t> columns);

/// A motion of the cameras, in the order of the camera columns.
using Motion = std::array<mpz_class, camera_unknowns>;

/// Whether the feature can move with the cameras so that its images stay.
bool allows(const Block& block, const Motion& motion);

} // namespace checker
