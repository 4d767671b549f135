// The equations of a model at a point and a time, with their derivatives.
//
// No function of the standard library is used here: see prover/tracking/lanes.h.
#pragma once

#include "prover/model/solver/tracking/tracked_program.h"
#include "prover/tracking/pivoting.h"

namespace plprove::model::PLC_LANES {

using namespace plprove::PLC_LANES;

namespace {

/// Sets the constants, which stay in their places.
inline void set_constants(const TrackedProgram& program, Number* places) {
    for (int i = 0; i < program.constants; ++i) {
        const TrackedConstant& constant = program.constant[i];
        places[constant.place] = {Real::of(constant.value), Real::of(0)};
    }
}

/// Sets the data on their curves and, if Moving, their speeds.
template <bool Moving>
void set_data(const TrackedProgram& program, const TrackedCurve* curves, Real time,
              Number* places) {
    for (int i = 0; i < program.data; ++i) {
        const TrackedDatum& datum = program.datum[i];
        const double(*c)[2] = curves[datum.number].coefficients;
        const Number c0 = constant(c[0]), c1 = constant(c[1]), c2 = constant(c[2]);
        const Number slope{fma(time, c2.re, c1.re), fma(time, c2.im, c1.im)};
        places[datum.place] = {fma(time, slope.re, c0.re), fma(time, slope.im, c0.im)};
        if constexpr (Moving)
            if (datum.speed >= 0)
                places[datum.speed] = {fma(time, c2.re, slope.re), fma(time, c2.im, slope.im)};
    }
}

/// Computes operations from `first` on as long as they are of one kind. Returns the next one.
template <class Compute>
inline const TrackedOperation* compute_run(const TrackedOperation* first,
                                           const TrackedOperation* end, Number* places,
                                           Compute compute) {
    const TrackedOperation* next = first;
    do {
        places[next->to] = compute(places[next->a], places[next->b], places[next->c]);
        ++next;
    } while (next != end && next->kind == first->kind);
    return next;
}

inline const TrackedOperation* compute_run(const TrackedOperation* first,
                                           const TrackedOperation* end, Number* places) {
    using N = const Number&;
    const auto run = [&](auto compute) { return compute_run(first, end, places, compute); };
    switch (first->kind) {
    case TrackedKind::sum:
        return run([](N a, N b, N) { return a + b; });
    case TrackedKind::difference:
        return run([](N a, N b, N) { return a - b; });
    case TrackedKind::product:
        return run([](N a, N b, N) { return a * b; });
    case TrackedKind::add:
        return run([](N a, N b, N c) { return add(c, a, b); });
    case TrackedKind::subtract:
        return run([](N a, N b, N c) { return subtract(c, a, b); });
    case TrackedKind::product_less:
        return run([](N a, N b, N c) { return a * b - c; });
    case TrackedKind::negative:
        return run([](N a, N, N) { return negative(a); });
    case TrackedKind::reciprocal:
        break;
    }
    return run([](N a, N, N) { return inverse_of(a); });
}

/// Sets the matrix: the Jacobian, the values and, if Moving, the derivatives by time. The unknowns
/// and constants are in their places.
template <bool Moving>
void evaluate(const TrackedProgram& program, const TrackedCurve* curves, Real time,
              Number* places) {
    set_data<Moving>(program, curves, time, places);
    const TrackedOperation* const end =
        program.operation + (Moving ? program.operations : program.operations_at_rest);
    for (const TrackedOperation* next = program.operation; next != end;)
        next = compute_run(next, end, places);
    for (int i = 0; i < program.zeros; ++i)
        places[program.zero[i]] = {Real::of(0), Real::of(0)};
    const int copies = Moving ? program.copies : program.copies_at_rest;
    for (int i = 0; i < copies; ++i)
        places[program.copy[i].to] = places[program.copy[i].from];
}

} // namespace

} // namespace plprove::model::PLC_LANES
