// What classification and problem files have in common: the pools of section 5 of FORMAT.md and
// the evidence of a record, replayed on the blocks of a problem.
#pragma once

#include "checker/jacobian.h"
#include "checker/report.h"

namespace checker {

using Cameras = std::array<Numbers, 2>; // 2 and 3: quaternion and translation

template <class... Part>
[[noreturn]] void refuse(const Part&... reason) {
    throw Refused{say(reason...)};
}

/// Takes the head of a pool: its number and its cameras. In two views camera 3 has no line.
Cameras read_cameras(Reader& reader, std::size_t pool, unsigned views);

/// Takes the rest of a feature line: the point and the directions of so many pins.
std::vector<Numbers> read_vectors(Reader& reader, unsigned pins);

/// Takes strictly ascending numbers, up to the word `columns` or the end of the line.
Numbers read_ascending(Reader& reader, std::int64_t largest);

/// Takes a residue that is not 0, and the end of the line.
Residue read_minor(Reader& reader);

/// A record `minimal` or `deficient` as it is written; if `minimal`, the lists are empty.
struct Record {
    std::size_t line = 0;
    Numbers stated{}, rows{}, columns{}; // stated: rank, excesses, star
    Residue minor{};
    std::vector<Motion> kernel{};
};

/// Takes what follows the pool of a record.
Record read_record(Reader& reader, bool minimal);

/// Refuses the record unless it holds for the balanced problem of these blocks, whose obstruction
/// is `truth`. `absent` are camera columns that the problem does not have, for want of a view.
void check_record(const Record& record, const Obstruction& truth,
                  const std::vector<const Block*>& blocks, const Numbers& absent);

/// Replays the rest of a file of this kind, after the first line.
void replay_classification(Reader& reader, const Classification& classes, FileReport& report);
void replay_problem(Reader& reader, const Classification& classes, FileReport& report);

} // namespace checker
