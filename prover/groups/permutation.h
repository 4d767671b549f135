// Permutations of the numbers 0, ..., d - 1.
#pragma once

#include <cstddef>
#include <random>
#include <vector>

namespace plprove {

/// The image of each number.
using Permutation = std::vector<int>;

constexpr std::size_t as_index(int number) {
    return static_cast<std::size_t>(number);
}

Permutation identity(int degree);
bool is_identity(const Permutation& permutation);

/// First one, then the other.
Permutation then(const Permutation& first, const Permutation& second);
Permutation inverse(const Permutation& permutation);

/// The lengths of its cycles, ascending; those of length 1, too.
std::vector<int> cycle_type(const Permutation& permutation);
bool is_even(const Permutation& permutation);

/// Elements of the group that some permutations generate, nearly random ones (product replacement).
class RandomElements {
public:
    /// At least one generator.
    explicit RandomElements(const std::vector<Permutation>& generators);
    Permutation next();

private:
    std::vector<Permutation> pool_;
    Permutation last_;
    std::mt19937_64 random_; // the same numbers on every machine
};

} // namespace plprove
