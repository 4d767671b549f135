// The degrees of nine constraint classes that theorems give one by one: six or five lines through a
// point that all views see (proofs/three_views/6_lines_through_a_point.md).
#pragma once

#include <array>
#include <string_view>

namespace checker::exactly {
struct Row {
    std::string_view problem; // that stands for its constraint class, in notation
    unsigned solutions;
    std::string_view theorem;
};

inline constexpr std::array<Row, 9> rows{{
    {"Pabcdef/Pabcdef/Pabcdef + a/P/Pa", 64, "U8"},
    {"Pabcdef/Pabcdef/Pabcdef + -/P/P + P/-/P", 64, "U8"},
    {"Pabcdef/Pabcdef/Pabcdef + -/P/P + P/a/a", 64, "U8"},
    {"Pabcdef/Pabcdef/Pabcdef + -/P/P + a/P/a", 64, "U8"},
    {"Pabcdef/Pabcdef/Pabcdef + 2*P/a/a", 64, "U8"},
    {"Pabcdef/Pabcdef/Pabcdef + P/a/a + a/P/a", 64, "U8"},
    {"Pabcde/Pabcde/Pabcde + 2*-/P/P + P/-/P", 272, "U11"},
    {"Pabcde/Pabcde/Pabcde + 2*-/P/P + P/a/a", 272, "U11"},
    {"Pabcde/Pabcde/Pabcde + 2*-/P/P + a/P/a", 272, "U11"},
}};
} // namespace checker::exactly
