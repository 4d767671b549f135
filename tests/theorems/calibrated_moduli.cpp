// The integrals of Theorem Y (proofs/calibrated_moduli.md) by second methods: numbers of invariants
// give one of them, and no choice matters. The program proofs/computations/calibrated_moduli.cpp,
// which is a test, too, compares the numbers of the theorem with the checker's table.
#include "proofs/computations/moduli_space.h"

#include <doctest/doctest.h>

#include <array>
#include <vector>

using namespace proofs;

namespace {

/// How many times each weight of the torus of SL_2 occurs, from the lowest weight, in steps of 2.
using Multiplicities = std::vector<std::int64_t>;

Multiplicities product(const Multiplicities& a, const Multiplicities& b) {
    Multiplicities result(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            result[i + j] += a[i] * b[j];
    return result;
}

/// Polynomials of this degree in four coordinates, two of each weight 1 and -1.
Multiplicities of_quaternion(std::int64_t degree) {
    Multiplicities result;
    for (std::int64_t k = 0; k <= degree; ++k)
        result.push_back((k + 1) * (degree - k + 1));
    return result;
}

/// The dimension of the invariants: how much more often the weight 0 occurs than 2.
std::int64_t invariants(const Multiplicities& all) {
    if (all.size() % 2 == 0) return 0;
    const std::size_t middle = all.size() / 2;
    return all[middle] - (middle == 0 ? 0 : all[middle - 1]);
}

/// All products of polynomials of these degrees less 2 m_v in the quaternions, and of degrees m_v in
/// the translations, which are three to a view, for all m_v with this sum.
Multiplicities polynomials(const std::array<std::int64_t, 3>& degrees, std::int64_t sum) {
    const auto factor = [&](std::size_t view, std::int64_t m) {
        Multiplicities all = of_quaternion(degrees[view] - 2 * m);
        for (std::int64_t& one : all)
            one *= (m + 1) * (m + 2) / 2;
        return all;
    };
    Multiplicities total(static_cast<std::size_t>(degrees[0] + degrees[1] + degrees[2] - 2 * sum) +
                         1);
    for (std::int64_t m1 = 0; m1 <= sum; ++m1) {
        for (std::int64_t m2 = 0; m1 + m2 <= sum; ++m2) {
            const Multiplicities term =
                product(factor(0, m1), product(factor(1, m2), factor(2, sum - m1 - m2)));
            for (std::size_t i = 0; i < total.size(); ++i)
                total[i] += term[i];
        }
    }
    return total;
}

/// The Euler characteristic of the n-th power of the line bundle of this character: translations of
/// space are divided out, by exterior powers of their three coordinates, of the weights 2, 0, -2.
std::int64_t euler_characteristic(const Character& bundle, std::int64_t n) {
    const std::array<std::int64_t, 3> degrees{n * bundle[a1], n * bundle[a2], n * bundle[a3]};
    const std::array<Multiplicities, 4> exterior{{{1}, {1, 1, 1}, {1, 1, 1}, {1}}};
    std::int64_t sum = 0;
    for (std::int64_t j = 0; j <= 3 && j <= n * bundle[s]; ++j) {
        const auto all = product(exterior[static_cast<std::size_t>(j)],
                                 polynomials(degrees, n * bundle[s] - j));
        sum += j % 2 == 0 ? invariants(all) : -invariants(all);
    }
    return sum;
}

/// The difference of order 11, that is 11! times the leading coefficient of a polynomial of degree
/// 11: the integral of the power of the first Chern class.
std::int64_t top_difference(const Character& bundle) {
    std::vector<std::int64_t> values;
    for (std::int64_t n = 0; n <= 12; ++n)
        values.push_back(euler_characteristic(bundle, n));
    for (int order = 0; order < 11; ++order) {
        for (std::size_t i = 0; i + 1 < values.size(); ++i)
            values[i] = values[i + 1] - values[i];
        values.pop_back();
    }
    CHECK(values[0] == values[1]); // it is a polynomial of degree 11
    return values[0];
}

} // namespace
