#include "prover/minimal/classification_file.h"

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
    PosedProblem posed{obstruction(problem_of(signature)), {}, {}};
    for (std::size_t i = 0; i < feature_count; ++i)
        for (std::size_t copy = 0; copy < signature[i]; ++copy) {
            posed.blocks.push_back(&pool.blocks[i][copy]);
            posed.parts.push_back(&pool.parts[i][copy]);
        }
    return posed;
}

ClassRecord certify_class(const Signature& signature, std::size_t number,
                          std::vector<PreparedPool>& pools) {
    for (std::size_t index = 0; index < max_pools; ++index) {
        if (index == pools.size()) pools.push_back(prepare(index + 1));
        if (auto minor = find_minor(pose(signature, pools[index])))
            return {number, index, std::move(*minor)};
    }
    throw std::runtime_error("class " + std::to_string(number) + " is rank-deficient in all " +
                             std::to_string(max_pools) + " pools, but has no obstruction for it");
}

} // namespace

ClassificationFile certify_classification(const std::vector<Signature>& classes,
                                          const Progress& progress) {
    ClassificationFile file;
    std::vector<PreparedPool> pools;
    for (std::size_t number = 0; number < classes.size(); ++number) {
        file.records.push_back(certify_class(classes[number], number, pools));
        if (number % progress_interval == 0) progress(number);
    }
    for (PreparedPool& prepared : pools)
        file.pools.push_back(std::move(prepared.pool));
    return file;
}

} // namespace plprove
