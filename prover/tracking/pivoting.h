// Pivots of an elimination, chosen in all lanes at once.
//
// No function of the standard library is used here: see lanes.h.
#pragma once

#include "prover/tracking/numbers.h"

namespace plprove::PLC_LANES {

namespace {

/// Brings row k to a pivot that is not small: a row is exchanged only where the
/// entry is less than 1/64 of the largest one below it. What is lost in accuracy Newton's method
/// makes up for, and most steps then need no exchange in any lane. `entry` of a row is that in the
/// column of the pivot; `exchange` exchanges row k with another in some lanes.
template <class Entry, class Exchange>
inline void choose_pivot(int k, int rows, const Entry& entry, const Exchange& exchange) {
    Real largest = Real::of(0);
    for (int i = k; i < rows; ++i)
        largest = larger(largest, square(entry(i)));
    Mask wanting = less(square(entry(k)), Real::of(1.0 / 4096) * largest);
    for (int i = k + 1; i < rows && any(wanting); ++i) {
        const Mask here = without(wanting, less(square(entry(i)), largest));
        if (!any(here)) continue;
        exchange(i, here);
        wanting = without(wanting, here);
    }
}

/// 1 / x.
[[gnu::always_inline]] inline Number inverse_of(const Number& x) {
    const Real scale = Real::of(1) / square(x);
    return {x.re * scale, (Real::of(0) - x.im) * scale};
}

/// Exchanges two numbers in some lanes.
[[gnu::always_inline]] inline void exchange(Number& a, Number& b, Mask m) {
    const Number upper = a, lower = b;
    a = select(m, lower, upper);
    b = select(m, upper, lower);
}

} // namespace

} // namespace plprove::PLC_LANES
