// Numbers of subspaces of dimension 3 that meet general subspaces, for Lemma V2 of
// proofs/four_and_five_views.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>

namespace proofs {

/// A Schubert class of a Grassmannian of subspaces of dimension 3.
using Partition3 = std::array<std::size_t, 3>;

/// A sum of Schubert classes.
using SchubertSum = std::map<Partition3, std::int64_t>;

/// The product with the class sigma_a, by Pieri's rule, for subspaces of any large space.
inline SchubertSum times_special(const SchubertSum& sum, std::size_t a) {
    SchubertSum result;
    for (const auto& [part, number] : sum) {
        for (std::size_t y = 0; y <= a && y <= part[0] - part[1]; ++y)
            for (std::size_t z = 0; y + z <= a && z <= part[1] - part[2]; ++z)
                result[{part[0] + a - y - z, part[1] + y, part[2] + z}] += number;
    }
    return result;
}

/// The product with sigma_{a,a} = sigma_a^2 - sigma_{a+1} sigma_{a-1}.
inline SchubertSum times_double(const SchubertSum& sum, std::size_t a) {
    SchubertSum result = times_special(times_special(sum, a), a);
    for (const auto& [part, number] : times_special(times_special(sum, a + 1), a - 1))
        result[part] -= number;
    return result;
}

/// In Gr(3, 3 m - 1): the integral of sigma_{m-2}^pins sigma_{m-2,m-2}^lines. It is a number if the
/// problem of m views is balanced.
inline std::int64_t schubert_number(std::size_t m, std::size_t pins, std::size_t lines) {
    SchubertSum sum{{{0, 0, 0}, 1}};
    for (std::size_t i = 0; i < pins; ++i)
        sum = times_special(sum, m - 2);
    for (std::size_t i = 0; i < lines; ++i)
        sum = times_double(sum, m - 2);
    const std::size_t width = 3 * m - 4;
    return sum[{width, width, width}];
}

} // namespace proofs
