#include "prover/minimal/problem_certificate.h"

#include "prover/minimal/pool.h"

#include <stdexcept>

namespace plprove {

namespace {

/// The certificate of the balanced problem with these blocks and this obstruction, or nothing where
/// they are in special position.
Evidence certify_balanced(const Obstruction& obstruction, const std::vector<FeatureBlock>& blocks) {
    std::vector<CameraPart> parts;
    for (const FeatureBlock& block : blocks) {
        auto part = eliminate(block);
        if (!part) return {};
        parts.push_back(std::move(*part));
    }
    const auto certificate = certify({obstruction, pointers(blocks), pointers(parts)});
    if (!certificate) return {};
    return std::visit([](const auto& held) -> Evidence { return held; }, *certificate);
}

/// Tries the point of these integers; leaves no evidence where it is special.
ProblemCertificate attempt(const Decision& decision, SmallIntegers integers) {
    const bool obstructed = decision.verdict == Verdict::obstructed;
    const Features& posed = obstructed ? decision.lifted : decision.problem;
    ProblemCertificate result{decision, random_cameras(integers, posed.front().views()), {}, {}};
    std::vector<FeatureBlock> blocks;
    for (const Feature& feature : posed) {
        result.features.push_back(random_placement(feature, result.cameras, integers));
        blocks.push_back(feature_block(result.features.back(), result.cameras));
    }
    if (decision.verdict != Verdict::camera_minimal)
        result.evidence = certify_balanced(decision.obstruction, blocks);
    else if (auto dominant = certify_dominant(pointers(blocks)))
        result.evidence = std::move(*dominant);
    return result;
}

} // namespace

ProblemCertificate certify_problem(const Features& problem) {
    const Decision decision = decide(problem);
    if (decision.verdict == Verdict::under_constrained ||
        decision.verdict == Verdict::over_constrained)
        return {decision, {}, {}, {}};
    // Small sizes first: special positions are common there, but still rare enough.
    constexpr std::int64_t smallest_bound = 3;
    constexpr std::uint64_t seeds = 10;
    for (std::int64_t bound = smallest_bound; bound <= max_coordinate; ++bound)
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            ProblemCertificate result = attempt(decision, SmallIntegers(seed, bound));
            if (!std::holds_alternative<std::monostate>(result.evidence)) return result;
        }
    throw std::runtime_error(
        "the rank is too small at every point tried, although the problem is " +
        std::string(name(decision.verdict)) + ": please report this problem");
}

} // namespace plprove
