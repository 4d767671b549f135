// What classification and problem files have in common (FORMAT.md, section 5): coordinates, and the
// records `minimal` and `deficient`, replayed on the blocks of a problem.
#pragma once

#include "checker/jacobian.h"
#include "checker/report.h"

namespace checker {
/// Takes the head of a pool: its number, and cameras 2 and 3. In two views camera 3 has no line; as
/// nothing is seen in its view, any will do.
Numbers read_cameras(Reader& reader, std::size_t pool, unsigned views);

/// Takes the rest of a feature line: the point and the directions of so many pins.
Numbers read_vectors(Reader& reader, unsigned pins);

/// Takes strictly ascending numbers, up to the word `columns` or the end of the line.
Numbers read_ascending(Reader& reader, std::int64_t largest);

/// A record as written; the lists of a `minimal` one are empty.
struct Record {
    std::size_t line = 0;
    Numbers stated{}, rows{}, columns{}; // stated: rank, excesses, star
    Residue minor{};
    std::vector<Motion> kernel{};
};

/// Takes what follows the pool of a record; of a `minimal` one, that is the minor.
Record read_record(Reader& reader, bool minimal);

/// Throws Refused unless the record holds for the balanced problem of these blocks, with this
/// obstruction. `absent` are the camera columns that it lacks, in two views.
void check_record(const Record& record, const Obstruction& truth,
                  const std::vector<const Block*>& blocks, const Numbers& absent);

/// Replays a file of this kind after its first line.
void replay_classification(Reader& reader, const Classification& classes, FileReport& report);
void replay_problem(Reader& reader, const Classification& classes, FileReport& report);
void replay_degrees(Reader& reader, const Classification& classes, FileReport& report);
void replay_bounds(Reader& reader, const Classification& classes, FileReport& report);
} // namespace checker
