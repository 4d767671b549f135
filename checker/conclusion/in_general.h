// What the files of a run prove of problems in general (FORMAT.md, section 13).
#pragma once

#include "checker/conclusion/findings.h"
#include "checker/family/by_problem.h"

namespace checker {
/// A verdict on a problem, and the file that proves it.
struct ProvedInGeneral {
    bool minimal = false;
    std::string file{};
};

/// What records of verdicts prove of each problem, or else records of solutions.
ByProblem<ProvedInGeneral> verdicts_in_general(const Findings& findings);

/// So many solutions a problem has at least, and the file that counts solutions. Theorem G may say
/// that there are more than it counts.
struct CountedInGeneral {
    std::size_t solutions = 0;
    std::size_t counted = 0;
    std::string file{};
    std::string notation{}; // of the problem, in that file
    std::vector<CycleType> cycle_types{};
};

/// The most that any record proves for each problem, by the problem without its implied lines.
ByProblem<CountedInGeneral> counts_in_general(const Findings& findings);

/// The same for one problem; 0 if no record is about it.
CountedInGeneral count_in_general(const Findings& findings, const Problem& problem);

/// So many solutions a minimal problem has at most. A theorem proves it, or else a file.
struct BoundedInGeneral {
    std::size_t at_most = 0;
    std::string_view theorem{};
    std::string file{};
    std::string notation{}; // of the problem, in that file
    bool attained = false;  // whether the theorem says that there are exactly so many
    std::string reason{};   // then, if the theorem is not on label classes
};

/// The least that any record says for each problem, by the problem without its implied lines.
ByProblem<BoundedInGeneral> bounds_in_general(const Findings& findings);

UpperBound upper_bound(const BoundedInGeneral& bound);

/// The least that the theorems or any record say; none if they do not speak of the problem. Theorem
/// D takes seconds, so it speaks here alone.
std::optional<BoundedInGeneral> bound_in_general(const Findings& findings, const Problem& problem);

/// Whether a minimal problem is that of five points in two calibrated views: Proposition P6 of
/// proofs/five_shared_points.md says how its solutions are permuted.
bool is_five_point_problem(const Problem& problem);

/// Files of solutions that count more than a theorem or a file of upper bounds allows, and these
/// files of upper bounds. (A problem with solutions that are counted is minimal.)
Contradictions contradictions_in_general(const Findings& findings);

/// What is known of the degrees of the minimal problems of a file.
struct DegreesInGeneral {
    std::map<std::size_t, std::size_t> at_least{}; // how many problems have each lower bound
    std::size_t exact = 0;                         // of how many bounds meet
    std::size_t exact_by_theorem = 0;              // of these, by theorem
    std::map<std::string, std::string> groups{};   // of these, by problem, as fibres or P6 say
};

DegreesInGeneral degrees_of(const Findings& findings, const ProblemsFile& problems);

/// The file that has all problems of a family; null if none does.
const ReplayedFile* file_of_family(const Findings& findings, std::string_view family);
} // namespace checker
