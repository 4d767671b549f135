// Newton steps. The equations of a view have the coordinates of its own camera and the depths. So
// the coordinates are eliminated view by view, and what is left are equations of the depths.
//
// No function of the standard library is used here: see prover/tracking/lanes.h.
#pragma once

#include "prover/many_views/tracking/evaluation.h"

namespace plprove::many_views::PLC_LANES {

namespace {

/// Rows of equations, one after the other.
struct Rows {
    Number* entries;
    int rows, columns;

    Number* operator[](int row) const { return entries + row * columns; }
};

inline void exchange(Number* upper, Number* lower, int from, int to, Mask m) {
    for (int c = from; c < to; ++c) {
        const Number a = upper[c], b = lower[c];
        upper[c] = select(m, b, a);
        lower[c] = select(m, a, b);
    }
}

/// Brings row k to a pivot in column k that is not small: a row is exchanged only where the entry
/// is less than 1/64 of the largest one below it. What is lost in accuracy Newton's method makes
/// up for.
inline void choose_pivot(const Rows& a, int k) {
    Real largest = Real::of(0);
    for (int i = k; i < a.rows; ++i)
        largest = larger(largest, square(a[i][k]));
    Mask wanting = less(square(a[k][k]), Real::of(1.0 / 4096) * largest);
    for (int i = k + 1; i < a.rows && any(wanting); ++i) {
        const Mask here = without(wanting, less(square(a[i][k]), largest));
        if (!any(here)) continue;
        exchange(a[k], a[i], k, a.columns, here);
        wanting = without(wanting, here);
    }
}

/// Eliminates the first `count` unknowns: what is left of the first rows is upper triangular, of
/// the others free of these unknowns. `inverse` are the reciprocals of the pivots.
inline void eliminate(const Rows& a, int count, Number* inverse) {
    for (int k = 0; k < count; ++k) {
        choose_pivot(a, k);
        const Number pivot = a[k][k];
        const Real scale = Real::of(1) / square(pivot);
        inverse[k] = {pivot.re * scale, (Real::of(0) - pivot.im) * scale};
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

} // namespace plprove::many_views::PLC_LANES
