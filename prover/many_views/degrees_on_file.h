// The degrees of problems that are on file, embedded in the program at build time: of families
// (certs/family-degrees.csv), and of three views that may miss points and lines
// (certs/three-views-in-part.csv).
#pragma once

#include "prover/problem/problem.h"

#include <optional>
#include <span>
#include <string_view>

namespace plprove::many_views {

/// One line of the file: a problem, how many solutions generic images have, or a lower bound on
/// that, by evidence; and the lower bound that is certified.
struct DegreeOnFile {
    std::string_view family;
    std::string_view problem; ///< in notation
    int degree = 0;
    std::string_view bound;  ///< `exact` or `at-least`
    std::string_view status; ///< `certified` or `evidence`
    int certified = 0;       ///< how many plcheck has certified, at least; 0: none
    std::string_view source;
};

/// The lines of the file as it was when the program was built, without comments and column names.
std::span<const std::string_view> family_degree_lines();

/// The same of the other file: a problem of a constraint class, the number of its label classes,
/// the degree, or 0, and how it was counted.
std::span<const std::string_view> three_view_degree_lines();

/// Reads a line of the first file, and of the second.
DegreeOnFile parse_family_degree(std::string_view line);
DegreeOnFile parse_three_view_degree(std::string_view line);

/// The degree of a problem of a family, in notation; nothing if none is on file.
std::optional<DegreeOnFile> degree_on_file(std::string_view notation);

/// The degree of a minimal problem; nothing if none is on file. In three views it is that of the
/// constraint class.
std::optional<DegreeOnFile> degree_on_file(const Problem& problem);

} // namespace plprove::many_views
