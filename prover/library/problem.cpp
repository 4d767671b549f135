#include "prover/library/pointline/problem.h"

#include "prover/catalogue/degrees.h"
#include "prover/drawing/drawing.h"
#include "prover/library/guarded.h"
#include "prover/many_views/degrees_on_file.h"
#include "prover/minimal/decision.h"
#include "prover/minimal/problem_record.h"
#include "prover/problem/spec.h"

namespace pointline {

namespace {

std::optional<int> degree(const plprove::Decision& decision) {
    const bool solvable = decision.verdict == plprove::Verdict::minimal ||
                          decision.verdict == plprove::Verdict::camera_minimal;
    if (!solvable) return std::nullopt;
    if (!decision.classes) return plprove::degree_in_two_views;
    return plprove::degree_on_file(decision.classes->constraint);
}

void add_features(Problem& result, const plprove::Features& features) {
    result.views = features.front().views();
    result.picture = plprove::draw_svg(features);
    for (const plprove::Feature& feature : features) {
        result.points.push_back(feature.has_point);
        std::string& letters = result.lines.emplace_back();
        for (int line = static_cast<int>(feature.shared.size()); line < feature.lines; ++line)
            letters += plprove::letter_of(feature, line);
    }
}

Problem in_general(const plprove::Problem& problem) {
    Problem result;
    result.notation = plprove::notation(problem);
    result.calibrated = problem.cameras == &plprove::calibrated_cameras;
    const auto found = plprove::try_to_certify(problem);
    if (const auto* record = std::get_if<plprove::ProblemRecord>(&found)) {
        result.verdict = plprove::verdict(*record);
        if (!plprove::is_minimal(*record)) result.reasons = {plprove::explanation(*record)};
    } else {
        result.verdict = "open";
    }
    const auto known = plprove::many_views::degree_on_file(result.notation);
    if (known && known->bound == "exact") result.degree = known->degree;
    add_features(result, plprove::features_of(problem));
    return result;
}

} // namespace

Result<Problem> problem(std::string_view text) noexcept {
    return guarded<Problem>(Failure::bad_problem, [&] {
        if (const auto general = plprove::parse_general_spec(text)) return in_general(*general);
        const plprove::Decision decision = plprove::decide(plprove::parse_spec(text));
        Problem result;
        result.notation = plprove::notation(decision.problem);
        result.verdict = plprove::name(decision.verdict);
        result.reasons = plprove::reasons(decision);
        result.degree = degree(decision);
        add_features(result, decision.problem);
        return result;
    });
}

} // namespace pointline
