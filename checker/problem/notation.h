// The notation of problems: sums of features, as FORMAT.md spells them, in section 1 those in two
// or three views, in section 13 all.
#pragma once

#include "checker/file/reader.h"
#include "checker/problem/problem.h"

namespace checker {
/// What a section allows.
struct Grammar {
    const char* section = "13";
    unsigned most_views = checker::most_views;
    std::size_t most_points = 100;
    std::size_t most_lines = 100;
    std::size_t most_features = 200;
    /// Whether lines may be shared, letters left out, and cameras of another kind.
    bool in_general = true;
    /// Whether equal features may be neighbours, as people write them, but files do not.
    bool equal_neighbours = false;
};

inline constexpr Grammar section_13{};
inline constexpr Grammar section_1{"1", 3, 1000, 26'000, 1000, false};

using Features = std::vector<Feature>;

/// A problem as written, its features with multiplicities written out, and what it means.
struct Written {
    std::string notation{};
    Features features{}; // their notations are words of the reader's
    Problem problem{};
};

/// How a feature is spelled in this number of views.
std::string spell(const Feature& feature, unsigned views);

/// The feature that a word spells, in this number of views. Throws Malformed.
Feature read_feature(const Reader& reader, std::string_view word, unsigned views,
                     const Grammar& grammar);

/// Takes a notation and the end of its line. Throws Malformed.
Written read_notation(Reader& reader, const Grammar& grammar = section_13);

/// The problem of a text that someone typed: blanks do not matter, and equal features may be
/// neighbours. Throws Malformed.
Problem parse_problem(std::string_view text, Grammar grammar = section_13);
} // namespace checker
