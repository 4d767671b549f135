// Integrals over the thrice blown-up space of proofs/common_centres.md, for Theorem K of
// proofs/four_pins.md: a point with four pins, whatever else views share.
#pragma once

#include "proofs/computations/points_with_many_pins.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace proofs::blown_up {

/// A class that is linear in the divisors of common centres, ordered by the view that they lack.
struct LinearClass {
    Residue constant{};
    Triple common{};
};

/// The class of the common centre of the other two views than the third one, a line of V.
inline Residue common_centre(const Chart& chart, std::size_t third) {
    return chart.at->x[3] - chart.both[third];
}

/// The integral over P(B / c) of a polynomial, for a bundle B with these roots and a line c.
inline Residue integral_over_quotient(const Polynomial& f, const Roots& roots, Residue c) {
    const std::size_t rank = roots.size() - 1;
    Polynomial complete(f.size() + 1);
    complete[0] = Residue{1};
    for (const Residue root : roots)
        for (std::size_t i = 1; i < complete.size(); ++i)
            complete[i] = complete[i] + root * complete[i - 1];
    for (std::size_t i = complete.size() - 1; i > 0; --i)
        complete[i] = complete[i] - c * complete[i - 1];
    Residue sum;
    for (std::size_t i = rank - 1; i < f.size(); ++i)
        sum = sum + f[i] * complete[i + 1 - rank];
    return rank % 2 == 1 ? sum : -sum;
}

/// What a common centre adds to the class of a point with four pins, but for Lemma C6.
inline Residue star_at_common_centre(const Chart& chart, std::size_t third) {
    const FixedPoint& at = *chart.at;
    const Residue c = common_centre(chart, third);
    const Roots roots(at.x.begin(), at.x.end());
    const std::array<std::size_t, 2> pair{(third + 1) % 3, (third + 2) % 3};
    const Polynomial seen_by_third = point_seen(at, third);
    const Polynomial first = point_seen(at, pair[0]), second = point_seen(at, pair[1]);
    Residue sum = integral_over_quotient(first * second * seen_by_third, roots, c);
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t u = pair[i];
        if (at.isotropic[u] == Residue{}) continue;
        const Polynomial other = i == 0 ? second : first;
        const Roots kernel = without(roots, at.w[u][0]);
        sum = sum +
              (at.h[u] - at.image[u]) * integral_over_quotient(other * seen_by_third, kernel, c);
    }
    return value_at(seen_by_third, c) * sum;
}

inline LinearClass linear_class_of(const Chart& chart, const checker::Feature& feature) {
    LinearClass result{corrected_class_of(chart, feature), {}};
    if (feature.free_line) return result;
    for (std::size_t third = 0; third < 3; ++third) {
        const checker::Views pair = checker::all_views ^ 1U << third;
        if ((feature.point & pair) != pair) continue;
        Residue& common = result.common[third];
        common =
            -value_at(feature_seen(*chart.at, feature, 1U << third), common_centre(chart, third));
        if (feature.point == pair && feature.pins == 1 && feature.pin[0] == checker::all_views)
            common = common + chart.at->isotropic[third];
        if (is_star(feature)) common = common + star_at_common_centre(chart, third);
    }
    return result;
}

/// More than the number of features of a problem with such a point.
inline constexpr std::size_t powers = 6;

/// The total Chern class of the normal bundle of the locus of common centres, which is that of all
/// points where V -> W_u + W_v has a kernel, with V as it is after division by the equation of the
/// divisor over two null views. The coefficients are the Chern classes.
inline Polynomial normal_class_of_common_centres(const Chart& chart, std::size_t third) {
    const FixedPoint& at = *chart.at;
    const Residue line = at.x[3]; // V / H
    Polynomial c(powers);
    c[0] = Residue{1};
    const auto times = [&](Residue root) {
        for (std::size_t i = powers - 1; i > 0; --i)
            c[i] = c[i] + root * c[i - 1];
    };
    for (std::size_t view = 0; view < 3; ++view)
        if (view != third)
            for (const Residue root : at.w[view])
                times(root - line);
    times(-line);
    const auto divided_by = [&](Residue root) {
        for (std::size_t i = 1; i < powers; ++i)
            c[i] = c[i] - root * c[i - 1];
    };
    for (std::size_t i = 0; i < 3; ++i)
        divided_by(at.x[i] - line);
    divided_by(chart.both[third] - line);
    return c;
}

/// Lemma C2: what the powers of the divisor of common centres become on the space below.
inline std::array<Residue, powers> powers_of_common_centres(const Chart& chart, std::size_t third) {
    const Polynomial c = normal_class_of_common_centres(chart, third);
    std::array<Residue, powers> result{Residue{1}};
    Polynomial segre(powers);
    for (std::size_t i = 0; i + 3 < powers; ++i) {
        segre[i] = i == 0 ? Residue{1} : Residue{};
        for (std::size_t j = 1; j <= std::min<std::size_t>(i, 3); ++j)
            segre[i] = segre[i] - c[j] * segre[i - j];
        result[i + 3] = i % 2 == 0 ? segre[i] * c[3] : -(segre[i] * c[3]);
    }
    return result;
}

/// A polynomial in the three divisors.
class DivisorPolynomial {
public:
    DivisorPolynomial() { at(0, 0, 0) = Residue{1}; }

    void multiply_by(const LinearClass& factor) {
        DivisorPolynomial product;
        product.at(0, 0, 0) = {};
        for (std::size_t i = 0; i < powers; ++i)
            for (std::size_t j = 0; i + j < powers; ++j)
                for (std::size_t k = 0; i + j + k < powers; ++k) {
                    const Residue value = at(i, j, k);
                    if (value == Residue{}) continue;
                    product.add(i, j, k, value * factor.constant);
                    product.add(i + 1, j, k, value * factor.common[0]);
                    product.add(i, j + 1, k, value * factor.common[1]);
                    product.add(i, j, k + 1, value * factor.common[2]);
                }
        *this = product;
    }

    /// With these numbers instead of the powers of the divisors.
    Residue value(const std::array<std::array<Residue, powers>, 3>& numbers) const {
        Residue sum;
        for (std::size_t i = 0; i < powers; ++i)
            for (std::size_t j = 0; j < powers; ++j)
                for (std::size_t k = 0; k < powers; ++k)
                    sum = sum + coefficients_[(i * powers + j) * powers + k] * numbers[0][i] *
                                    numbers[1][j] * numbers[2][k];
        return sum;
    }

private:
    Residue& at(std::size_t i, std::size_t j, std::size_t k) {
        return coefficients_[(i * powers + j) * powers + k];
    }

    void add(std::size_t i, std::size_t j, std::size_t k, Residue value) {
        if (value == Residue{}) return;
        if (i + j + k >= powers) throw std::logic_error("too many features");
        at(i, j, k) = at(i, j, k) + value;
    }

    std::array<Residue, powers * powers * powers> coefficients_{};
};

/// Integrals of products of the class of a point with four pins and classes of features with one
/// pin at most, over the thrice blown-up space.
class FourPinIntegrals {
public:
    std::int64_t of(const checker::Signature& signature) const {
        Residue sum;
        for (const Values& values : charts_) {
            DivisorPolynomial product;
            for (std::size_t i = 0; i < checker::feature_count; ++i)
                for (unsigned n = 0; n < signature[i]; ++n)
                    product.multiply_by(values.features[i]);
            sum = sum + values.factor * product.value(values.common);
        }
        return signed_value(sum);
    }

    explicit FourPinIntegrals(std::uint64_t seed = 5) {
        for (const FixedPoint& at : fixed_points(seed)) {
            for (const Chart& chart : charts_over(at)) {
                Values values{chart.factor * at.weight, {}, {}};
                for (std::size_t third = 0; third < 3; ++third)
                    values.common[third] = powers_of_common_centres(chart, third);
                for (std::size_t i = 0; i < checker::feature_count; ++i) {
                    const checker::Feature& feature = checker::features[i];
                    if (feature.pins <= 1 || feature.pins == 4)
                        values.features[i] = linear_class_of(chart, feature);
                }
                charts_.push_back(values);
            }
        }
    }

private:
    struct Values {
        Residue factor{};
        std::array<std::array<Residue, powers>, 3> common{};
        std::array<LinearClass, checker::feature_count> features{};
    };
    std::vector<Values> charts_{};
};

} // namespace proofs::blown_up
