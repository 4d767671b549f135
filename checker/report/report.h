// What the checker makes of several files together, and how it is told. Nothing here is needed to
// trust a single certificate.
#pragma once

#include "checker/conclusion/judgement.h"
#include "checker/paper/claims.h"

namespace checker {
/// A label class whose degree is certified exactly.
struct ExactDegree {
    std::size_t number = 0;
    std::size_t degree = 0;
    std::string group{};   // of the solutions, see checker/conclusion/group.h
    std::string problem{}; // that represents the class
};

struct Report {
    Findings findings{};
    Judgement judgement{}; // of what was expected, or of all files
    std::vector<paper::Claim> claims{};
    std::vector<paper::FamilyTable> families{}; // none without a file of a family
    std::vector<paper::DegreeClaim> degrees{};  // none unless degrees are asked for or bounded
    std::vector<ExactDegree> exact{};
    /// Of the command: that of the findings, and at least 1 if what was expected is not verified.
    int status = 0;
};

/// Puts together what the files prove, and judges whether they prove what is expected.
/// `all_degrees`: also computes the degree of each class that is proved minimal, in ten seconds.
Report summarize(const Classification& classes, std::vector<ReplayedFile> files,
                 const Expectation& expectation = {}, bool all_degrees = false);

/// The file's kind as in its first line; empty if it is no certificate.
std::string_view kind_of(const ReplayedFile& file);

// A report in parts, each of whole lines. The first two are told as soon as a file is replayed.
std::string finding(const ReplayedFile& file);      // what it proves
std::string complaints(const ReplayedFile& file);   // what is refused, a line each
std::string lower_bounds(const ReplayedFile& file); // of degrees, each after a line feed
std::string objections(const Report& report);       // what is refused because of other files
std::string summary(const Report& report);          // fits a screen
std::string table(const Report& report);            // all bounds, counts and degrees
std::string errata(const Report& report); // each count that differs from the paper, with a witness
std::string why(const Report& report);    // the steps of the judgement
std::string conclusion(const Report& report); // one line: VERIFIED or NOT VERIFIED, and what

std::string text(const Report& report);       // all that plcheck prints without options
std::string complaints(const Report& report); // all that is refused
std::string json(const Report& report);
} // namespace checker
