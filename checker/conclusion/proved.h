// What the files of a run prove of a problem that a user asks about, but for its degree.
#pragma once

#include "checker/conclusion/expectation.h"

namespace checker {
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
