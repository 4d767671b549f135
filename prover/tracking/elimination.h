// Gauss' elimination of rows whose sizes are known only when the program runs.
//
// No function of the standard library is used here: see lanes.h.
#pragma once

#include "prover/tracking/pivoting.h"

namespace plprove::PLC_LANES {

namespace {

/// Rows of equations, one after the other.
struct Rows {
    Number* entries;
    int rows, columns;

    Number* operator[](int row) const { return entries + row * columns; }
};

/// Eliminates the first `count` unknowns: what is left of the first rows is upper triangular, of
/// the others free of these unknowns. `inverse` are the reciprocals of the pivots.
inline void eliminate(const Rows& a, int count, Number* inverse) {
    for (int k = 0; k < count; ++k) {
        choose_pivot(
            k, a.rows, [&](int i) { return a[i][k]; },
            [&](int i, Mask here) {
                for (int c = k; c < a.columns; ++c)
                    exchange(a[k][c], a[i][c], here);
            });
        inverse[k] = inverse_of(a[k][k]);
        for (int i = k + 1; i < a.rows; ++i) {
            const Number factor = a[i][k] * inverse[k];
            for (int c = k + 1; c < a.columns; ++c)
                a[i][c] = subtract(a[i][c], factor, a[k][c]);
        }
    }
}

/// Solves the upper triangular equations for `count` unknowns: the sum of the columns from `count`
/// to `right` times the `known` unknowns, and of column `right`, is zero as well.
inline void substitute(const Rows& a, int count, const Number* inverse, const Number* known,
                       int known_count, int right, Number* out) {
    for (int i = count - 1; i >= 0; --i) {
        Number sum = negative(a[i][right]);
        for (int k = 0; k < known_count; ++k)
            sum = subtract(sum, a[i][count + k], known[k]);
        for (int k = i + 1; k < count; ++k)
            sum = subtract(sum, a[i][k], out[k]);
        out[i] = sum * inverse[i];
    }
}

} // namespace

} // namespace plprove::PLC_LANES
