// What the files of a run prove together: which of them count, the verdicts on classes, and what
// is known of degrees (FORMAT.md, sections 6 and 10).
#pragma once

#include "checker/conclusion/degree_bounds.h"
#include "checker/counts/counts.h"
#include "checker/replay.h"

namespace checker {
struct Findings {
    std::vector<ReplayedFile> files{};
    /// Of each file, why it is refused, whatever it proves alone.
    std::vector<std::vector<std::string>> objections{};
    Verdicts verdicts{};
    RegistrationBounds registrations{}; // upper bounds by models
    DegreeTable degrees{};
    int status = 0; // 0 every file holds, 1 one or a record is refused, 2 one is no certificate

    /// Whether what a file proves counts.
    bool counts(std::size_t file) const { return objections[file].empty(); }
};

/// Files that contradict others or a theorem, and why: of each the first reason that is found.
using Contradictions = std::map<std::size_t, std::string>;

/// What the files prove, but for degrees.
Findings find(const Classification& classes, std::vector<ReplayedFile> files);

/// Adds what follows of degrees, and refuses files whose bounds contradict each other or a theorem.
void add_degrees(Findings& findings, const Classification& classes, const AskedDegrees& asked);

/// The refusals of a file's records; none if it has no records, or does not conform.
const Refusals& refusals_of(const ReplayedFile& file);

/// 0 if the file holds, 1 if it or a record of it is refused, 2 if it is no certificate.
int status_of(const Findings& findings, std::size_t file);
} // namespace checker
