#include "prover/cli/general_report.h"

#include "prover/cli/problem_report.h"
#include "prover/cli/sections.h"
#include "prover/general/notation.h"
#include "prover/general/spec.h"
#include "prover/many_views/degrees_on_file.h"
#include "prover/problem/spec.h"

#include <nlohmann/json.hpp>
#include <sstream>

namespace plprove {

namespace {

const char* model_name(const general::Problem& problem) {
    return problem.model == general::CameraModel::calibrated ? "calibrated" : "projective";
}

std::string balance(const general::Problem& problem) {
    const bool balanced = general::is_balanced(problem);
    return "scene " + std::to_string(general::dimension_in_space(problem)) + " + cameras " +
           std::to_string(general::camera_dimension(problem.model, problem.views)) +
           (balanced ? " = " : " against ") + "images " +
           std::to_string(general::dimension_in_views(problem)) +
           (balanced ? ": balanced" : ": unbalanced");
}

/// What is on file of a degree.
struct Known {
    int degree = 0;
    bool exact = true;
    std::string status;
    int certified = 0; ///< at least; 0: none
};

/// Of a problem that has a reduction to label classes the degree of these, which is certified; else
/// what certs/family-degrees.csv says; nothing if neither has it.
std::optional<Known> known_degree(const general::Certificate& certificate) {
    const std::string notation = general::notation(certificate.problem);
    if (general::is_minimal(certificate) && !general::parse_spec(notation)) {
        if (const auto degree = degree_of(decide(parse_spec(notation))))
            return Known{*degree, true, "certified", *degree};
    }
    const auto found = many_views::degree_on_file(notation);
    if (!found) return std::nullopt;
    return Known{found->degree, found->bound == "exact", std::string(found->status),
                 found->certified};
}

std::string csv_line(const general::Certificate& certificate) {
    const general::Problem& problem = certificate.problem;
    const general::Counts counts = general::counts(problem);
    std::string line;
    for (const int number : {problem.views, counts.free_points, counts.dependent_points,
                             counts.free_lines, counts.adjacent_lines})
        line += std::to_string(number) + ',';
    line += general::is_minimal(certificate) ? "1," : "0,";
    const std::optional<Known> degree = known_degree(certificate);
    if (degree) line += std::to_string(degree->degree);
    line += ',';
    line += general::name(problem) + ',' + general::notation(problem) + ',';
    if (!general::is_minimal(certificate)) line += '"' + general::explanation(certificate) + '"';
    line += ',';
    if (degree) line += (degree->exact ? "" : "at least: ") + degree->status;
    line += ',';
    if (degree && degree->certified > 0) line += std::to_string(degree->certified);
    return line;
}

/// What is on file: `at least 17`.
std::string in_words(const many_views::DegreeOnFile& degree) {
    return (degree.bound == "exact" ? "" : "at least ") + std::to_string(degree.degree);
}

void write_degree(std::ostream& out, const std::string& notation) {
    section(out, "degree");
    const auto degree = many_views::degree_on_file(notation);
    if (!degree) {
        out << "none on file\n";
        return;
    }
    out << in_words(*degree) << ' ' << degree->status << ": " << degree->source << '\n';
    if (degree->certified > 0 && degree->status != "certified")
        section(out, "") << "at least " << degree->certified << " certified\n";
}

} // namespace

std::string text_report(const general::Certificate& certificate) {
    const general::Problem& problem = certificate.problem;
    std::ostringstream out;
    section(out, "problem") << general::notation(problem) << '\n';
    section(out, "cameras") << problem.views << ' ' << model_name(problem) << '\n';
    section(out, "dimensions") << balance(problem) << '\n';
    section(out, "verdict") << general::verdict(certificate) << '\n';
    section(out, "");
    write_wrapped(out, general::explanation(certificate));
    if (general::is_minimal(certificate)) write_degree(out, general::notation(problem));
    return out.str();
}

std::string json_report(const general::Certificate& certificate) {
    const general::Problem& problem = certificate.problem;
    nlohmann::ordered_json report = {
        {"problem", general::notation(problem)},
        {"name", general::name(problem)},
        {"cameras", model_name(problem)},
        {"views", problem.views},
        {"dimensions",
         {{"scene", general::dimension_in_space(problem)},
          {"cameras", general::camera_dimension(problem.model, problem.views)},
          {"images", general::dimension_in_views(problem)}}},
        {"verdict", general::verdict(certificate)},
        {"minimal", general::is_minimal(certificate)},
        {"reason", general::explanation(certificate)}};
    const auto degree = many_views::degree_on_file(general::notation(problem));
    if (degree)
        report["degree"] = {{"value", degree->degree},
                            {"bound", degree->bound},
                            {"status", degree->status},
                            {"certified_at_least", degree->certified},
                            {"source", degree->source}};
    return report.dump(2) + '\n';
}

std::string list_of(std::span<const general::Certificate> certificates, const std::string& format) {
    std::string text;
    if (format == "csv")
        text = "views,free_points,dependent_points,free_lines,adjacent_lines,minimal,degree,name,"
               "notation,reason,degree_status,degree_certified\n";
    for (const general::Certificate& certificate : certificates) {
        const general::Problem& problem = certificate.problem;
        text += format == "csv"        ? csv_line(certificate)
                : format == "notation" ? general::notation(problem)
                                       : general::name(problem);
        text += '\n';
    }
    return text;
}

} // namespace plprove
