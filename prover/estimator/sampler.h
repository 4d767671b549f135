// Samples: matches that are just enough for a minimal problem, drawn at random.
#pragma once

#include "prover/estimator/matches.h"
#include "prover/problem/feature.h"

#include <array>
#include <cstdint>

namespace plprove {

/// The matches of one feature of the problem.
struct SampledFeature {
    std::size_t point = 0;          ///< of a feature with a point
    std::vector<std::size_t> lines; ///< one for each line of the feature
};

/// One for each feature, in the order of the problem.
using Sample = std::vector<SampledFeature>;

class Sampler {
public:
    /// `matches` must outlive the sampler.
    Sampler(const Features& problem, const Matches& matches);

    /// The same sample for the same numbers. Features are different matches, and no line passes
    /// through the point of another feature. Nothing where the matches do not offer one (a hundred
    /// tries failed).
    std::optional<Sample> draw(std::uint64_t seed, std::uint64_t number) const;

    /// The matches that the feature may be: points, or lines of a free line. Ascending.
    const std::vector<std::size_t>& candidates(std::size_t feature) const;

private:
    /// Features that are alike, and what they may be.
    struct Pool {
        std::vector<std::size_t> features; ///< of the problem
        std::vector<std::size_t> matches;  ///< points, or lines of a free line
    };

    const Features& problem_;
    const Matches& matches_;
    std::vector<Pool> pools_; ///< those with the fewest matches first
};

} // namespace plprove
