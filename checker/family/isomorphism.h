// When two problems are the same but for the names of points and lines (FORMAT.md, section 13).
#pragma once

#include "checker/problem/problem.h"

#include <compare>

namespace checker {
/// What a renaming keeps of a line.
struct LineType {
    std::size_t points = 0; // how many
    Views seen_by = 0;
    auto operator<=>(const LineType&) const = default;
};

/// What a renaming keeps of a point.
struct PointType {
    Views seen_by = 0;
    std::vector<LineType> lines{}; // through it, in order
    auto operator<=>(const PointType&) const = default;
};

/// What a renaming keeps of a problem. Isomorphic problems have equal invariants.
struct Invariant {
    std::string_view cameras{};
    Views views = 0;
    std::vector<PointType> points{}; // in order
    std::vector<Views> free_lines{}; // who sees each, in order
    auto operator<=>(const Invariant&) const = default;
};

Invariant invariant(const Problem& problem);

/// Whether problems with equal invariants are isomorphic; none if it takes more steps to decide
/// that. Takes from `steps` those that are used.
std::optional<bool> isomorphic(const Problem& a, const Problem& b, std::size_t& steps);
} // namespace checker
