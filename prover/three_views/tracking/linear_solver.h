// Newton steps: the linear systems of the Jacobian, solved by elimination in all lanes at once.
//
// No function of the standard library is used here: see lanes.h.
#pragma once

#include "prover/three_views/tracking/evaluation.h"

namespace plprove::PLC_LANES {

namespace {

/// Exchanges rows k and i in the lanes of m.
template <int Columns>
void exchange(Equations& a, int k, int i, Mask m) {
    for (int c = 0; c < Columns; ++c) {
        const Number upper = a.entry[k][c], lower = a.entry[i][c];
        a.entry[k][c] = select(m, lower, upper);
        a.entry[i][c] = select(m, upper, lower);
    }
}

/// Brings row k to a pivot in column k that is not small: a row is exchanged only where the entry
/// is less than 1/64 of the largest one below it. What is lost in accuracy Newton's method makes
/// up for, and most steps then need no exchange in any lane.
template <int Columns>
void choose_pivot(Equations& a, int k) {
    Real size[n], largest = Real::of(0);
    for (int i = k; i < n; ++i) {
        size[i] = square(a.entry[i][k]);
        largest = larger(largest, size[i]);
    }
    Mask wanting = less(size[k], Real::of(1.0 / 4096) * largest);
    for (int i = k + 1; i < n && any(wanting); ++i) {
        const Mask here = without(wanting, less(size[i], largest));
        if (!any(here)) continue;
        exchange<Columns>(a, k, i, here);
        wanting = without(wanting, here);
    }
}

/// Column `Column` of the LU decomposition (L below the diagonal, with ones on it) or, right of the
/// matrix, of L^-1 times the column; `inverse` are the reciprocals of the pivots.
template <int Column, int Columns>
void eliminate(Equations& a, Number* inverse) {
    Number column[n]; // in registers
    PLC_UNROLLED
    for (int i = 0; i < n; ++i)
        column[i] = a.entry[i][Column];
    PLC_UNROLLED
    for (int k = 0; k < (Column < n ? Column : n - 1); ++k)
        PLC_UNROLLED
    for (int i = k + 1; i < n; ++i)
        column[i] = subtract(column[i], a.entry[i][k], column[k]);
    PLC_UNROLLED
    for (int i = 0; i < n; ++i)
        a.entry[i][Column] = column[i];
    if constexpr (Column < n) {
        choose_pivot<Columns>(a, Column);
        const Number pivot = a.entry[Column][Column];
        const Real scale = Real::of(1) / square(pivot);
        inverse[Column] = {pivot.re * scale, (Real::of(0) - pivot.im) * scale};
        for (int i = Column + 1; i < n; ++i)
            a.entry[i][Column] = a.entry[i][Column] * inverse[Column];
    }
    if constexpr (Column + 1 < Columns) eliminate<Column + 1, Columns>(a, inverse);
}

/// Solves U x = -y for the transformed column y.
template <int Column>
void substitute(const Equations& a, const Number* inverse, Number* out) {
    Number column[n]; // in registers
    PLC_UNROLLED
    for (int i = 0; i < n; ++i)
        column[i] = negative(a.entry[i][Column]);
    PLC_UNROLLED
    for (int k = n - 1; k >= 0; --k) {
        column[k] = column[k] * inverse[k];
        PLC_UNROLLED
        for (int i = 0; i < k; ++i)
            column[i] = subtract(column[i], a.entry[i][k], column[k]);
    }
    PLC_UNROLLED
    for (int i = 0; i < n; ++i)
        out[i] = column[i];
}

/// Solves J x = -F.
void solve(Equations& a, Number* correction) {
    Number inverse[n];
    eliminate<0, n + 1>(a, inverse);
    substitute<n>(a, inverse, correction);
}

/// Solves J x = -F and J v = -F_t.
void solve(Equations& a, Number* correction, Number* speed) {
    Number inverse[n];
    eliminate<0, n + 2>(a, inverse);
    substitute<n>(a, inverse, correction);
    substitute<n + 1>(a, inverse, speed);
}

} // namespace

} // namespace plprove::PLC_LANES
