#include "checker/general_bounds/hilbert.h"

#include "checker/general_bounds/stability.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>

namespace checker {
namespace {

using Partition = std::array<int, 4>;

/// A sum of Schur functions of four variables: their coefficients, by partitions. (Those of
/// partitions with more than four rows are zero.)
using Schur = std::map<Partition, mpz_class>;

/// A point with its pins, which are the lines through it, or a free line. It stands for the sum of
/// K S_(first n, p) over the partitions p with no row longer than first n, where K is the
/// coefficient of S_p in h_n^pins. A point has first = 2; a free line, for S_(n, n), has
/// first = pins = 1.
struct FeatureType {
    int first = 0;
    int pins = 0;
};

/// The product with h_boxes, by Pieri's rule: adds boxes, no two of them in one column. Leaves out
/// partitions with a row that is longer than this; further products only make it longer.
Schur times_h(const Schur& sum, int boxes, int longest) {
    Schur product;
    for (const auto& [p, coefficient] : sum) {
        const int size = std::accumulate(p.begin(), p.end(), boxes);
        for (int d = p[3]; d <= p[2]; ++d)
            for (int c = p[2]; c <= p[1]; ++c) {
                const int rest = size - c - d;
                const int most = std::min(p[0], rest - p[0]);
                for (int b = std::max(p[1], rest - longest); b <= most; ++b)
                    product[{rest - b, b, c, d}] += coefficient;
            }
    }
    return product;
}

/// What the feature stands for.
Schur expansion(const FeatureType& feature, int n) {
    const int first = feature.first * n;
    Schur power{{Partition{}, 1}};
    for (int pin = 0; pin < feature.pins; ++pin)
        power = times_h(power, n, first);
    Schur sum;
    for (const auto& [p, coefficient] : power)
        if (p[3] == 0) sum[{first, p[0], p[1], p[2]}] = coefficient;
    return sum;
}

/// The product with what the feature stands for, if it has not more pins than first: then no row of
/// p is too long, and the Jacobi-Trudi determinants, expanded along their first rows, add up to the
/// sum of (-1)^i binomial(pins, i) h_(first n + i) h_n^(pins - i) h_(n - 1)^i.
Schur times_feature(const Schur& factor, const FeatureType& feature, int n) {
    Schur product;
    int weight = 1;
    for (int i = 0; i <= feature.pins; ++i) {
        Schur term = times_h(factor, feature.first * n + i, 3 * n);
        for (int pin = 0; pin < feature.pins; ++pin)
            term = times_h(term, pin < i ? n - 1 : n, 3 * n);
        for (const auto& [p, coefficient] : term)
            product[p] += weight * coefficient;
        weight = -weight * (feature.pins - i) / (i + 1);
    }
    std::erase_if(product, [](const auto& term) { return term.second == 0; });
    return product;
}

/// The coefficient of S_(3n, 3n, 3n, 3n) in a product: S_p has there one partner.
mpz_class determinants(const Schur& a, const Schur& b, int n) {
    mpz_class sum;
    for (const auto& [p, coefficient] : a) {
        const auto partner = b.find({3 * n - p[3], 3 * n - p[2], 3 * n - p[1], 3 * n - p[0]});
        if (partner != b.end()) sum += coefficient * partner->second;
    }
    return sum;
}

/// The types of the features of a problem of Theorem T, the ones with most pins first; none of
/// another problem.
std::vector<FeatureType> feature_types_of(const Problem& problem) {
    if (!problem.cameras->all_matrices || !all_views_see_all(problem) || surplus(problem) != 0)
        return {};
    std::vector<FeatureType> types;
    int equations = 0; // of each view
    for (const Point& point : problem.points) {
        types.push_back({.first = 2, .pins = static_cast<int>(point.lines.size())});
        equations += 2 + types.back().pins;
    }
    for (const Line& line : problem.lines) {
        if (line.points.size() > 1) return {};
        if (!line.points.empty()) continue;
        types.push_back({.first = 1, .pins = 1});
        equations += 2;
    }
    if (equations != 12) return {};
    std::ranges::sort(types, std::greater{}, &FeatureType::pins);
    return types;
}

/// The first two features have representations as large as they are; each other has at most two
/// pins, as three points with three pins or more give fifteen equations.
mpz_class invariants(const std::vector<FeatureType>& types, int n) {
    std::array<Schur, 2> products{expansion(types[0], n), {{Partition{}, 1}}};
    if (types.size() > 1) products[1] = expansion(types[1], n);
    for (std::size_t i = 2; i < types.size(); ++i)
        products[i % 2] = times_feature(products[i % 2], types[i], n);
    return determinants(products[0], products[1], n);
}

} // namespace

std::optional<mpz_class> invariants(const Problem& problem, int n) {
    const std::vector<FeatureType> types = feature_types_of(problem);
    if (types.empty()) return std::nullopt;
    return invariants(types, n);
}

std::optional<std::size_t> degree_by_invariants(const Problem& problem) {
    const std::vector<FeatureType> types = feature_types_of(problem);
    if (types.empty() || !general_arrangements_are_stable(problem)) return std::nullopt;
    std::vector<mpz_class> values;
    for (int n = 0; n <= std::popcount(problem.views); ++n)
        values.push_back(invariants(types, n));
    for (; values.size() > 1; values.pop_back())
        for (std::size_t i = 0; i + 1 < values.size(); ++i)
            values[i] = values[i + 1] - values[i];
    if (values[0] < 0) throw std::logic_error("a degree is negative");
    return values[0].get_ui();
}
} // namespace checker
