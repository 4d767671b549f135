// The records `minimal` and `deficient` of classification and problem files (FORMAT.md, section 5),
// replayed on the blocks of a problem.
#pragma once

#include "checker/classification/block.h"
#include "checker/problem/obstruction.h"

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
    std::vector<CameraMotion> kernel{};
};

/// Takes what follows the pool of a record.
Record read_record(Reader& reader, bool minimal);

/// Throws Refused unless the record holds for the balanced problem of these blocks, with this
/// obstruction. `absent` are the camera columns that the problem lacks, in two views.
void check_record(const Record& record, const Obstruction& obstruction,
                  const std::vector<const Block*>& blocks, const Numbers& absent);
} // namespace checker
