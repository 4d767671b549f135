// Upper bounds that are theorems: how many camera solutions the problems of a constraint class have
// at most, if they are minimal. Texts of their own have those of Theorem C, for problems with at
// most three pins at each point (proofs/three_views, chapter 4), and those of Theorem K, for 65
// others (chapter 5). The first table has the rest: rows of Theorems U8, U11 (chapter 6) and Y
// (chapter 5).
#pragma once

#include "checker/bounds/common_centres.h"
#include "checker/bounds/common_centres_more.h"
#include "checker/bounds/many_pins.h"

#include <array>
#include <charconv>
#include <string_view>
#include <vector>

namespace checker {
struct TheoremBound {
    std::string_view theorem;
    std::string_view problem; // of the constraint class
    unsigned bound;
};

inline constexpr std::array<TheoremBound, 19> theorem_bounds{{
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
    {"Y", "Pabcd/Pabcd/Pabcd + 2*a/a/a", 480},
}};

/// The problems of this theorem have the same degree, all of them.
inline constexpr std::string_view theorem_of_equal_degrees = "U8";

inline constexpr std::string_view theorem_of_common_centres = "C";
inline constexpr std::string_view theorem_of_many_pins = "K";

/// A row of Theorem C or K: of the constraint class of this label class.
struct NumberedBound {
    std::size_t number = 0;
    unsigned bound = 0;
};

/// Adds the rows of a text with rows such as `520: 2633;` or `544: 254 552;`.
inline void add_numbered_rows(std::vector<NumberedBound>& rows, std::string_view text) {
    unsigned bound = 0;
    while (true) {
        const std::size_t begin = text.find_first_of("0123456789");
        if (begin == std::string_view::npos) return;
        unsigned number = 0;
        const char* after =
            std::from_chars(text.data() + begin, text.data() + text.size(), number).ptr;
        if (*after == ':')
            bound = number;
        else
            rows.push_back({number, bound});
        text.remove_prefix(static_cast<std::size_t>(after - text.data()));
    }
}

/// All rows of Theorem C. No class has two.
inline std::vector<NumberedBound> common_centre_rows() {
    std::vector<NumberedBound> rows;
    add_numbered_rows(rows, common_centre_bounds);
    add_numbered_rows(rows, common_centre_bounds_more);
    return rows;
}

/// All rows of Theorem K. No class has two, nor one of Theorem C.
inline std::vector<NumberedBound> many_pin_rows() {
    std::vector<NumberedBound> rows;
    add_numbered_rows(rows, many_pin_bounds);
    return rows;
}
} // namespace checker
