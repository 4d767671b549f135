// Determinants of integer matrices by a second method.
#pragma once

#include <gmpxx.h>

#include <utility>
#include <vector>

/// The determinant over the integers, by Bareiss's method.
inline mpz_class exact_determinant(std::vector<std::vector<mpz_class>> m) {
    mpz_class sign = 1, previous = 1;
    for (std::size_t c = 0; c < m.size(); ++c) {
        std::size_t pivot = c;
        while (pivot < m.size() && m[pivot][c] == 0)
            ++pivot;
        if (pivot == m.size()) return 0;
        if (pivot != c) sign = -sign;
        std::swap(m[c], m[pivot]);
        for (std::size_t r = c + 1; r < m.size(); ++r)
            for (std::size_t k = m.size(); k-- > c;)
                m[r][k] = (m[c][c] * m[r][k] - m[r][c] * m[c][k]) / previous;
        previous = m[c][c];
    }
    return sign * previous;
}
