// Which page of proofs/ proves a theorem.
#pragma once

#include <string_view>
#include <utility>

namespace checker {
/// Theorems on degrees of problems in general: of proofs/families.md, two of proofs/moduli.md, and
/// those of proofs/shared_points.md and proofs/upright_views.md. Others have a table,
/// checker/general_bounds/proved_degrees.h.
inline constexpr std::string_view theorem_of_points_and_lines = "16";
inline constexpr std::string_view theorem_of_cameras = "Q";
inline constexpr std::string_view theorem_of_arrangements = "T";
inline constexpr std::string_view theorem_of_shared_points = "W";
inline constexpr std::string_view theorem_of_upright_views = "D";

/// Theorems on groups.
inline constexpr std::string_view theorem_of_permutations = "S";
inline constexpr std::string_view theorem_of_five_points = "P";

inline constexpr std::pair<std::string_view, std::string_view> pages_of_theorems[] = {
    {theorem_of_points_and_lines, "families.md"},
    {"A", "calibrated_collinear_points.md"},
    {"B", "calibrated_three_points.md"},
    {"C", "three_views/4_classes.md"},
    {"E", "calibrated_six_views.md"},
    {"J", "upright_focal_views.md"},
    {"K", "three_views/5_many_pins.md"},
    {"L", "three_collinear_points.md"},
    {"M", "collinear_points_more_views.md"},
    {"N", "five_pins.md"},
    {"O", "one_focal_length.md"},
    {"R", "focal_stars.md"},
    {theorem_of_cameras, "moduli.md"},
    {theorem_of_arrangements, "moduli.md"},
    {"V", "four_and_five_views.md"},
    {"X", "upright_focal_depths.md"},
    {"Y", "focal_planes.md"},
    {"Z", "focal_collinear_points.md"},
    {theorem_of_shared_points, "shared_points.md"},
    {theorem_of_upright_views, "upright_views.md"},
    {theorem_of_permutations, "all_permutations.md"},
    {theorem_of_five_points, "five_shared_points.md"},
    {"U8", "three_views/6_lines_through_a_point.md"},
    {"U11", "three_views/6_lines_through_a_point.md"},
};

/// Empty if the theorem has no page.
constexpr std::string_view page_of(std::string_view theorem) {
    for (const auto& [name, page] : pages_of_theorems)
        if (name == theorem) return page;
    return {};
}
} // namespace checker
