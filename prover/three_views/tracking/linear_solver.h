// Newton steps: the linear systems of the Jacobian, solved by elimination in all lanes at once.
//
// No function of the standard library is used here: see lanes.h.
#pragma once

#include "prover/three_views/tracking/evaluation.h"
#include "prover/tracking/pivoting.h"

namespace plprove::PLC_LANES {

namespace {

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
        choose_pivot(
            Column, n, [&](int i) { return a.entry[i][Column]; },
            [&](int i, Mask here) {
                for (int c = 0; c < Columns; ++c)
                    exchange(a.entry[Column][c], a.entry[i][c], here);
            });
        inverse[Column] = inverse_of(a.entry[Column][Column]);
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
