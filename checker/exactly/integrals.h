// Integrals of products of classes of features over the second and the third blow-up of the space
// of calibrated cameras, as sums over fixed points.
#pragma once

#include "checker/exactly/common_centres.h"
#include "checker/problem/classes.h"

#include <optional>

namespace checker::exactly {
/// The classes of a feature at all charts.
using ClassAtCharts = std::vector<LinearClass>;

/// The numbers of the features of a signature, each as often as it occurs.
using Factors = std::vector<std::size_t>;

/// A sum over charts and values of the three Gamma_uv: of weights, times the values of classes of
/// features there. What the products of all factors but the last are, is kept: it serves the next
/// signature that begins alike.
class WeightedSum {
public:
    void add(std::size_t chart, const std::array<unsigned, 3>& gamma, Residue weight);

    /// The sum for these factors, whose classes are among those given.
    Residue of(const Factors& factors,
               const std::array<std::optional<ClassAtCharts>, feature_count>& classes);

private:
    struct Node {
        std::size_t chart = 0;
        Triple gamma{}; // the values of the three divisors
    };
    struct Product {
        std::size_t last_factor = 0;
        std::vector<Residue> values{}; // with the weights
    };

    const std::vector<Residue>& values_of(std::size_t feature, const ClassAtCharts& classes);

    std::vector<Node> nodes_{};
    std::vector<Residue> weights_{};
    std::array<std::vector<Residue>, feature_count> values_{};
    std::vector<Product> products_{}; // of the first factor, of the first two, ...
};

/// The integrals, for signatures in which two views share at most `most_shared` points: of all
/// minimal problems, five. The first call costs half a second. The results do not depend on the
/// seed.
class Integrals {
public:
    explicit Integrals(std::size_t most_shared = 5, std::uint64_t seed = 5);

    /// Over the second blow-up: without Gamma.
    std::int64_t over_second_blow_up(const Signature& signature);

    /// Over the third blow-up, the products of powers of the Gamma_uv replaced by Lemma C2.
    std::int64_t over_third_blow_up(const Signature& signature);

private:
    Factors factors_of(const Signature& signature);

    std::vector<Chart> charts_{};
    std::array<std::optional<ClassAtCharts>, feature_count> classes_{};
    WeightedSum without_centres_{};         // Gamma = 0
    std::array<WeightedSum, 3> with_one_{}; // the powers of one Gamma_uv beyond the second, by the
                                            // third view
    std::array<WeightedSum, 3> with_two_{}; // the products of such powers of it and of the next.
                                            // Of three, they are 0
};
} // namespace checker::exactly
