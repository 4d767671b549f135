#include "prover/classification/archive.h"

#include <stdexcept>

namespace plprove {

namespace {

constexpr std::size_t max_pools = 99;
constexpr std::size_t progress_interval = 1024;

/// A pool with everything computed from it once.
struct PreparedPool {
    Pool pool;
    std::array<std::vector<FeatureBlock>, feature_count> blocks;
    CameraParts parts;
};

PreparedPool prepare(std::uint64_t seed) {
    PreparedPool prepared{make_pool(seed), {}, {}};
    for (std::size_t i = 0; i < feature_count; ++i)
        for (const PlacedFeature& placed : prepared.pool.instances[i])
            prepared.blocks[i].push_back(feature_block(placed, prepared.pool.cameras));
    prepared.parts = camera_parts(prepared.pool);
    return prepared;
}

PosedProblem pose(const Signature& signature, const PreparedPool& pool) {
    PosedProblem posed{problem_of(signature), {}, {}};
    for (std::size_t i = 0; i < feature_count; ++i)
        for (std::size_t copy = 0; copy < signature[i]; ++copy) {
            posed.blocks.push_back(&pool.blocks[i][copy]);
            posed.parts.push_back(&pool.parts[i][copy]);
        }
    return posed;
}

Record certify_class(const Signature& signature, std::size_t number,
                     std::vector<PreparedPool>& pools) {
    for (std::size_t index = 0; index < max_pools; ++index) {
        if (index == pools.size()) pools.push_back(prepare(index + 1));
        if (auto certificate = certify(pose(signature, pools[index])))
            return {number, index, std::move(*certificate)};
    }
    throw std::runtime_error("class " + std::to_string(number) + " is rank-deficient in all " +
                             std::to_string(max_pools) + " pools, but has no obstruction for it");
}

} // namespace

Archive certify_classification(const std::vector<Signature>& classes, const Progress& progress) {
    Archive archive;
    std::vector<PreparedPool> pools;
    for (std::size_t number = 0; number < classes.size(); ++number) {
        archive.records.push_back(certify_class(classes[number], number, pools));
        if (number % progress_interval == 0) progress(number);
    }
    for (PreparedPool& prepared : pools)
        archive.pools.push_back(std::move(prepared.pool));
    return archive;
}

ProblemCertificate certify_problem(const Problem& problem, std::size_t number) {
    // Some seeds for each size: a small size first, where special positions are common but still rare enough.
    constexpr std::int64_t largest_bound = 50;
    constexpr std::uint64_t seeds = 20;
    for (std::int64_t bound = 3; bound <= largest_bound; ++bound)
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            SmallIntegers integers(seed, bound);
            ProblemCertificate result{number, random_cameras(integers, 3), {}, {}};
            std::vector<FeatureBlock> blocks;
            std::vector<CameraPart> parts;
            for (const Feature& feature : problem) {
                result.features.push_back(random_placement(feature, result.cameras, integers));
                blocks.push_back(feature_block(result.features.back(), result.cameras));
                parts.push_back(eliminate(blocks.back()).value());
            }
            PosedProblem posed{problem, {}, {}};
            for (std::size_t i = 0; i < problem.size(); ++i) {
                posed.blocks.push_back(&blocks[i]);
                posed.parts.push_back(&parts[i]);
            }
            if (auto certificate = certify(posed)) {
                result.certificate = std::move(*certificate);
                return result;
            }
        }
    throw std::runtime_error("the problem is rank-deficient at every point tried, but has no "
                             "obstruction for it");
}

} // namespace plprove
