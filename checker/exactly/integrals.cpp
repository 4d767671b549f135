#include "checker/exactly/integrals.h"

#include "checker/exactly/many_pins.h"

namespace checker::exactly {
/// How the coefficients of a polynomial of degree n follow from its values at 0, 1, ..., n: in row
/// j those of the polynomial that is 1 at j, and 0 at the others.
static std::vector<Polynomial> interpolation(std::size_t degree) {
    std::vector<Polynomial> rows;
    for (std::uint64_t j = 0; j <= degree; ++j) {
        Polynomial row{{Residue{1}}};
        for (std::uint64_t i = 0; i <= degree; ++i) {
            if (i == j) continue;
            const Residue scale = inverse(Residue{j} - Residue{i});
            row = row * Polynomial{{-(Residue{i} * scale), scale}};
        }
        rows.push_back(row);
    }
    return rows;
}

/// By which factor the value of a polynomial at Gamma_uv = j counts, if its powers beyond the
/// second are replaced by the numbers of Lemma C2, and the others by 0.
static std::vector<Residue> weights_of_values(const std::vector<Residue>& powers,
                                              const std::vector<Polynomial>& rows) {
    std::vector<Residue> weights;
    for (const Polynomial& row : rows) {
        Residue weight;
        for (std::size_t i = 3; i < rows.size(); ++i)
            weight = weight + powers[i] * row.at[i];
        weights.push_back(weight);
    }
    return weights;
}

void WeightedSum::add(std::size_t chart, const std::array<unsigned, 3>& gamma, Residue weight) {
    nodes_.push_back({chart, {Residue{gamma[0]}, Residue{gamma[1]}, Residue{gamma[2]}}});
    weights_.push_back(weight);
}

const std::vector<Residue>& WeightedSum::values_of(std::size_t feature,
                                                   const ClassAtCharts& classes) {
    std::vector<Residue>& values = values_[feature];
    if (!values.empty()) return values;
    for (const auto& [chart, gamma] : nodes_) {
        const auto& [constant, common] = classes[chart];
        values.push_back(constant + common[0] * gamma[0] + common[1] * gamma[1] +
                         common[2] * gamma[2]);
    }
    return values;
}

Residue WeightedSum::of(const Factors& factors,
                        const std::array<std::optional<ClassAtCharts>, feature_count>& classes) {
    std::size_t kept = 0; // products that are those of these factors, too
    while (kept < products_.size() && kept + 1 < factors.size() &&
           products_[kept].last_factor == factors[kept])
        ++kept;
    products_.resize(kept);
    for (std::size_t i = kept; i + 1 < factors.size(); ++i) {
        const std::vector<Residue>& values = values_of(factors[i], *classes[factors[i]]);
        const std::vector<Residue>& others = i == 0 ? weights_ : products_[i - 1].values;
        Product product{factors[i], std::vector<Residue>(values.size())};
        for (std::size_t n = 0; n < values.size(); ++n)
            product.values[n] = others[n] * values[n];
        products_.push_back(std::move(product));
    }
    const std::vector<Residue>& values = values_of(factors.back(), *classes[factors.back()]);
    const std::vector<Residue>& others = factors.size() == 1 ? weights_ : products_.back().values;
    Residue sum;
    std::size_t n = 0;
    for (; n + 1 < values.size(); n += 2)
        sum = sum + Residue::sum_of_products(others[n], values[n], others[n + 1], values[n + 1]);
    return n == values.size() ? sum : sum + others[n] * values[n];
}

/// The integer of least absolute value with this residue.
static std::int64_t signed_value(Residue residue) {
    const auto value = static_cast<std::int64_t>(residue.value);
    const auto q = static_cast<std::int64_t>(modulus);
    return value > q / 2 ? value - q : value;
}

/// Whether the two views other than this one share three points or more. Else no class of a feature
/// times others has a power of their Gamma beyond the second: each is linear in it, and without it
/// where they do not share the point.
static bool has_powers(const Signature& signature, std::size_t third) {
    const Views pair = all_views ^ 1U << third;
    unsigned points = 0;
    for (std::size_t i = 0; i < feature_count; ++i)
        if ((features[i].point & pair) == pair) points += signature[i];
    return points >= 3;
}

Integrals::Integrals(std::size_t most_shared, std::uint64_t seed)
    : charts_(charts_of_second_blow_up(seed)) {
    constexpr std::size_t most_beside_another = 8; // 11 features at most, of these 3 for another
    const std::size_t fewer = std::min(most_shared, most_beside_another);
    const std::vector<Polynomial> rows = interpolation(most_shared),
                                  rows_of_two = interpolation(fewer);
    for (std::size_t c = 0; c < charts_.size(); ++c) {
        const Residue weight = charts_[c].at.weight;
        without_centres_.add(c, {}, weight);
        std::array<std::vector<Residue>, 3> of_two;
        for (std::size_t third = 0; third < 3; ++third) {
            const auto powers = powers_of_common_centres(charts_[c], third, most_shared);
            if (powers[3] == Residue{}) continue; // not on C_uv
            const std::vector<Residue> of_one = weights_of_values(powers, rows);
            of_two[third] = weights_of_values(powers, rows_of_two);
            for (unsigned j = 0; j < of_one.size(); ++j) {
                std::array<unsigned, 3> gamma{};
                gamma[third] = j;
                with_one_[third].add(c, gamma, weight * of_one[j]);
            }
        }
        for (std::size_t third = 0; third < 3; ++third) {
            const std::size_t next = (third + 1) % 3;
            for (unsigned i = 0; i < of_two[third].size(); ++i)
                for (unsigned j = 0; j < of_two[next].size(); ++j) {
                    std::array<unsigned, 3> gamma{};
                    gamma[third] = i;
                    gamma[next] = j;
                    with_two_[third].add(c, gamma, weight * of_two[third][i] * of_two[next][j]);
                }
        }
    }
}

Factors Integrals::factors_of(const Signature& signature) {
    Factors factors;
    for (std::size_t i = 0; i < feature_count; ++i) {
        if (signature[i] == 0) continue;
        factors.insert(factors.end(), signature[i], i);
        if (classes_[i]) continue;
        const auto class_at = is_star(features[i]) ? class_of_star : class_of;
        classes_[i].emplace();
        for (const Chart& chart : charts_)
            classes_[i]->push_back(class_at(chart, features[i]));
    }
    return factors;
}

std::int64_t Integrals::over_second_blow_up(const Signature& signature) {
    return signed_value(without_centres_.of(factors_of(signature), classes_));
}

std::int64_t Integrals::over_third_blow_up(const Signature& signature) {
    const Factors factors = factors_of(signature);
    Residue sum = without_centres_.of(factors, classes_);
    for (std::size_t third = 0; third < 3; ++third) {
        if (!has_powers(signature, third)) continue;
        sum = sum + with_one_[third].of(factors, classes_);
        if (has_powers(signature, (third + 1) % 3))
            sum = sum + with_two_[third].of(factors, classes_);
    }
    return signed_value(sum);
}
} // namespace checker::exactly
