#include "prover/cli/general_report.h"

#include "prover/cli/problem_report.h"
#include "prover/cli/sections.h"
#include "prover/many_views/degrees_on_file.h"
#include "prover/problem/notation.h"

#include <nlohmann/json.hpp>
#include <sstream>

namespace plprove {

namespace {

std::string balance(const Problem& problem) {
    const bool balanced = is_balanced(problem);
    return "scene " + std::to_string(dimension_in_space(problem)) + " + cameras " +
           std::to_string(problem.cameras->dimension(problem.views)) +
           (balanced ? " = " : " against ") + "images " +
           std::to_string(dimension_in_views(problem)) + (balanced ? ": balanced" : ": unbalanced");
}

constexpr std::string_view conjectured = "conjectured not minimal";

/// What the problem is, the verdict, and why.
void write_verdict(std::ostream& out, const Problem& problem, std::string_view verdict,
                   const std::string& why) {
    section(out, "problem") << notation(problem) << '\n';
    section(out, "cameras") << problem.views << ' ' << problem.cameras->name << '\n';
    section(out, "dimensions") << balance(problem) << '\n';
    section(out, "verdict") << verdict << '\n';
    section(out, "");
    write_wrapped(out, why);
}

nlohmann::ordered_json facts(const Problem& problem) {
    return {{"problem", notation(problem)},
            {"name", name(problem)},
            {"cameras", problem.cameras->name},
            {"views", problem.views},
            {"dimensions",
             {{"scene", dimension_in_space(problem)},
              {"cameras", problem.cameras->dimension(problem.views)},
              {"images", dimension_in_views(problem)}}}};
}

/// What is on file of a degree.
struct Known {
    int degree = 0;
    bool exact = true;
    std::string status;
    int certified = 0; ///< at least; 0: none
};

/// The degree of the features, which is certified; else what is on file; nothing if neither has
/// it.
std::optional<Known> known_degree(const ProblemRecord& certificate) {
    if (const auto degree = degree_of_features(certificate))
        return Known{*degree, true, "certified", *degree};
    const auto found = many_views::degree_on_file(certificate.problem);
    if (!found) return std::nullopt;
    return Known{found->degree, found->bound == "exact", std::string(found->status),
                 found->certified};
}

/// The group of the features, or what is on file; nothing if neither is known.
std::optional<GroupOnFile> known_group(const ProblemRecord& certificate) {
    if (!is_minimal(certificate)) return std::nullopt;
    if (const auto features = local_features(certificate.problem))
        return group_of(decide(*features));
    return family_group_on_file(notation(certificate.problem));
}

std::string csv_line(const ProblemRecord& certificate) {
    const Problem& problem = certificate.problem;
    const PlmpNumbers counts = plprove::counts(problem);
    std::string line;
    for (const int number : {problem.views, counts.free_points, counts.dependent_points,
                             counts.free_lines, counts.adjacent_lines})
        line += std::to_string(number) + ',';
    line += is_minimal(certificate) ? "1," : "0,";
    const std::optional<Known> degree = known_degree(certificate);
    if (degree) line += std::to_string(degree->degree);
    line += ',';
    line += name(problem) + ',' + notation(problem) + ',';
    if (!is_minimal(certificate)) line += '"' + explanation(certificate) + '"';
    line += ',';
    if (degree) line += (degree->exact ? "" : "at least: ") + degree->status;
    line += ',';
    if (degree && degree->certified > 0) line += std::to_string(degree->certified);
    line += ',';
    if (const auto group = known_group(certificate)) {
        line.append(group->name).append(",").append(group->order);
        line += ',' + std::to_string(group->width) + ',';
        line += group->status;
    } else {
        line += ",,,";
    }
    return line;
}

/// What is on file: `at least 17`.
std::string in_words(const many_views::DegreeOnFile& degree) {
    return (degree.bound == "exact" ? "" : "at least ") + std::to_string(degree.degree);
}

std::string source_of_features(const ProblemRecord& certificate) {
    return "that of " + notation(*local_features(certificate.problem));
}

void write_degree(std::ostream& out, const ProblemRecord& certificate) {
    section(out, "degree");
    const auto degree = many_views::degree_on_file(certificate.problem);
    const auto of_features = degree_of_features(certificate);
    if (!degree && of_features)
        out << *of_features << " certified: " << source_of_features(certificate) << '\n';
    else if (!degree)
        out << "none on file\n";
    if (!degree) return;
    out << in_words(*degree) << ' ' << degree->status << ": " << degree->source << '\n';
    if (degree->certified > 0 && degree->status != "certified")
        section(out, "") << "at least " << degree->certified << " certified\n";
}

} // namespace

std::optional<int> degree_of_features(const ProblemRecord& certificate) {
    if (!is_minimal(certificate)) return std::nullopt;
    const std::optional<Features> features = local_features(certificate.problem);
    return features ? degree_of(decide(*features)) : std::nullopt;
}

std::string text_report(const ProblemRecord& certificate) {
    std::ostringstream out;
    write_verdict(out, certificate.problem, verdict(certificate), explanation(certificate));
    if (is_minimal(certificate)) write_degree(out, certificate);
    if (const auto group = known_group(certificate)) write_group(out, *group);
    return out.str();
}

std::string text_report(const Undecided& found) {
    std::ostringstream out;
    write_verdict(out, found.problem, conjectured, explanation(found));
    return out.str();
}

std::string json_report(const ProblemRecord& certificate) {
    const Problem& problem = certificate.problem;
    nlohmann::ordered_json report = facts(problem);
    report["verdict"] = verdict(certificate);
    report["minimal"] = is_minimal(certificate);
    report["reason"] = explanation(certificate);
    const auto degree = many_views::degree_on_file(problem);
    if (degree)
        report["degree"] = {{"value", degree->degree},
                            {"bound", degree->bound},
                            {"status", degree->status},
                            {"certified_at_least", degree->certified},
                            {"source", degree->source}};
    else if (const auto of_features = degree_of_features(certificate))
        report["degree"] = {{"value", *of_features},
                            {"bound", "exact"},
                            {"status", "certified"},
                            {"certified_at_least", *of_features},
                            {"source", source_of_features(certificate)}};
    if (const auto group = known_group(certificate)) report["group"] = group_json(*group);
    return report.dump(2) + '\n';
}

std::string json_report(const Undecided& found) {
    const auto from_one = [](std::vector<int> numbers) {
        for (int& number : numbers)
            ++number;
        return numbers;
    };
    nlohmann::ordered_json report = facts(found.problem);
    report["verdict"] = conjectured;
    report["minimal"] = nullptr;
    report["reason"] = explanation(found);
    report["evidence"] = {{"ranks", found.ranks},
                          {"moving_cameras", from_one(found.moving_views)},
                          {"moving_points", from_one(found.moving_points)},
                          {"moving_lines", from_one(found.moving_lines)}};
    return report.dump(2) + '\n';
}

std::string list_of(std::span<const ProblemRecord> certificates, const std::string& format) {
    std::string text;
    if (format == "csv")
        text =
            "views,free_points,dependent_points,free_lines,adjacent_lines,minimal,degree,name,"
            "notation,reason,degree_status,degree_certified,group,group_order,width,group_status\n";
    for (const ProblemRecord& certificate : certificates) {
        const Problem& problem = certificate.problem;
        text += format == "csv"        ? csv_line(certificate)
                : format == "notation" ? notation(problem)
                                       : name(problem);
        text += '\n';
    }
    return text;
}

} // namespace plprove
