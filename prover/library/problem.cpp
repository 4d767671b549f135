#include "prover/library/pointline/problem.h"

#include "prover/catalogue/degrees.h"
#include "prover/drawing/drawing.h"
#include "prover/library/guarded.h"
#include "prover/minimal/decision.h"
#include "prover/problem/spec.h"
#include "prover/solver/solve.h"

namespace pointline {

namespace {

std::optional<int> degree(const plprove::Decision& decision) {
    const bool solvable = decision.verdict == plprove::Verdict::minimal ||
                          decision.verdict == plprove::Verdict::camera_minimal;
    if (!solvable) return std::nullopt;
    if (!decision.classes) return plprove::degree_in_two_views;
    return plprove::degree_on_file(decision.classes->constraint);
}

} // namespace

Result<Problem> problem(std::string_view text) noexcept {
    return guarded<Problem>(Failure::bad_problem, [&] {
        const plprove::Decision decision = plprove::decide(plprove::parse_spec(text));
        Problem result;
        result.notation = plprove::notation(decision.problem);
        result.views = decision.problem.front().views();
        result.verdict = plprove::name(decision.verdict);
        result.reasons = plprove::reasons(decision);
        result.degree = degree(decision);
        result.picture = plprove::draw_svg(decision.problem);
        for (const plprove::Feature& feature : decision.problem) {
            result.points.push_back(feature.has_point);
            std::string& letters = result.lines.emplace_back();
            for (int line = 0; line < feature.lines; ++line)
                letters += static_cast<char>('a' + line);
        }
        return result;
    });
}

} // namespace pointline
