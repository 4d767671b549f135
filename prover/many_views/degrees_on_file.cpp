#include "prover/many_views/degrees_on_file.h"

#include <charconv>

namespace plprove::many_views {

namespace {

/// Takes what comes before the next comma, and the comma.
std::string_view take_column(std::string_view& line) {
    const std::string_view column = line.substr(0, line.find(','));
    line.remove_prefix(std::min(column.size() + 1, line.size()));
    return column;
}

} // namespace

DegreeOnFile parse_family_degree(std::string_view line) {
    DegreeOnFile result;
    result.family = take_column(line);
    result.problem = take_column(line);
    const std::string_view degree = take_column(line);
    std::from_chars(degree.data(), degree.data() + degree.size(), result.degree);
    result.bound = take_column(line);
    result.status = take_column(line);
    const std::string_view certified = take_column(line);
    std::from_chars(certified.data(), certified.data() + certified.size(), result.certified);
    result.source = line;
    return result;
}

std::optional<DegreeOnFile> degree_on_file(std::string_view notation) {
    for (const std::string_view line : family_degree_lines())
        if (const DegreeOnFile found = parse_family_degree(line); found.problem == notation)
            return found;
    return std::nullopt;
}

} // namespace plprove::many_views
