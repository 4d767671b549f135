// Records: each decides whether one problem is minimal. FORMAT.md has two ways to write them, in
// section 5 and in section 13; record_lines.h takes both.
#pragma once

#include "checker/minimal/block.h"
#include "checker/minimal/obstruction.h"
#include "checker/reasons/part.h"

#include <variant>

namespace checker {
/// J has a minor that is not 0. If the minor leaves out rows and columns, as many motions of the
/// cameras keep all images, so that its rank is not larger; else the problem is minimal.
struct MinorClaim {
    Residue minor{};
    Numbers stated{}; // rank, excesses and S; none for a minimal problem
    Numbers deleted_rows{};
    Numbers deleted_columns{}; // of the cameras
    Rows<mpz_class> kernel{};  // motions of the cameras
    Placement placement{};     // where J is taken; empty if a pool says so
};

/// Not minimal: the problem is not balanced.
struct UnbalancedClaim {};

struct Record {
    std::size_t line = 0;
    std::variant<MinorClaim, UnbalancedClaim, CollinearClaim, PartClaim> claim{};

    bool minimal() const {
        const auto* minor = std::get_if<MinorClaim>(&claim);
        return minor && minor->stated.empty();
    }
};

/// The minor that is left of the J of these components, modulo q. Throws Refused if J lacks a row
/// that the claim deletes.
Residue minor_without(const MinorClaim& claim, const std::vector<const Component*>& components,
                      std::size_t camera_columns);

/// Throws Refused unless the claim holds for the balanced problem of these components, with this
/// obstruction. In two views the cameras have 5 columns.
void check_claim(const MinorClaim& claim, const Obstruction& obstruction,
                 const std::vector<const Component*>& components,
                 std::size_t camera_columns = camera_unknowns);

/// Throws Refused unless the record, which has its own placement, proves what it claims.
void check_record(const Record& record, const Problem& problem);
} // namespace checker
