// What the paper claims beside what is certified, and how these compare.
#pragma once

#include "checker/conclusion/degree_bounds.h"
#include "checker/counts/counts.h"
#include "checker/family/problems_file.h"

#include <map>

namespace checker::paper {
/// The verdict where certificates do not decide whether a number differs from the paper's.
inline constexpr std::string_view not_covered = "not covered by these files";

/// A line of the table: a count of classes, or the verdict on a problem that has a name.
struct Claim {
    std::string claim{};
    std::string claimed{};   // - if the paper has none
    std::string certified{}; // - if not every class that it counts has a certificate
    std::string verdict{};
    std::string counted{}; // of a count that differs, if known: what is counted, with a witness
};

/// The same of camera-degrees: a number of problems with a degree, or the degree of one. Cells are
/// - where there is nothing to say.
struct DegreeClaim {
    std::string claim{};
    std::string claimed{};
    std::string at_least{}; // certified
    std::string exact{};    // certified
    std::string verdict{};
    std::string witness{}; // a problem that is counted
};

/// The lines on counts, then those on the problems with complete visibility.
std::vector<Claim> compare_counts(const Classification& classes, const Verdicts& verdicts);

/// A degree for which a paper only says that it is larger than a number.
struct FamilyDegree {
    std::string_view name;         // of the problem, as in the paper
    std::string_view problem;      // in notation
    std::size_t claimed_above = 0; // by the paper
    std::size_t at_least = 0;      // certified; 0 if nothing is
    std::size_t at_most = 0;       // certified; 0 if nothing is
    std::size_t evidence = 0;      // what certs/family-degrees.csv has
    std::string_view verdict{};
};

/// States how many solutions are certified at least and at most, and compares.
void set_certified(FamilyDegree& degree, std::size_t at_least, std::size_t at_most);

/// The numbers of a family of problems in general, beside those of its paper.
struct FamilyTable {
    std::string family{}; // its name in FORMAT.md, section 13
    std::vector<Claim> claims{};
    std::vector<FamilyDegree> degrees{};
    std::map<std::size_t, std::size_t> lower_bounds{}; // of degrees: how many problems have each
    std::size_t exact = 0;                             // how many degrees are certified exactly
    std::size_t exact_by_theorem = 0;                  // of these, by theorem
    std::map<std::string, std::string> groups{};       // of these, by problem, if certified
};

/// The lines on a family; none unless the file has all its problems.
FamilyTable compare_family(const ProblemsFile& file);

/// What is to be compared with the paper's degrees.
struct KnownDegrees {
    const Classification& classes;
    const Verdicts& verdicts;
    const DegreeTable& table;
    std::size_t relative_poses; // of five points: an upper bound; 0 if there is none
};

/// The lines on single problems that are proved minimal, then, if all classes have verdicts, those
/// on the numbers of terminal problems with a degree.
std::vector<DegreeClaim> compare_degrees(const KnownDegrees& known);

/// What is known of the degree of a class.
DegreeBounds bounds_of(const KnownDegrees& known, std::size_t number);
} // namespace checker::paper
