// What the checker makes of certificate files: bytes go in, a report comes out. Files are replayed
// as FORMAT.md, sections 6 and 7, says, and counts are derived from the certificates that hold.
#pragma once

#include "checker/problem.h"
#include "checker/reader.h"

namespace checker {
/// What a certificate proves: the obstruction of a class, which is minimal if there is none.
struct Verdict {
    std::size_t number, line; // of the label class; in the file
    Obstruction obstruction;
};

struct FileReport {
    std::string name{};                 // printable
    bool conforms = true;               // to sections 5 and 7; if not, nothing is certified
    std::string problem{}, certified{}; // of a problem file that holds: its verdict, in words
    std::vector<Verdict> verdicts{};
    std::size_t refused = 0;
    std::vector<Complaint> complaints{}; // the first refusals; or the violation of section 5
    void refuse(std::size_t line, std::string reason) {
        if (refused++ < 20) complaints.push_back({line, std::move(reason)});
    }
};

/// A line of the table: what the paper says, what the certificates say, and how these compare.
struct Claim {
    std::string claim, paper, certified, verdict;
};

struct Report {
    std::vector<FileReport> files{};
    std::vector<Claim> claims{};
    int status = 0; // of the command: 0 every certificate holds, 1 one is refused, 2 syntax error
};

/// Replays the bytes of a file.
FileReport replay(const Classification& classes, std::string_view name, std::string_view bytes);

/// Derives the claims. A count is certified if every class has a certificate that holds. Refuses
/// verdicts that contradict each other.
Report summarize(const Classification& classes, std::vector<FileReport> files);

std::string text(const Report& report);
std::string errata(const Report& report); // each count that differs from the paper, with a witness
std::string json(const Report& report);
std::string complaints(const Report& report);
} // namespace checker
