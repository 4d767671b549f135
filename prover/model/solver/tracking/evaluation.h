// The equations of a model at a point and a time, with their derivatives.
//
// No function of the standard library is used here: see prover/tracking/lanes.h.
#pragma once

#include "prover/model/solver/tracking/tracked_program.h"
#include "prover/tracking/elimination.h"

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

inline Number result_of(const TrackedOperation& operation, const Number* places) {
    const Number& a = places[operation.a];
    const Number& b = places[operation.b];
    switch (operation.kind) {
    case TrackedKind::sum:
        return a + b;
    case TrackedKind::difference:
        return a - b;
    case TrackedKind::product:
        return a * b;
    case TrackedKind::add:
        return add(places[operation.c], a, b);
    case TrackedKind::subtract:
        return subtract(places[operation.c], a, b);
    case TrackedKind::product_less:
        return a * b - places[operation.c];
    case TrackedKind::negative:
        return negative(a);
    case TrackedKind::reciprocal:
        break;
    }
    return inverse_of(a);
}

/// Sets the matrix: the Jacobian, the values and, if Moving, the derivatives by time. The unknowns
/// and constants are in their places.
template <bool Moving>
void evaluate(const TrackedProgram& program, const TrackedCurve* curves, Real time,
              Number* places) {
    set_data<Moving>(program, curves, time, places);
    const int operations = Moving ? program.operations : program.operations_at_rest;
    for (int i = 0; i < operations; ++i) {
        const TrackedOperation& operation = program.operation[i];
        places[operation.to] = result_of(operation, places);
    }
    for (int i = 0; i < program.zeros; ++i)
        places[program.zero[i]] = {Real::of(0), Real::of(0)};
    const int copies = Moving ? program.copies : program.copies_at_rest;
    for (int i = 0; i < copies; ++i)
        places[program.copy[i].to] = places[program.copy[i].from];
}

} // namespace

} // namespace plprove::model::PLC_LANES
