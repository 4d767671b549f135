// What a user expects the files of a run to prove.
#pragma once

#include "checker/conclusion/in_general.h"

namespace checker {
/// A number of camera solutions.
struct ExpectedDegree {
    bool exactly = true; // else at least
    std::size_t solutions = 0;
};

/// The verdict on a problem, its degree, and the group of its solutions, or some of these.
struct ExpectedProblem {
    std::string notation{}; // printable
    Problem problem{};
    bool in_general = false; // whether only section 13 may spell it
    std::string verdict{};   // a word of `expected_verdicts`, perhaps with a number; empty for any
    std::optional<ExpectedDegree> degree{};
    std::string group{}; // as in group.h; empty for any
};

/// That every label class has a certificate.
struct WholeClassification {};

/// That every problem of a family in general has a certificate.
struct WholeFamily {
    std::string name{}; // as in FORMAT.md, section 13
};

/// That a model is minimal, and perhaps its degree, and the group of its solutions.
struct ExpectedModel {
    std::string file{}; // printable
    std::string text{}; // its lines as certificates have them
    std::optional<ExpectedDegree> degree{};
    std::string group{}; // as that of ExpectedProblem
};

/// That each problem of a list has a certificate, perhaps of this verdict.
struct WholeList {
    struct Entry {
        std::size_t line = 0; // of the file, from 1
        ExpectedProblem problem{};
    };
    std::string file{};    // printable
    std::string verdict{}; // as that of ExpectedProblem
    std::vector<Entry> entries{};
};

/// What is expected; nothing in particular by default.
using Expectation = std::variant<std::monostate, ExpectedProblem, WholeClassification, WholeFamily,
                                 WholeList, ExpectedModel>;

/// The verdicts that one can expect. All but `not-minimal` are those of FORMAT.md, section 7; a
/// minimal problem is camera-minimal, too. `not-minimal` is any verdict but `minimal`.
inline constexpr std::array<std::string_view, 6> expected_verdicts{
    "minimal",    "camera-minimal",    "not-minimal",
    "obstructed", "under-constrained", "over-constrained"};

/// The expectation as a statement; empty if there is none.
std::string in_words(const Expectation& expectation);
std::string in_words(const ExpectedProblem& expected);

/// ` has the group S312`, ` has a group that contains A312`, or ` has a group of index 2 in ...`.
std::string group_in_words(const std::string& group);
} // namespace checker
