// Which page of proofs/ proves a theorem on degrees.
#pragma once

#include "checker/bounds/theorems.h"
#include "checker/conclusion/in_general.h"

#include <string_view>
#include <utility>

namespace checker {
/// The pages of theorems; those that are not here are on lines through a point.
inline constexpr std::pair<std::string_view, std::string_view> pages_of_theorems[] = {
    {theorem_of_points_and_lines, "families.md"},
    {theorem_of_common_centres, "three_views/4_classes.md"},
    {theorem_of_many_pins, "three_views/5_many_pins.md"},
    {"L", "three_collinear_points.md"},
    {"M", "collinear_points_more_views.md"},
    {"N", "many_pins.md"},
    {theorem_of_cameras, "moduli.md"},
    {theorem_of_arrangements, "moduli.md"},
    {"V", "four_and_five_views.md"},
    {"Y", "three_views/5_many_pins.md"},
};

inline std::string_view page_of(std::string_view theorem) {
    for (const auto& [name, page] : pages_of_theorems)
        if (name == theorem) return page;
    return "three_views/6_lines_through_a_point.md";
}
} // namespace checker
