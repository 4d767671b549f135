#include "prover/groups/permutation.h"

#include <algorithm>
#include <numeric>

namespace plprove {

Permutation identity(int degree) {
    Permutation result(as_index(degree));
    std::iota(result.begin(), result.end(), 0);
    return result;
}

bool is_identity(const Permutation& permutation) {
    for (std::size_t i = 0; i < permutation.size(); ++i)
        if (permutation[i] != static_cast<int>(i)) return false;
    return true;
}

Permutation then(const Permutation& first, const Permutation& second) {
    Permutation result(first.size());
    for (std::size_t i = 0; i < first.size(); ++i)
        result[i] = second[as_index(first[i])];
    return result;
}

Permutation inverse(const Permutation& permutation) {
    Permutation result(permutation.size());
    for (std::size_t i = 0; i < permutation.size(); ++i)
        result[as_index(permutation[i])] = static_cast<int>(i);
    return result;
}

std::vector<int> cycle_type(const Permutation& permutation) {
    std::vector<int> lengths;
    std::vector<bool> met(permutation.size());
    for (std::size_t start = 0; start < permutation.size(); ++start) {
        int length = 0;
        for (std::size_t at = start; !met[at]; at = as_index(permutation[at])) {
            met[at] = true;
            ++length;
        }
        if (length > 0) lengths.push_back(length);
    }
    std::ranges::sort(lengths);
    return lengths;
}

bool is_even(const Permutation& permutation) {
    return (permutation.size() - cycle_type(permutation).size()) % 2 == 0;
}

RandomElements::RandomElements(const std::vector<Permutation>& generators)
    : last_(identity(static_cast<int>(generators.front().size()))) {
    constexpr std::size_t pool_size = 10;
    constexpr int mixing = 50;
    while (pool_.size() < std::max(pool_size, generators.size()))
        pool_.push_back(generators[pool_.size() % generators.size()]);
    for (int i = 0; i < mixing; ++i)
        next();
}

Permutation RandomElements::next() {
    const std::size_t i = random_() % pool_.size();
    const std::size_t j = (i + 1 + random_() % (pool_.size() - 1)) % pool_.size();
    const auto choice = random_();
    const Permutation factor = (choice & 1U) != 0 ? inverse(pool_[j]) : pool_[j];
    pool_[i] = (choice & 2U) != 0 ? then(factor, pool_[i]) : then(pool_[i], factor);
    last_ = then(last_, pool_[i]);
    return last_;
}

} // namespace plprove
