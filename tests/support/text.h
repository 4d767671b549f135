// Texts that tests alter in one place.
#pragma once

#include <doctest/doctest.h>

#include <string>

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != text.npos;
}

/// The text with another part in the place of the first such one, which has to be there.
inline std::string with(std::string text, const std::string& old, const std::string& replacement) {
    REQUIRE(contains(text, old));
    return text.replace(text.find(old), old.size(), replacement);
}
