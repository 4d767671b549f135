#include "prover/minimal/pool.h"

#include <stdexcept>

namespace plprove {

namespace {

constexpr std::int64_t pool_bound = 9;

} // namespace

std::int64_t SmallIntegers::next() {
    // SplitMix64 (Steele, Lea, Flood 2014): a few lines, and the same numbers with every standard
    // library.
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    z ^= z >> 31;
    return static_cast<std::int64_t>(z % static_cast<std::uint64_t>(2 * bound_ + 1)) - bound_;
}

Cameras random_cameras(SmallIntegers& integers, int views) {
    Cameras cameras(static_cast<std::size_t>(views - 1));
    do
        for (Camera& camera : cameras) {
            // Quaternion entries enter squared: a smaller range keeps the rotation matrices
            // readable.
            for (std::int64_t& entry : camera.quaternion)
                entry = integers.next() / 3;
            camera.translation = integers.vector();
        }
    while (defect(cameras));
    return cameras;
}

PlacedFeature random_placement(const Feature& feature, const Cameras& cameras,
                               SmallIntegers& integers) {
    PlacedFeature placed{feature, {}, {}};
    do {
        placed.point = integers.vector();
        placed.directions.assign(static_cast<std::size_t>(feature.lines), {});
        for (Vector3& direction : placed.directions)
            direction = integers.vector();
    } while (defect(placed, cameras));
    return placed;
}

Pool make_pool(std::uint64_t seed) {
    SmallIntegers integers(seed, pool_bound);
    Pool pool{random_cameras(integers, 3), {}};
    for (std::size_t i = 0; i < feature_count; ++i) {
        const Feature& feature = standard_features()[i];
        const auto copies = static_cast<std::size_t>(camera_dimension / weight(feature));
        while (pool.instances[i].size() < copies) {
            PlacedFeature placed = random_placement(feature, pool.cameras, integers);
            // In special position its own unknowns cannot be eliminated.
            if (eliminate(feature_block(placed, pool.cameras)))
                pool.instances[i].push_back(std::move(placed));
        }
    }
    return pool;
}

CameraParts camera_parts(const Pool& pool) {
    CameraParts parts;
    for (std::size_t i = 0; i < feature_count; ++i)
        for (const PlacedFeature& placed : pool.instances[i]) {
            auto part = eliminate(feature_block(placed, pool.cameras));
            if (!part) throw std::logic_error("a pool holds a degenerate feature");
            parts[i].push_back(std::move(*part));
        }
    return parts;
}

} // namespace plprove
