// The Jacobian J of the joint camera map at the point that a pool describes (FORMAT.md, sections 2,
// 3). A feature's rows of J involve its own unknowns and the 11 camera unknowns only. So each
// feature is eliminated once, which leaves `weight` rows on the camera unknowns; a problem is 11
// such rows.
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

/// A motion of the cameras, or a linear condition on it, in the order of the camera columns.
using Motion = std::array<mpz_class, camera_unknowns>;
using Rows = std::vector<std::vector<mpz_class>>;

/// One instance of a feature: its rows of J, its own unknowns before those of the cameras.
struct Block {
    std::size_t unknowns = 0;
    Rows rows{};
    std::vector<Motion> conditions{}; // for the feature to move with the cameras
    std::vector<std::array<Residue, 11>>
        residues{};   // the conditions, scaled: det J is, up to sign,
    Residue factor{}; // the product of all factors and the determinant of these
};

/// The rows of a feature: a point (on a free line) and directions, `vectors`; `cameras` 2 and 3,
/// each a quaternion and a translation. Throws Refused if these violate a requirement of section 2.
Rows jacobian_rows(const Feature& feature, const std::vector<Numbers>& vectors,
                   const std::array<Numbers, 2>& cameras);

/// Eliminates the first `unknowns` columns, with pivots that are nonzero modulo q.
Block eliminate(std::size_t unknowns, Rows rows);

/// The minor, modulo q, of the J of a balanced problem of these features, in order. It leaves out
/// `rows` of J and camera `columns`: equally many, strictly ascending, within J, numbered from 1.
Residue minor(const std::vector<const Block*>& blocks, std::span<const std::int64_t> rows,
              std::span<const std::int64_t> columns);

} // namespace checker
