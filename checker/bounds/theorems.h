// Upper bounds that are theorems (proofs/upper_bounds.md): how many camera solutions the problems
// of a constraint class have at most, if they are minimal. The proof prints the same table.
#pragma once

#include <array>
#include <string_view>

namespace checker {
struct TheoremBound {
    std::string_view theorem;
    std::string_view problem; // of the constraint class
    unsigned bound;
};

inline constexpr std::array<TheoremBound, 33> theorem_bounds{{
    {"U8", "Pabcdef/Pabcdef/Pabcdef + a/P/Pa", 64},
    {"U8", "Pabcdef/Pabcdef/Pabcdef + -/P/P + P/-/P", 64},
    {"U8", "Pabcdef/Pabcdef/Pabcdef + -/P/P + P/a/a", 64},
    {"U8", "Pabcdef/Pabcdef/Pabcdef + -/P/P + a/P/a", 64},
    {"U8", "Pabcdef/Pabcdef/Pabcdef + 2*P/a/a", 64},
    {"U8", "Pabcdef/Pabcdef/Pabcdef + P/a/a + a/P/a", 64},
    {"U8", "Pabcde/Pabcde/Pabcde + P/P/P", 64},
    {"U11", "Pabcde/Pabcde/Pabcde + a/Pa/Pa", 240},
    {"U11", "Pabcde/Pabcde/Pabcde + a/a/a + -/P/P", 240},
    {"U11", "Pabcde/Pabcde/Pabcde + a/a/a + P/a/a", 240},
    {"U11", "Pabcde/Pabcde/Pabcde + a/P/Pa + -/P/P", 272},
    {"U11", "Pabcde/Pabcde/Pabcde + a/P/Pa + P/-/P", 272},
    {"U11", "Pabcde/Pabcde/Pabcde + 2*-/P/P + P/-/P", 272},
    {"U11", "Pabcde/Pabcde/Pabcde + 2*-/P/P + P/a/a", 272},
    {"U11", "Pabcde/Pabcde/Pabcde + 2*-/P/P + a/P/a", 272},
    {"U11", "Pabcd/Pabcd/Pabcd + Pa/Pa/Pa", 240},
    {"U11", "Pabcd/Pabcd/Pabcd + P/P/P + -/P/P", 240},
    {"U11", "Pabcd/Pabcd/Pabcd + P/P/P + P/a/a", 272},
    {"U15", "Pab/Pab/Pab + 2*P/P/P", 224},
    {"U15", "2*Pa/Pa/Pa + P/P/P", 312},
    {"U15", "Pa/Pa/Pa + 2*P/P/P + -/P/P", 304},
    {"U15", "Pa/Pa/Pa + 2*P/P/P + P/a/a", 376},
    {"U17", "Pa/Pa/Pa + P/P/P + 2*a/a/a", 264},
    {"U15", "3*P/P/P + a/a/a", 216},
    {"U15", "3*P/P/P + a/P/Pa", 272},
    {"U15", "3*P/P/P + -/P/P + P/-/P", 384},
    {"U15", "3*P/P/P + -/P/P + P/a/a", 464},
    {"U15", "3*P/P/P + -/P/P + a/P/a", 368},
    {"U15", "3*P/P/P + 2*P/a/a", 448},
    {"U15", "3*P/P/P + P/a/a + a/P/a", 520},
    {"U17", "2*P/P/P + a/Pa/Pa + a/a/a", 240},
    {"U17", "2*P/P/P + 2*a/a/a + -/P/P", 256},
    {"U17", "2*P/P/P + 2*a/a/a + P/a/a", 304},
}};

/// The problems of this theorem have the same degree, all of them.
inline constexpr std::string_view theorem_of_equal_degrees = "U8";
} // namespace checker
