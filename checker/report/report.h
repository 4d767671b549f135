// What the checker makes of several files together, and how it is told. Nothing here is needed to
// trust a single certificate.
#pragma once

#include "checker/paper/claims.h"
#include "checker/replay.h"

namespace checker {
/// What the comparison of a file with the others adds.
struct Comparison {
    std::string digest{}; // what a list says of the file's digest; empty if none does
    std::vector<std::string> not_given{};  // of a list: the names of files that were not given
    std::vector<std::string> objections{}; // why the file is refused, whatever it proves alone
};

/// How many terminal problems have an upper bound.
struct UpperBoundCount {
    std::size_t solutions = 0; // at most
    std::size_t by_templates = 0;
    std::size_t by_theorem = 0;
};

/// A label class whose degree is certified exactly.
struct ExactDegree {
    std::size_t number = 0;
    std::size_t degree = 0;
};

struct Report {
    std::vector<ReplayedFile> files{};
    std::vector<Comparison> comparisons{}; // of the files, in the same order
    std::vector<paper::Claim> claims{};
    std::vector<UpperBoundCount> upper_bounds{}; // none without a file of upper bounds
    std::vector<paper::DegreeClaim> degrees{};   // none without a degree file
    std::vector<ExactDegree> exact{};
    int status = 0; // of the command: 0 every certificate holds, 1 one is refused, 2 syntax error
};

/// Puts together what the files prove.
Report summarize(const Classification& classes, std::vector<ReplayedFile> files);

/// The refusals of a file's records; none if it has no records, or does not conform.
const Refusals& refusals_of(const ReplayedFile& file);

/// The file's kind as in its first line, or `digests`; empty if it does not conform.
std::string_view kind_of(const ReplayedFile& file);

std::string text(const Report& report);
std::string errata(const Report& report); // each count that differs from the paper, with a witness
std::string json(const Report& report);
std::string complaints(const Report& report); // what is refused, a line each
} // namespace checker
