// What the checker makes of certificate files: bytes go in, a report comes out. Files are replayed
// as FORMAT.md, sections 6 and 7, says, and counts are derived from the certificates that hold.
#pragma once

#include "checker/problem.h"
#include "checker/reader.h"

#include <map>

namespace checker {
/// What a certificate proves: the obstruction of a class, which is minimal if there is none.
struct Verdict {
    std::size_t number, line; // of the label class; in the file
    Obstruction obstruction;
};

/// What a degree record proves: its class has at least so many solutions. That there are no more is
/// evidence, if that is complete.
struct Degree {
    std::size_t number, line, solutions;
    bool complete;
};

/// A type of registration problem (FORMAT.md, section 10): how many constraints of each kind.
using Registration = std::array<unsigned, 24>;

struct FileReport {
    std::string name{};                 // printable
    std::string kind{};                 // classification, problem, degrees, bounds, digests
    std::string sha256{}, digest{};     // of its bytes; what a list of digests says of these
    bool conforms = true;               // to FORMAT.md; if not, nothing is certified
    std::string problem{}, certified{}; // of a problem file that holds: its verdict, in words
    std::vector<Verdict> verdicts{};
    std::vector<Degree> degrees{};
    std::size_t templates = 0;                    // that hold
    std::vector<std::size_t> upper{};             // of the degree, by label class; 0 if none
    std::vector<Registration> types{};            // what gives it
    std::map<std::size_t, std::size_t> at_most{}; // how many terminal problems have this one
    std::vector<std::pair<std::string, std::string>> listed{}; // digests and names
    std::vector<std::string> unverified{};                     // names of files not given
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

/// The same of camera-degrees: numbers of problems, or the degree of one. Certified is what is at
/// least so much, and, where an upper bound meets it, what is exactly so much; known, what is that
/// by evidence, too.
struct DegreeClaim {
    std::string claim, paper, certified, exact, known, verdict;
    std::string witness{}; // a problem that is counted
};

struct Report {
    std::vector<FileReport> files{};
    std::vector<Claim> claims{};
    std::vector<DegreeClaim> degrees{};                       // none without a degree file
    std::vector<std::pair<std::size_t, std::size_t>> exact{}; // certified: classes and degrees
    int status = 0; // of the command: 0 every certificate holds, 1 one is refused, 2 syntax error
};

/// Replays the bytes of a file.
FileReport replay(const Classification& classes, std::string_view name, std::string_view bytes);

/// Derives the claims. A count is certified if every class has a certificate that holds. Refuses
/// verdicts that contradict each other, and files that have not the digests listed.
Report summarize(const Classification& classes, std::vector<FileReport> files);

std::string text(const Report& report);
std::string errata(const Report& report); // each count that differs from the paper, with a witness
std::string json(const Report& report);
std::string complaints(const Report& report);
} // namespace checker
