// What the files of a run prove of a problem that a user asks about, but for its degree.
#pragma once

#include "checker/conclusion/expectation.h"

namespace checker {
/// The problem without its implied lines (FORMAT.md, section 10): each has two points, and each
/// view that sees it sees both, so it has no parameters in space and in images.
Problem without_implied_lines(const Problem& problem);

/// The number of the label class to which the problem belongs as it stands; none if it is not
/// balanced, or has other features than the 27.
std::optional<std::size_t> class_of(const Classification& classes, const Problem& problem);

/// What is proved of a problem beside its degree.
struct Proved {
    std::string verdict{}; // empty if none
    std::string file{};    // that proves it
    /// The label class that has the same degree: that of the lifted problem.
    std::optional<std::size_t> number{};
};

/// By a problem file about the problem, else by the record of its class in a classification, or
/// else by what files prove of problems in general.
Proved prove(const Classification& classes, const Findings& findings,
             const ByProblem<ProvedInGeneral>& in_general, const ExpectedProblem& expected);

/// Whether a verdict says what is expected, or implies it.
bool implies(const std::string& verdict, const std::string& expected);
} // namespace checker
