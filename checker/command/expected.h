// What a user expects, from the words in which he says it.
#pragma once

#include "checker/conclusion/expectation.h"

namespace checker {
/// The values of the options of plcheck with these names; none where the option is not given.
struct ExpectedWords {
    std::optional<std::string_view> problem{}; // of --expect
    std::optional<std::string_view> list{};    // of --expect-list
    std::optional<std::string_view> verdict{};
    std::optional<std::string_view> degree{};
    std::optional<std::string_view> group{};
    std::optional<std::string_view> family{};
    bool classification = false;
};

/// Words that make no sense, and what to write instead.
struct WrongUsage {
    std::string reason;
};

/// Reads a positive number; none if it is not written as such.
std::optional<std::size_t> parse_number(std::string_view digits);

/// Throws WrongUsage.
Expectation expectation_of(const ExpectedWords& words);
} // namespace checker
