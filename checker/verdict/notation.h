// Any sum of features in two or three views, as FORMAT.md, section 1, spells it.
#pragma once

#include "checker/file/reader.h"
#include "checker/problem/features.h"

namespace checker {
using Features = std::vector<Feature>;

/// A problem as given, multiplicities written out.
struct Problem {
    std::string notation{};
    unsigned views = 0; // 2 or 3
    Features features{};
};

/// How section 1 spells a feature in so many views.
std::string spell(const Feature& feature, unsigned views);

/// The feature that a word spells, in so many views. Throws Malformed.
Feature read_feature(const Reader& reader, std::string_view word, unsigned views);

/// Takes a problem and the end of its line.
Problem read_problem(Reader& reader);
} // namespace checker
