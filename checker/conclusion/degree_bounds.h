// What lower and upper bounds together say of the degrees (FORMAT.md, section 10). Here theorems
// are applied, and only to classes that are proved minimal.
#pragma once

#include "checker/degrees/degree_file.h"
#include "checker/exactly/degree.h"
#include "checker/registration/registration.h"

#include <optional>
#include <variant>

namespace checker {
/// An upper bound by theorem, named as in proofs/.
struct ByTheorem {
    std::string_view theorem{};
};

/// A record of a file of upper bounds (FORMAT.md, section 15).
struct ByForms {};

struct UpperBound {
    std::size_t solutions = 0; // at most
    std::variant<Registration, ByTheorem, ByForms> by{};
};

/// What is known of the camera-degree of a constraint class.
struct DegreeBounds {
    std::size_t at_least = 0; // by records, or by theorem
    std::size_t counted = 0;  // by records alone
    std::optional<UpperBound> at_most{};
    std::optional<exactly::Degree> theorem{}; // what it says; none if it was not asked
    std::vector<CycleType> cycle_types{};     // of permutations of solutions, by fibres
    /// The same, with matrices of two views of which a theorem says that there are so few.
    std::vector<BlockCycles> block_cycles{};
    std::string_view group_theorem{}; // that says the group, S or P; empty if none

    bool exact() const { return at_most && at_most->solutions == at_least; }
};

/// By constraint class. Classes without any bound are absent.
using DegreeTable = std::map<Signature, DegreeBounds>;

/// The bounds of files: lower ones, and those by models, which are applied to the label classes
/// that are `minimal`, by their numbers.
DegreeTable bounds_by_files(const Classification& classes, const std::vector<bool>& minimal,
                            const std::vector<LowerBound>& lower, const RegistrationBounds& upper);

/// What is asked of the theorems, beside the classes that files bound: each degree takes time.
struct AskedDegrees {
    bool all = false;                           // all classes that are proved minimal
    std::optional<std::size_t> minimal_class{}; // this label class, which is minimal
};

/// Adds what theorems say of the classes that are `minimal`.
void add_theorems(DegreeTable& table, const Classification& classes,
                  const std::vector<bool>& minimal, const AskedDegrees& asked);

/// What is known of the degree of a balanced signature.
DegreeBounds bounds_of(const DegreeTable& table, const Signature& signature);

/// In words, why solutions that records count contradict an upper bound; none if they do not.
std::optional<std::string> contradiction(std::size_t counted,
                                         const std::optional<UpperBound>& at_most);

/// An upper bound in words, with the page that proves it.
std::string in_words(const UpperBound& bound);
} // namespace checker
