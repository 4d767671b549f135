// The degrees of problems of families that are on file (certs/family-degrees.csv), embedded in the
// program at build time.
#pragma once

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

/// Reads such a line.
DegreeOnFile parse_family_degree(std::string_view line);

/// The degree of a problem in notation; nothing if none is on file.
std::optional<DegreeOnFile> degree_on_file(std::string_view notation);

} // namespace plprove::many_views
