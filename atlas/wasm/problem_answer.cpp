#include "atlas/wasm/answers.h"

#include "prover/cli/general_report.h"
#include "prover/cli/problem_facts.h"
#include "prover/cli/problem_report.h"
#include "prover/cli/written_model.h"
#include "prover/drawing/caption.h"
#include "prover/drawing/drawing.h"
#include "prover/minimal/extensions.h"
#include "prover/minimal/problem_file.h"
#include "prover/problem/names.h"
#include "prover/problem/spec.h"
#include "prover/scripts/equation_scripts.h"

namespace atlas {

using namespace plprove;

namespace {

/// The names of the problem in the literature.
Json names_of(const Features& problem) {
    Json names = Json::array();
    for (const NamedProblem& named : named_problems())
        if (same_features(problem, parse_features(named.notation))) names.push_back(named.name);
    return names;
}

/// The features one by one, as a drawing board needs them: what each view sees.
Json features_of(const Features& problem) {
    Json features = Json::array();
    for (const Feature& feature : problem) {
        Json views = Json::array();
        for (const Sight& sight : feature.sights)
            views.push_back({{"point", sight.point}, {"lines", sight.pins}});
        features.push_back(
            {{"point", feature.has_point}, {"lines", feature.lines}, {"views", views}});
    }
    return features;
}

/// What each rule of the reduction does, in words.
Json explanations_of(const Reduction& reduction) {
    Json words = Json::array();
    for (const ReductionStep& step : reduction.steps)
        words.push_back(explanation(step.rule));
    return words;
}

/// What may be added to a minimal problem, and the larger problem: the class that decides it, and
/// its degree.
Json extensions_of(const Decision& decision) {
    Json rows = Json::array();
    if (decision.verdict != Verdict::minimal) return rows;
    for (const Change& extension : extensions(decision.problem)) {
        const Features larger = changed(decision.problem, extension);
        const Decision decided = decide(larger);
        Json row{{"words", in_words(extension)}, {"problem", notation(larger)}};
        if (decided.classes) row["number"] = decided.classes->label;
        if (const auto degree = degree_of(decided)) row["degree"] = *degree;
        rows.push_back(row);
    }
    return rows;
}

Json answer_in_general(const Problem& problem) {
    const auto found = try_to_certify(problem);
    if (const auto* open = std::get_if<Undecided>(&found))
        return {{"general", Json::parse(json_report(*open))}, {"scene", scene_of(open->problem)}};
    const auto& certificate = std::get<ProblemRecord>(found);
    return {{"general", Json::parse(json_report(certificate))},
            {"certificate", write(std::span(&certificate, 1))},
            {"scene", scene_of(certificate.problem)}};
}

} // namespace

Json problem_answer(const Json& request) {
    const std::string spec = request.at("spec");
    if (const auto problem = parse_general_spec(spec)) return answer_in_general(*problem);
    const Features problem = parse_spec(spec);
    const ProblemReport report = report_on(problem);
    return {{"report", Json::parse(json_report(report))},
            {"description", describe(problem)},
            {"names", names_of(problem)},
            {"features", features_of(problem)},
            {"explanations", explanations_of(report.decision.reduction)},
            {"extensions", extensions_of(report.decision)},
            {"scene", scene_of(problem)}};
}

Json file_answer(const Json& request) {
    const std::string spec = request.at("spec");
    const std::string kind = request.at("kind");
    if (kind == "macaulay2") return {{"text", macaulay2_script(model_of_problem(spec))}};
    if (kind == "julia") return {{"text", julia_script(model_of_problem(spec))}};
    const Features problem = parse_spec(spec);
    if (kind == "svg") return {{"text", draw_svg(problem)}};
    if (kind == "tikz") return {{"text", draw_tikz(problem)}};
    if (kind == "certificate") return {{"text", write(certify_problem(problem))}};
    throw std::invalid_argument("there are no files of the kind '" + kind + "'");
}

} // namespace atlas
