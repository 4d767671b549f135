// Upper bounds that are theorems: how many camera solutions the problems of a constraint class have
// at most, if they are minimal. proofs/upper_bounds.md prints the first table, with the rows of
// Theorem Y (proofs/calibrated_moduli.md). The rows of Theorems R, S and X (proofs/relations.md)
// and of Theorem Z (proofs/blown_up_cameras.md) are in texts of their own.
#pragma once

#include "checker/bounds/blown_up_cameras.h"
#include "checker/bounds/blown_up_cameras_more.h"
#include "checker/bounds/central_views.h"
#include "checker/bounds/central_views_lines.h"
#include "checker/bounds/hidden_points.h"
#include "checker/bounds/hidden_points_more.h"
#include "checker/bounds/shared_points.h"

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

inline constexpr std::array<TheoremBound, 39> theorem_bounds{{
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
    {"Y", "Pabc/Pabc/Pabc + Pab/Pab/Pab", 480},
    {"Y", "Pabc/Pabc/Pabc + P/P/P + a/a/a", 328},
    {"Y", "Pab/Pab/Pab + Pa/Pa/Pa + a/a/a", 432},
    {"U15", "Pab/Pab/Pab + 2*P/P/P", 224},
    {"Y", "Pab/Pab/Pab + 3*a/a/a", 552},
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
    {"Y", "P/P/P + 4*a/a/a", 360},
}};

/// The problems of this theorem have the same degree, all of them.
inline constexpr std::string_view theorem_of_equal_degrees = "U8";

inline constexpr std::string_view theorem_of_blown_up_cameras = "Z";

/// Adds the rows of a theorem, from a text with rows such as `4912 11*P/a/a;`.
inline void add_rows(std::vector<TheoremBound>& rows, std::string_view theorem,
                     std::string_view text) {
    while (true) {
        const std::size_t begin = text.find_first_not_of(" \n");
        if (begin == std::string_view::npos) return;
        const std::size_t space = text.find(' ', begin), end = text.find(';', space);
        unsigned bound = 0;
        std::from_chars(text.data() + begin, text.data() + space, bound);
        rows.push_back({theorem, text.substr(space + 1, end - space - 1), bound});
        text.remove_prefix(end + 1);
    }
}

/// All rows of Theorems R, S and X. No class has two.
inline std::vector<TheoremBound> central_view_rows() {
    std::vector<TheoremBound> rows;
    add_rows(rows, "R", central_view_bounds);
    add_rows(rows, "R", central_view_bounds_lines);
    add_rows(rows, "S", hidden_point_bounds);
    add_rows(rows, "S", hidden_point_bounds_more);
    add_rows(rows, "X", shared_point_bounds);
    return rows;
}

/// All rows: those of the first table, then the others.
inline std::vector<TheoremBound> all_theorem_bounds() {
    std::vector<TheoremBound> rows(theorem_bounds.begin(), theorem_bounds.end());
    const std::vector<TheoremBound> central = central_view_rows();
    rows.insert(rows.end(), central.begin(), central.end());
    return rows;
}

/// A row of Theorem Z: of the constraint class of this label class.
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

/// All rows of Theorem Z. No class has two.
inline std::vector<NumberedBound> blown_up_camera_rows() {
    std::vector<NumberedBound> rows;
    add_numbered_rows(rows, blown_up_camera_bounds);
    add_numbered_rows(rows, blown_up_camera_bounds_more);
    return rows;
}
} // namespace checker
