#include "prover/degree/completeness.h"

#include "prover/degree/subproblems.h"
#include "prover/degree/trace_test.h"

#include <algorithm>

namespace plprove {

namespace {

/// Where the trace test says nothing, or not enough, more edges must have agreed.
constexpr int untested_edges = 6;
/// What the trace test leaves of its terms where no solution is missing is rounding, 1e-9 at the
/// very worst; where one of a thousand is missing, 1e-4 to 1e-6.
constexpr double vanishing = 1e-8;

/// The smallest exponent with residual < 10^exponent.
int exponent_above(double residual) {
    int exponent = -1;
    for (double power = 0.01; residual < power && exponent > -99; power /= 10)
        --exponent;
    return exponent;
}

/// The same, where spurious zeros count as solutions.
std::optional<CompletenessEvidence> complete_zeros(const CameraSystem& system, Monodromy& monodromy,
                                                   int edges, int target, Random& random,
                                                   std::vector<std::string>& notes) {
    const Subproblems parts = subproblems(system);
    for (edges = std::max(edges, parts.tested ? first_edges : untested_edges); edges <= most_edges;
         ++edges) {
        monodromy.run(edges, target);
        const std::vector<CameraPoint>& solutions = monodromy.solutions().points();
        if (target > 0 && std::ssize(solutions) >= target) return std::nullopt;
        const auto residual = trace_residual(system, monodromy.chart(), monodromy.constants(),
                                             monodromy.images(), solutions, random);
        if (!has_all_poses(parts, monodromy.chart(), solutions)) continue;
        const CompletenessEvidence evidence{monodromy.bijective_edges(), std::nullopt};
        // A degenerate end of a path that is taken for a solution spoils all edges; another attempt
        // is of more use then.
        const bool agree = evidence.edges >= agreeing_edges || edges >= untested_edges;
        if (residual && *residual < vanishing && agree)
            return CompletenessEvidence{evidence.edges, exponent_above(*residual)};
        if (!residual && evidence.edges >= untested_edges) return evidence;
    }
    notes.push_back(std::to_string(most_edges) +
                    " edges gave no evidence that no solution is missing");
    return std::nullopt;
}

} // namespace

std::optional<CompletenessEvidence> complete(const CameraSystem& system, Monodromy& monodromy,
                                             int edges, int target, Random& random,
                                             std::vector<std::string>& notes) {
    const auto evidence = complete_zeros(system, monodromy, edges, target, random, notes);
    if (!evidence) return evidence;
    const int spurious = monodromy.spurious_solutions();
    if (spurious == 0) return evidence;
    notes.push_back(std::to_string(spurious) +
                    " solutions depend on the auxiliary lines and points: they are none");
    return std::nullopt;
}

} // namespace plprove
