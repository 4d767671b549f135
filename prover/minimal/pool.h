// Pools: one set of cameras with enough placed features of each kind to pose every problem of the
// classification at once. Coordinates are small, since people read them, and pseudo-random from a
// seed, since special positions make minors vanish.
#pragma once

#include "prover/minimal/block.h"
#include "prover/problem/signature.h"

namespace plprove {

/// Cameras and, for each of the 27 features, placed instances of it: the number that a balanced
/// problem can have.
struct Pool {
    Cameras cameras;
    std::array<std::vector<PlacedFeature>, feature_count> instances;
};

/// The camera parts of a pool's instances, in the same arrangement.
using CameraParts = std::array<std::vector<CameraPart>, feature_count>;

/// A reproducible source of small integers: the same numbers on every machine.
class SmallIntegers {
public:
    /// Integers of absolute value at most `bound`.
    SmallIntegers(std::uint64_t seed, std::int64_t bound) : state_(seed), bound_(bound) {}
    std::int64_t next();
    Vector3 vector() {
        const std::int64_t x = next();
        const std::int64_t y = next();
        return {x, y, next()};
    }

private:
    std::uint64_t state_;
    std::int64_t bound_;
};

/// Cameras 2, ..., `views` without defect.
Cameras random_cameras(SmallIntegers& integers, int views);

/// The feature placed without defect before the cameras.
PlacedFeature random_placement(const Feature& feature, const Cameras& cameras,
                               SmallIntegers& integers);

/// The pool of this seed.
Pool make_pool(std::uint64_t seed);

/// Eliminates every instance of the pool.
CameraParts camera_parts(const Pool& pool);

} // namespace plprove
