// Points of the joint camera map at which tests build Jacobians: cameras, and random features.
#pragma once

#include "checker/minimal/pool.h"

#include <random>

/// Cameras 2 and 3 of three in general position.
inline const std::vector<checker::Numbers>& three_cameras() {
    static const std::vector<checker::Numbers> cameras{{1, 2, -1, 3, 5, -2, 4},
                                                       {2, -3, 1, 1, -4, 7, 3}};
    return cameras;
}

/// Reproducible integers from -bound to bound.
class RandomIntegers {
public:
    int operator()(int bound) { return std::uniform_int_distribution(-bound, bound)(engine_); }

private:
    std::mt19937_64 engine_{20};
};

/// A random point of the domain. Third coordinates are not 0.
inline checker::Numbers random_placement(const checker::Feature& feature, RandomIntegers& random) {
    checker::Numbers numbers;
    for (std::size_t i = 0; i < 3 * (feature.pins + 1); ++i)
        numbers.push_back(random(9999));
    for (std::size_t i = 2; i < numbers.size(); i += 3)
        if (numbers[i] == 0) numbers[i] = 1;
    return numbers;
}

/// The component of a feature at such a point.
inline checker::Component random_component(const checker::Feature& feature,
                                                 RandomIntegers& random) {
    const checker::Numbers placement = random_placement(feature, random);
    return checker::component_of(
        feature.unknowns(), checker::rows_of(feature, 3, {three_cameras(), placement}).rows);
}
