// Whether the files of a run prove what a user expects.
#pragma once

#include "checker/conclusion/expectation.h"

namespace checker {
/// What the files prove of an expectation.
struct Judgement {
    bool verified = false;
    std::string statement{};          // what is verified, or what is missing
    std::vector<std::string> files{}; // that prove it
    std::vector<std::string> why{};   // the steps, in words
};

Judgement judge(const Classification& classes, const Findings& findings,
                const ExpectedProblem& expected);
Judgement judge(const Classification& classes, const Findings& findings, WholeClassification);
Judgement judge(const Findings& findings, const WholeFamily& expected);
Judgement judge(const Classification& classes, const Findings& findings, const WholeList& expected);
} // namespace checker
