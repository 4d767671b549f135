// What the files of a run, and theorems, say of the degree of a problem that a user asks about.
#pragma once

#include "checker/conclusion/proved.h"

namespace checker {
/// The files that bound a degree.
struct BoundFiles {
    std::vector<std::string> lower{};
    std::vector<std::string> upper{};
};

/// What is known of a degree, and by which files.
struct KnownDegree {
    DegreeBounds bounds{};
    BoundFiles files{};
    std::string source{}; // in words, whose degree it is; empty if the files do not say
};

/// The label class that has the degree of the problem, if degree or group are expected and a file
/// proves that the class is minimal.
std::optional<std::size_t> class_asked(const Classification& classes, const Findings& findings,
                                       const ExpectedProblem& expected);

/// The degree files with a record of the constraint class.
std::vector<std::string> degree_files(const Classification& classes, const Findings& findings,
                                      const Signature& key);

/// The bounds of a problem's degree that follow from what is proved.
KnownDegree degree_of(const Classification& classes, const Findings& findings, const Proved& proved,
                      const ExpectedProblem& expected);
} // namespace checker
