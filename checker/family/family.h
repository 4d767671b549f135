// The families of problems (FORMAT.md, section 13). A family is a row of one table: its cameras,
// its sizes, and the numbers that are stated of it.
#pragma once

#include "checker/problem/problem.h"

namespace checker {
/// What a record proves.
struct ProblemVerdict {
    std::string notation{};
    Problem problem{};
    bool minimal = false;
};

/// A number that is stated of a family: how many of its problems meet a condition.
struct FamilyNumber {
    std::string_view name{};
    bool (*counts)(const ProblemVerdict& verdict) = nullptr;
};

/// All balanced problems for a kind of cameras in which all views see everything, no line has two
/// points, and in two views each line has three points or more.
struct Family {
    std::string_view name{};
    const CameraModel* cameras = nullptr;
    /// Whether problems of this size belong to it.
    bool (*has)(std::size_t points, int views) = nullptr;
    std::span<const FamilyNumber> numbers{};
};

std::span<const Family> families();

/// The family of this name; null if there is none.
const Family* find_family(std::string_view name);

/// Their names, in the order of the table: `plmp, projective`.
std::string names_of_families();
} // namespace checker
