// The records `minimal` and `deficient` of classification and problem files (FORMAT.md, section 5),
// replayed on the blocks of a problem.
#pragma once

#include "checker/minimal/obstruction.h"
#include "checker/minimal/pool.h"

namespace checker {
/// Takes strictly ascending numbers, up to the word `columns` or the end of the line.
Numbers read_ascending(Reader& reader, int largest);

/// A record as written. A `minimal` one has a minor only.
struct Record {
    std::size_t line = 0;
    bool minimal = true;
    Numbers stated{}; // rank, excesses, S
    Numbers deleted_rows{};
    Numbers deleted_columns{};
    Residue minor{};
    Rows<mpz_class> kernel{}; // motions of the cameras, 11 coordinates each
};

/// Takes what follows the pool of a record.
Record read_record(Reader& reader, bool minimal);

/// The minor that is left of the J of these contributions, modulo q. Throws Refused if J lacks a
/// row that the record deletes.
Residue minor_without(const Record& record, const std::vector<const Contribution*>& contributions,
                      std::size_t camera_columns);

/// Throws Refused unless the record holds for the balanced problem of these contributions of
/// features, with this obstruction. In two views the cameras have 5 columns.
void check_record(const Record& record, const Obstruction& obstruction,
                  const std::vector<const Contribution*>& contributions,
                  std::size_t camera_columns = 11);
} // namespace checker
