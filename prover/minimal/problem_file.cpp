#include "prover/minimal/problem_file.h"

#include "prover/minimal/pool.h"

#include <stdexcept>

namespace plprove {

namespace {

/// The minor of the balanced problem with these blocks and this obstruction, or nothing where they
/// are in special position.
std::optional<Minor> minor_of_blocks(const Obstruction& obstruction,
                                     const std::vector<FeatureBlock>& blocks) {
    std::vector<CameraPart> parts;
    for (const FeatureBlock& block : blocks) {
        auto part = eliminate(block);
        if (!part) return std::nullopt;
        parts.push_back(std::move(*part));
    }
    return find_minor({obstruction, pointers(blocks), pointers(parts)});
}

/// Tries the point of these integers; nothing where it is special.
std::optional<ProblemFile> attempt(const Decision& decision, SmallIntegers integers) {
    const bool obstructed = decision.verdict == Verdict::obstructed;
    const Features& posed = obstructed ? decision.lifted : decision.problem;
    ProblemFile file{decision, random_cameras(integers, posed.front().views()), {}, {}};
    std::vector<FeatureBlock> blocks;
    for (const Feature& feature : posed) {
        file.features.push_back(random_placement(feature, file.cameras, integers));
        blocks.push_back(feature_block(file.features.back(), file.cameras));
    }
    std::optional<Minor> minor = decision.verdict == Verdict::camera_minimal
                                     ? find_dominant_minor(pointers(blocks))
                                     : minor_of_blocks(decision.obstruction, blocks);
    if (!minor) return std::nullopt;
    file.claim = *std::move(minor);
    return file;
}

} // namespace

ProblemFile certify_problem(const Features& problem) {
    const Decision decision = decide(problem);
    if (decision.verdict == Verdict::under_constrained ||
        decision.verdict == Verdict::over_constrained)
        return {decision, {}, {}, Unbalanced{}};
    // Small sizes first: special positions are common there, but still rare enough.
    constexpr std::int64_t smallest_bound = 3;
    constexpr std::uint64_t seeds = 10;
    for (std::int64_t bound = smallest_bound; bound <= max_coordinate; ++bound)
        for (std::uint64_t seed = 1; seed <= seeds; ++seed)
            if (auto file = attempt(decision, SmallIntegers(seed, bound))) return *std::move(file);
    throw std::runtime_error(
        "the rank is too small at every point tried, although the problem is " +
        std::string(name(decision.verdict)) + ": please report this problem");
}

} // namespace plprove
