#include "prover/many_views/degrees_on_file.h"

#include "prover/problem/notation.h"
#include "prover/problem/signature.h"

#include <algorithm>
#include <charconv>
#include <string>

namespace plprove::many_views {

namespace {

/// Takes what comes before the next comma, and the comma.
std::string_view take_column(std::string_view& line) {
    const std::string_view column = line.substr(0, line.find(','));
    line.remove_prefix(std::min(column.size() + 1, line.size()));
    return column;
}

int take_number(std::string_view& line) {
    const std::string_view column = take_column(line);
    int number = 0;
    std::from_chars(column.data(), column.data() + column.size(), number);
    return number;
}

/// The problem with the same conditions on cameras that three-views-in-part.csv names; empty if the
/// problem does not consist of the features of three views.
std::string representative_in_three_views(const Problem& problem) {
    const auto features =
        problem.views == 3 ? features_without_implied_lines(problem) : std::optional<Features>{};
    const auto signature = features ? signature_of(*features) : std::optional<Signature>{};
    if (!signature) return {};
    return std::string(problem.cameras->prefix) + ' ' +
           notation(problem_of(constraint_representative(*signature)));
}

} // namespace

DegreeOnFile parse_family_degree(std::string_view line) {
    DegreeOnFile result;
    result.family = take_column(line);
    result.problem = take_column(line);
    result.degree = take_number(line);
    result.bound = take_column(line);
    result.status = take_column(line);
    result.certified = take_number(line);
    result.source = line;
    return result;
}

DegreeOnFile parse_three_view_degree(std::string_view line) {
    DegreeOnFile result;
    result.bound = "exact";
    result.problem = take_column(line);
    result.family = result.problem.substr(0, result.problem.find(':'));
    take_column(line);
    result.degree = take_number(line);
    result.source = line;
    result.status = result.source.starts_with("by Theorem") ? "certified" : "evidence";
    return result;
}

std::optional<DegreeOnFile> degree_on_file(std::string_view notation) {
    for (const std::string_view line : family_degree_lines())
        if (const DegreeOnFile found = parse_family_degree(line); found.problem == notation)
            return found;
    return std::nullopt;
}

std::optional<DegreeOnFile> degree_on_file(const Problem& problem) {
    if (const auto of_family = degree_on_file(notation(problem))) return of_family;
    const std::string representative = representative_in_three_views(problem);
    for (const std::string_view line : three_view_degree_lines())
        if (const DegreeOnFile found = parse_three_view_degree(line);
            found.problem == representative && found.degree > 0)
            return found;
    return std::nullopt;
}

} // namespace plprove::many_views
