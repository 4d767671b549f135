// The camera equations at a point and a time, with their derivatives.
//
// No function of the standard library is used here: see prover/tracking/lanes.h.
#pragma once

#include "prover/many_views/tracking/tracked_way.h"
#include "prover/tracking/step_control.h"

namespace plprove::many_views::PLC_LANES {

using namespace plprove::PLC_LANES;
using Real = decltype(Number::re); // with as many digits as the including file wants

namespace {

inline Number zero() {
    return {Real::of(0), Real::of(0)};
}

/// A number and its derivative by time.
struct Pair {
    Number value, speed;
};

inline Pair evaluate(const TrackedPolynomial& polynomial, Real time) {
    Pair result{zero(), zero()};
    for (int i = polynomial.size - 1; i >= 0; --i) {
        const double* c = polynomial.coefficients[i];
        result.speed = {fma(time, result.speed.re, result.value.re),
                        fma(time, result.speed.im, result.value.im)};
        result.value = {fma(time, result.value.re, Real::of(c[0])),
                        fma(time, result.value.im, Real::of(c[1]))};
    }
    return result;
}

/// A point of space in homogeneous coordinates; the last one is the depth.
struct Place {
    Pair x[4];
};

inline void evaluate(const TrackedPlace& place, const Number* point, Real time, Place& result) {
    for (int i = 0; i < 3; ++i)
        result.x[i] = evaluate(place.x[i], time);
    Pair depth{zero(), zero()};
    for (int k = 0; k < place.depths; ++k) {
        const Pair factor = evaluate(place.factors[k], time);
        depth.value = add(depth.value, factor.value, point[place.unknowns[k]]);
        depth.speed = add(depth.speed, factor.speed, point[place.unknowns[k]]);
    }
    result.x[3] = depth;
}

/// The numbers of a camera at a point of its chart, shared ones last.
inline void evaluate(const TrackedWay& way, const TrackedCamera& camera, const Number* point,
                     Number* numbers) {
    for (int i = 0; i < most_camera_numbers; ++i)
        numbers[i] = constant(camera.origin[i]);
    for (int i = 0; i < camera.basis_entries; ++i) {
        const TrackedBasisEntry& entry = camera.basis[i];
        Number& number = numbers[entry.number];
        number =
            add(number, constant(entry.factor), point[camera.first_coordinate + entry.coordinate]);
    }
    for (int i = 0; i < way.shared; ++i)
        numbers[way.numbers + i] = point[way.depths + i];
}

/// An entry of the camera matrix, or a derivative of one.
inline Number evaluate(const TrackedEntry& entry, const Number* numbers) {
    Number sum = zero();
    for (int m = 0; m < entry.size; ++m) {
        const TrackedMonomial& monomial = entry.monomials[m];
        Number product{Real::of(monomial.factor), Real::of(0)};
        for (int i = 0; i < monomial.size; ++i)
            product = product * numbers[monomial.numbers[i]];
        sum = sum + product;
    }
    return sum;
}

/// What an equation is of a camera's numbers: its value, the derivatives by these and by the depth,
/// and, if wanted, the derivative by time.
struct Terms {
    Number value, speed, by_depth;
    Number by_number[most_camera_numbers];
};

/// The matrix A with q A q = l R(q) x, times its norm: symmetric, row by row above the diagonal.
struct RotationForm {
    Number aa, ab, ac, ad, bb, bc, bd, cc, cd, dd;

    /// From the products l_i x_j.
    explicit RotationForm(const Number (&p)[3][3])
        : aa(p[0][0] + p[1][1] + p[2][2]), ab(p[2][1] - p[1][2]), ac(p[0][2] - p[2][0]),
          ad(p[1][0] - p[0][1]), bb(p[0][0] - p[1][1] - p[2][2]), bc(p[0][1] + p[1][0]),
          bd(p[0][2] + p[2][0]), cc(p[1][1] - p[0][0] - p[2][2]), cd(p[1][2] + p[2][1]),
          dd(p[2][2] - p[0][0] - p[1][1]) {}

    /// A q.
    void apply(const Number* q, Number* result) const {
        result[0] = add(add(add(aa * q[0], ab, q[1]), ac, q[2]), ad, q[3]);
        result[1] = add(add(add(ab * q[0], bb, q[1]), bc, q[2]), bd, q[3]);
        result[2] = add(add(add(ac * q[0], bc, q[1]), cc, q[2]), cd, q[3]);
        result[3] = add(add(add(ad * q[0], bd, q[1]), cd, q[2]), dd, q[3]);
    }
};

inline Number dot4(const Number* a, const Number* b) {
    return add(add(add(a[0] * b[0], a[1], b[1]), a[2], b[2]), a[3], b[3]);
}

/// Cameras whose numbers are a quaternion and a translation.
struct QuaternionForm {
    const Number* numbers;

    template <bool Moving>
    void set(const Pair* l, const Place& place, Terms& terms) const {
        const Pair* x = place.x;
        const Number* q = numbers;
        const Number* t = numbers + 4;
        Number products[3][3], half[4];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                products[i][j] = l[i].value * x[j].value;
        RotationForm(products).apply(q, half);
        terms.by_depth = add(add(l[0].value * t[0], l[1].value, t[1]), l[2].value, t[2]);
        terms.value = add(dot4(half, q), terms.by_depth, x[3].value);
        for (int j = 0; j < 4; ++j)
            terms.by_number[j] = twice(half[j]);
        for (int i = 0; i < 3; ++i)
            terms.by_number[4 + i] = l[i].value * x[3].value;
        if constexpr (Moving) {
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    products[i][j] = add(l[i].speed * x[j].value, l[i].value, x[j].speed);
            RotationForm(products).apply(q, half);
            const Number by_depth = add(add(l[0].speed * t[0], l[1].speed, t[1]), l[2].speed, t[2]);
            terms.speed = add(add(dot4(half, q), by_depth, x[3].value), terms.by_depth, x[3].speed);
        }
    }
};

/// Cameras whose numbers are the entries of the matrix, row by row.
struct EntryForm {
    const Number* numbers;

    template <bool Moving>
    void set(const Pair* l, const Place& place, Terms& terms) const {
        terms.value = terms.by_depth = zero();
        if constexpr (Moving) terms.speed = zero();
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 4; ++j) {
                const Pair& x = place.x[j];
                const Number entry = numbers[4 * i + j];
                const Number product = l[i].value * x.value;
                terms.by_number[4 * i + j] = product;
                terms.value = add(terms.value, product, entry);
                if (j == 3) terms.by_depth = add(terms.by_depth, l[i].value, entry);
                if constexpr (Moving)
                    terms.speed =
                        add(terms.speed, add(l[i].speed * x.value, l[i].value, x.speed), entry);
            }
    }
};

/// Cameras of any kind: from the entries of the matrix, and their derivatives by its numbers.
struct PolynomialForm {
    const TrackedWay& way;
    const Number* entries;

    template <bool Moving>
    void set(const Pair* l, const Place& place, Terms& terms) const {
        terms.value = terms.by_depth = zero();
        if constexpr (Moving) terms.speed = zero();
        for (Number& slope : terms.by_number)
            slope = zero();
        for (int e = 0; e < way.entries; ++e) {
            const TrackedEntry& tracked = way.entry[e];
            const Pair& row = l[tracked.entry / 4];
            const Pair& column = place.x[tracked.entry % 4];
            const Number product = row.value * column.value;
            if (tracked.number >= 0) {
                Number& slope = terms.by_number[tracked.number];
                slope = add(slope, product, entries[e]);
                continue;
            }
            terms.value = add(terms.value, product, entries[e]);
            if (tracked.entry % 4 == 3) terms.by_depth = add(terms.by_depth, row.value, entries[e]);
            if constexpr (Moving)
                terms.speed =
                    add(terms.speed, add(row.speed * column.value, row.value, column.speed),
                        entries[e]);
        }
    }
};

/// Sets a row: derivatives by the camera's coordinates, by the depths, by the shared numbers, the
/// value, and, if wanted, the derivative by time.
template <bool Moving, class Form>
void set_row(const TrackedWay& way, const TrackedCamera& camera, const Form& form,
             const TrackedEquation& equation, const TrackedPlace& tracked, const Place& place,
             Real time, Number* row) {
    const Pair l[3] = {evaluate(equation.l[0], time), evaluate(equation.l[1], time),
                       evaluate(equation.l[2], time)};
    Terms terms;
    form.template set<Moving>(l, place, terms);
    const int value = camera.coordinates + way.common();
    for (int k = 0; k < value; ++k)
        row[k] = zero();
    for (int i = 0; i < camera.basis_entries; ++i) {
        const TrackedBasisEntry& entry = camera.basis[i];
        row[entry.coordinate] =
            add(row[entry.coordinate], constant(entry.factor), terms.by_number[entry.number]);
    }
    for (int k = 0; k < tracked.depths; ++k)
        row[camera.coordinates + tracked.unknowns[k]] =
            evaluate(tracked.factors[k], time).value * terms.by_depth;
    for (int i = 0; i < way.shared; ++i)
        row[camera.coordinates + way.depths + i] = terms.by_number[way.numbers + i];
    row[value] = terms.value;
    if constexpr (Moving)
        row[value + 1] = terms.speed;
    else
        row[value + 1] = zero();
}

} // namespace

} // namespace plprove::many_views::PLC_LANES
