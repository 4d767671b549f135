// What the files of a run prove together: which of them count, the verdicts on classes, and what
// is known of degrees (FORMAT.md, sections 6, 10 and 11).
#pragma once

#include "checker/bounds/degree_bounds.h"
#include "checker/counts/counts.h"
#include "checker/replay.h"

namespace checker {
/// What the comparison of a file with the others adds.
struct Comparison {
    std::string digest{};             // what a list says of the file's digest; empty if none does
    std::size_t listed = 0;           // of a list: the files given that it lists
    std::size_t listed_not_given = 0; // of a list: the names that no file given has
    std::vector<std::string> not_given{};  // the first of these names
    std::vector<std::string> objections{}; // why the file is refused, whatever it proves alone
};

struct Findings {
    std::vector<ReplayedFile> files{};
    std::vector<Comparison> comparisons{}; // of the files, in the same order
    Verdicts verdicts{};
    RegistrationBounds registrations{}; // upper bounds by templates
    bool has_lower_bounds = false;
    DegreeTable degrees{};
    int status = 0; // 0 every file holds, 1 one or a record is refused, 2 one is no certificate

    /// Whether what a file proves counts.
    bool counts(std::size_t file) const { return comparisons[file].objections.empty(); }
};

/// Puts together what the files prove.
Findings find(const Classification& classes, std::vector<ReplayedFile> files);

/// The refusals of a file's records; none if it has no records, or does not conform.
const Refusals& refusals_of(const ReplayedFile& file);

/// 0 if the file holds, 1 if it or a record of it is refused, 2 if it is no certificate.
int status_of(const Findings& findings, std::size_t file);
} // namespace checker
