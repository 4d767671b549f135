// The path tracker, with the lanes of the instruction set that the including file is compiled for;
// with twice or three times as many digits if that file defines PLC_DOUBLE_DOUBLE or
// PLC_TRIPLE_DOUBLE.
//
// No function of the standard library is used here: see lanes.h.
#pragma once

#include "prover/degree/tracking/lanes.h"
#include "prover/degree/tracking/tracker.h"

namespace plprove::PLC_LANES {

namespace {

#if defined(PLC_DOUBLE_DOUBLE) || defined(PLC_TRIPLE_DOUBLE)
#if defined(PLC_DOUBLE_DOUBLE)
using Real = DoubleDouble;
#else
using Real = TripleDouble;
#endif
#undef PLC_UNROLLED
#define PLC_UNROLLED // a column does not fit into the registers
#endif

template <class R>
struct Complexes {
    R re, im;
};
template <class R>
[[gnu::always_inline]] inline Complexes<R> operator+(Complexes<R> a, Complexes<R> b) {
    return {a.re + b.re, a.im + b.im};
}
template <class R>
[[gnu::always_inline]] inline Complexes<R> operator-(Complexes<R> a, Complexes<R> b) {
    return {a.re - b.re, a.im - b.im};
}
template <class R>
[[gnu::always_inline]] inline Complexes<R> operator*(Complexes<R> a, Complexes<R> b) {
    return {fnma(a.im, b.im, a.re * b.re), fma(a.re, b.im, a.im * b.re)};
}
/// sum + a b and sum - a b.
template <class R>
[[gnu::always_inline]] inline Complexes<R> add(Complexes<R> sum, Complexes<R> a, Complexes<R> b) {
    return {fnma(a.im, b.im, fma(a.re, b.re, sum.re)), fma(a.re, b.im, fma(a.im, b.re, sum.im))};
}
template <class R>
[[gnu::always_inline]] inline Complexes<R> subtract(Complexes<R> sum, Complexes<R> a,
                                                    Complexes<R> b) {
    return {fma(a.im, b.im, fnma(a.re, b.re, sum.re)), fnma(a.re, b.im, fnma(a.im, b.re, sum.im))};
}
template <class R>
[[gnu::always_inline]] inline Complexes<R> negative(Complexes<R> a) {
    return {R::of(0) - a.re, R::of(0) - a.im};
}
template <class R>
[[gnu::always_inline]] inline Complexes<R> twice(Complexes<R> a) {
    return {a.re + a.re, a.im + a.im};
}
template <class R>
[[gnu::always_inline]] inline Complexes<R> constant(const double* x) {
    return {R::of(x[0]), R::of(x[1])};
}

template <class R>
struct Vectors {
    Complexes<R> x[3];
};
template <class R>
[[gnu::always_inline]] inline Complexes<R> dot(const Vectors<R>& a, const Vectors<R>& b) {
    return add(add(a.x[0] * b.x[0], a.x[1], b.x[1]), a.x[2], b.x[2]);
}
template <class R>
[[gnu::always_inline]] inline Vectors<R> cross(const Vectors<R>& a, const Vectors<R>& b) {
    return {{subtract(a.x[1] * b.x[2], a.x[2], b.x[1]), subtract(a.x[2] * b.x[0], a.x[0], b.x[2]),
             subtract(a.x[0] * b.x[1], a.x[1], b.x[0])}};
}
template <class R>
[[gnu::always_inline]] inline Vectors<R> operator-(const Vectors<R>& a, const Vectors<R>& b) {
    return {{a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]}};
}

using Number = Complexes<Real>;
using Vector = Vectors<Real>;

inline Real square(Number a) {
    return fma(a.re, a.re, a.im * a.im);
}
inline Number select(Mask m, Number a, Number b) {
    return {select(m, a.re, b.re), select(m, a.im, b.im)};
}
inline Real larger(Real a, Real b) {
    return select(less(a, b), b, a);
}
inline Real smaller(Real a, Real b) {
    return select(less(a, b), a, b);
}

constexpr int n = camera_dimension;

/// The Jacobian, the values (column n) and their derivatives with respect to time (column n + 1).
struct Equations {
    Number entry[n][n + 2];
};

/// The cameras at a point of the chart.
template <class R>
struct MovingCameras {
    Complexes<R> quaternion[3][4];
    Complexes<R> rotation[3][3][3];
    Vectors<R> centre[3];

    MovingCameras(const TrackedSystem& system, const Complexes<R>* point) {
        const Complexes<R> zero{R::of(0), R::of(0)}, one{R::of(1), R::of(0)};
        for (int v = 1; v < 3; ++v) {
            Complexes<R>* q = quaternion[v];
            q[0] = one;
            for (int k = 0; k < 3; ++k) {
                q[k + 1] = point[3 * (v - 1) + k];
                q[0] = subtract(q[0], constant<R>(system.rotation[v - 1][k]), q[k + 1]);
            }
            rotate(q, rotation[v]);
        }
        centre[0] = {{zero, zero, zero}};
        centre[1].x[0] = one;
        for (int k = 0; k < 5; ++k) {
            centre[1].x[0] = subtract(centre[1].x[0], constant<R>(system.centre[k]), point[6 + k]);
            centre[1 + (k + 1) / 3].x[(k + 1) % 3] = point[6 + k];
        }
    }

    /// R^T x in the given view.
    Vectors<R> back(int view, const Vectors<R>& x) const {
        if (view == 0) return x;
        const Complexes<R>(*r)[3] = rotation[view];
        Vectors<R> result;
        for (int k = 0; k < 3; ++k)
            result.x[k] = add(add(r[0][k] * x.x[0], r[1][k], x.x[1]), r[2][k], x.x[2]);
        return result;
    }

private:
    static void rotate(const Complexes<R>* q, Complexes<R> (*r)[3]) {
        const Complexes<R> aa = q[0] * q[0], bb = q[1] * q[1], cc = q[2] * q[2], dd = q[3] * q[3];
        const Complexes<R> ab = q[0] * q[1], ac = q[0] * q[2], ad = q[0] * q[3];
        const Complexes<R> bc = q[1] * q[2], bd = q[1] * q[3], cd = q[2] * q[3];
        r[0][0] = (aa + bb) - (cc + dd);
        r[1][1] = (aa + cc) - (bb + dd);
        r[2][2] = (aa + dd) - (bb + cc);
        r[0][1] = twice(bc - ad), r[1][0] = twice(bc + ad);
        r[0][2] = twice(bd + ac), r[2][0] = twice(bd - ac);
        r[1][2] = twice(cd - ab), r[2][1] = twice(cd + ab);
    }
};

/// An image vector at a time.
template <class R>
Vectors<R> image_vector(const TrackedImages& images, int index, R time) {
    Vectors<R> x;
    for (int k = 0; k < 3; ++k) {
        const double(*c)[2] = images.coefficient[index][k];
        const auto c0 = constant<R>(c[0]), c1 = constant<R>(c[1]), c2 = constant<R>(c[2]);
        x.x[k] = {fma(time, fma(time, c2.re, c1.re), c0.re),
                  fma(time, fma(time, c2.im, c1.im), c0.im)};
    }
    return x;
}

/// Evaluates the equations and their Jacobian and, if Moving, the derivatives with respect to time.
class Evaluator {
public:
    Evaluator(const TrackedSystem& system, const TrackedImages& images, const Number* point)
        : system_(system), images_(images), cameras_(system, point) {}

    template <bool Moving>
    void evaluate(Real time, Equations& out) {
        for (int v = 0; v < system_.vectors; ++v)
            set_vector<Moving>(v, time);
        for (int e = 0; e < n; ++e) {
            const TrackedSystem::Equation& equation = system_.equations[e];
            switch (equation.kind) {
            case EquationKind::epipolar:
                epipolar<Moving>(equation, out.entry[e]);
                break;
            case EquationKind::incidence:
                incidence<Moving>(equation, out.entry[e]);
                break;
            case EquationKind::pencil:
                pencil<Moving>(equation, out.entry[e]);
                break;
            }
        }
    }

private:
    /// The ray direction or normal R^T x of an image vector x, its derivative by time, and -2 x q.
    template <bool Moving>
    void set_vector(int index, Real time) {
        const int view = system_.views[index];
        const Vector x = image_vector(images_, index, time);
        direction_[index] = cameras_.back(view, x);
        if constexpr (Moving) {
            Vector speed;
            for (int k = 0; k < 3; ++k) {
                const double(*c)[2] = images_.coefficient[index][k];
                const Number c1 = constant<Real>(c[1]), c2 = constant<Real>(c[2]);
                speed.x[k] = {fma(time, c2.re + c2.re, c1.re), fma(time, c2.im + c2.im, c1.im)};
            }
            speed_[index] = cameras_.back(view, speed);
        }
        if (view == 0) return;
        const Number* q = cameras_.quaternion[view];
        const Vector m{{negative(twice(x.x[0])), negative(twice(x.x[1])), negative(twice(x.x[2]))}};
        const Vector imaginary{{q[1], q[2], q[3]}};
        const Vector product = cross(m, imaginary);
        Number* y = product_[index];
        y[0] = negative(dot(m, imaginary));
        for (int k = 0; k < 3; ++k)
            y[k + 1] = add(product.x[k], q[0], m.x[k]);
    }

    /// Columns of one camera's rotation. With g the gradient by d = R^T x, and quaternions
    /// d = q* x q, the gradient by q is -2 x q g.
    void rotate(int index, int view, const Vector& g, Number* row) const {
        if (view == 0) return;
        const Number* y = product_[index];
        const Number real = negative(add(add(y[1] * g.x[0], y[2], g.x[1]), y[3], g.x[2]));
        const Vector imaginary = cross({{y[1], y[2], y[3]}}, g);
        for (int k = 0; k < 3; ++k)
            row[3 * (view - 1) + k] = subtract(add(imaginary.x[k], y[0], g.x[k]),
                                               constant<Real>(system_.rotation[view - 1][k]), real);
    }

    /// Columns of the centres, from the gradients by the second and third centre.
    void translate(const Vector& g2, const Vector& g3, Number* row) const {
        const Number g[5] = {g2.x[1], g2.x[2], g3.x[0], g3.x[1], g3.x[2]};
        for (int k = 0; k < 5; ++k)
            row[6 + k] = subtract(g[k], constant<Real>(system_.centre[k]), g2.x[0]);
    }

    void clear(Number* row) const {
        const Number zero{Real::of(0), Real::of(0)};
        for (int k = 0; k < n + 2; ++k)
            row[k] = zero;
    }

    template <bool Moving>
    void epipolar(const TrackedSystem::Equation& e, Number* row) const {
        const int i = e.views[0], j = e.views[1];
        const Vector &a = direction_[e.vectors[0]], &b = direction_[e.vectors[1]];
        const Vector base = cameras_.centre[j] - cameras_.centre[i];
        const Vector normal = cross(a, b), by_a = cross(b, base), by_b = cross(base, a);
        clear(row);
        rotate(e.vectors[0], i, by_a, row);
        rotate(e.vectors[1], j, by_b, row);
        const Number zero{Real::of(0), Real::of(0)};
        const Vector none{{zero, zero, zero}};
        if (i > 0)
            translate(none - normal, normal, row);
        else if (j == 1)
            translate(normal, none, row);
        else
            translate(none, normal, row);
        row[n] = dot(base, normal);
        if constexpr (Moving)
            row[n + 1] = dot(by_a, speed_[e.vectors[0]]) + dot(by_b, speed_[e.vectors[1]]);
    }

    template <bool Moving>
    void incidence(const TrackedSystem::Equation& e, Number* row) const {
        const int i = e.views[0], j = e.views[1], k = e.views[2];
        const Vector& d = direction_[e.vectors[0]];
        const Vector &p = direction_[e.vectors[1]], &q = direction_[e.vectors[2]];
        const Vector from_j = cameras_.centre[i] - cameras_.centre[j],
                     from_k = cameras_.centre[i] - cameras_.centre[k];
        const Number up = dot(p, from_j), wp = dot(p, d), uq = dot(q, from_k), wq = dot(q, d);
        Vector by_d, by_p, by_q, by_centre[3];
        for (int c = 0; c < 3; ++c) {
            by_d.x[c] = subtract(up * q.x[c], uq, p.x[c]);
            by_p.x[c] = subtract(wq * from_j.x[c], uq, d.x[c]);
            by_q.x[c] = subtract(up * d.x[c], wp, from_k.x[c]);
            const Number scaled_p = wq * p.x[c], scaled_q = wp * q.x[c];
            by_centre[i].x[c] = scaled_p - scaled_q;
            by_centre[j].x[c] = negative(scaled_p);
            by_centre[k].x[c] = scaled_q;
        }
        clear(row);
        rotate(e.vectors[0], i, by_d, row);
        rotate(e.vectors[1], j, by_p, row);
        rotate(e.vectors[2], k, by_q, row);
        translate(by_centre[1], by_centre[2], row);
        row[n] = subtract(up * wq, uq, wp);
        if constexpr (Moving)
            row[n + 1] = dot(by_d, speed_[e.vectors[0]]) + dot(by_p, speed_[e.vectors[1]]) +
                         dot(by_q, speed_[e.vectors[2]]);
    }

    template <bool Moving>
    void pencil(const TrackedSystem::Equation& e, Number* row) const {
        const Vector &a = direction_[e.vectors[0]], &b = direction_[e.vectors[1]],
                     &c = direction_[e.vectors[2]];
        const Vector by_a = cross(b, c), by_b = cross(c, a), by_c = cross(a, b);
        clear(row);
        rotate(e.vectors[0], e.views[0], by_a, row);
        rotate(e.vectors[1], e.views[1], by_b, row);
        rotate(e.vectors[2], e.views[2], by_c, row);
        row[n] = dot(a, by_a);
        if constexpr (Moving)
            row[n + 1] = dot(by_a, speed_[e.vectors[0]]) + dot(by_b, speed_[e.vectors[1]]) +
                         dot(by_c, speed_[e.vectors[2]]);
    }

    const TrackedSystem& system_;
    const TrackedImages& images_;
    MovingCameras<Real> cameras_;
    Vector direction_[max_vectors];
    Vector speed_[max_vectors];
    Number product_[max_vectors][4];
};

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

/// The relative size, squared, of a correction: the largest of those of the two quaternions and the
/// centres, where the coordinate that the chart fixes counts as 1.
inline Real relative_size(const Number* correction, const Number* point) {
    const Real one = Real::of(1);
    const int begin[4] = {0, 3, 6, n};
    Real result = Real::of(0);
    for (int block = 0; block < 3; ++block) {
        Real change = Real::of(0), norm = one;
        for (int k = begin[block]; k < begin[block + 1]; ++k) {
            change = change + square(correction[k]);
            norm = norm + square(point[k]);
        }
        result = larger(result, change / norm);
    }
    return result;
}

/// The last three points of each path with their speeds, the newest first.
struct History {
    Number point[3][n];
    Number speed[3][n];
    Real time[3];
    Real points; ///< how many of them there are
};

/// Hermite extrapolation (Newton's form, each node twice) to the time `after` the newest point.
inline void predict(const History& h, Real after, Number* out) {
    const Real a = h.time[0] - h.time[1], b = h.time[0] - h.time[2], c = h.time[1] - h.time[2];
    const Real one = Real::of(1), zero = Real::of(0);
    const Real by_a = one / a, by_b = one / b, by_c = one / c;
    const Mask two = less(Real::of(1.5), h.points), three = less(Real::of(2.5), h.points);
    const Real s = after, ss = s * s, sa = s + a;
    const Real w3 = ss * sa, w4 = w3 * sa, w5 = w4 * (s + b);
    for (int k = 0; k < n; ++k) {
        const auto part = [&](auto member) {
            const Real x0 = member(h.point[0][k]), x1 = member(h.point[1][k]),
                       x2 = member(h.point[2][k]);
            const Real v0 = member(h.speed[0][k]), v1 = member(h.speed[1][k]),
                       v2 = member(h.speed[2][k]);
            const Real d01 = (x0 - x1) * by_a, d12 = (x1 - x2) * by_c;
            const Real d001 = (v0 - d01) * by_a, d011 = (d01 - v1) * by_a;
            const Real d112 = (v1 - d12) * by_c, d122 = (d12 - v2) * by_c;
            const Real d0011 = (d001 - d011) * by_a, d0112 = (d011 - d112) * by_b,
                       d1122 = (d112 - d122) * by_c;
            const Real d00112 = (d0011 - d0112) * by_b, d01122 = (d0112 - d1122) * by_b;
            const Real d001122 = (d00112 - d01122) * by_b;
            Real sum = fma(s, v0, x0);
            sum = fma(ss, select(two, d001, zero), sum);
            sum = fma(w3, select(two, d0011, zero), sum);
            sum = fma(w4, select(three, d00112, zero), sum);
            return fma(w5, select(three, d001122, zero), sum);
        };
        out[k] = {part([](Number x) { return x.re; }), part([](Number x) { return x.im; })};
    }
}

/// Follows paths, one in each lane, and starts the next path of the list in a lane that is done.
class Tracker {
public:
    Tracker(const TrackedSystem& system, const TrackedImages& images, const TrackSettings& settings,
            std::size_t count, const CameraPoint* starts, CameraPoint* ends, TrackOutcome* outcomes)
        : system_(system), images_(images), settings_(settings), count_(count), starts_(starts),
          ends_(ends), outcomes_(outcomes) {}

    TrackCost run() {
        if (count_ == 0) return cost_;
        history_.points = Real::of(1);
        step_ = Real::of(0);
        for (int m = 0; m < 3; ++m) {
            history_.time[m] = Real::of(-m);
            for (int k = 0; k < n; ++k)
                history_.point[m][k] = history_.speed[m][k] = {Real::of(0), Real::of(0)};
        }
        for (int lane = 0; lane < Real::width; ++lane)
            begin(lane);
        while (active_ > 0)
            advance();
        return cost_;
    }

private:
    static constexpr std::size_t idle = ~std::size_t{0};

    /// Puts the next path into the lane, or leaves it idle.
    void begin(int lane) {
        path_[lane] = next_ < count_ ? next_++ : idle;
        attempts_[lane] = 0;
        arrived_[lane] = false;
        const std::size_t path = path_[lane] == idle ? 0 : path_[lane];
        if (path_[lane] != idle) ++active_;
        for (int k = 0; k < n; ++k) {
            const double* z = reinterpret_cast<const double*>(&starts_[path]) + 2 * k;
            put(history_.point[0][k].re, lane, z[0]);
            put(history_.point[0][k].im, lane, z[1]);
            put(history_.speed[0][k].re, lane, 0);
            put(history_.speed[0][k].im, lane, 0);
        }
        // The first step goes nowhere: it corrects the start and finds the speed there.
        put(history_.time[0], lane, 0);
        put(history_.time[1], lane, -1);
        put(history_.time[2], lane, -2);
        put(history_.points, lane, 0);
        put(step_, lane, 0);
    }

    void finish(int lane, TrackOutcome outcome) {
        const std::size_t path = path_[lane];
        for (int k = 0; k < n; ++k) {
            double* z = reinterpret_cast<double*>(&ends_[path]) + 2 * k;
            z[0] = at(history_.point[0][k].re, lane);
            z[1] = at(history_.point[0][k].im, lane);
        }
        outcomes_[path] = outcome;
        --active_;
        begin(lane);
    }

    template <bool Moving>
    void evaluate(const Number* point, Real time) {
        Evaluator(system_, images_, point).evaluate<Moving>(time, equations_);
    }

    /// One step of all lanes: predict, correct twice by Newton's method, accept or not.
    void advance() {
        const Real one = Real::of(1);
        const Real time = smaller(history_.time[0] + step_, one);
        Number point[n], first[n], second[n], speed[n];
        predict(history_, time - history_.time[0], point);
        evaluate<false>(point, time);
        solve(equations_, first);
        const Real predicted = relative_size(first, point);
        for (int k = 0; k < n; ++k)
            point[k] = point[k] + first[k];
        evaluate<true>(point, time);
        solve(equations_, second, speed);
        const Real corrected = relative_size(second, point);
        for (int k = 0; k < n; ++k)
            point[k] = point[k] + second[k];

        // Everything is squared. Comparisons with NaN are false, so a step to nowhere is refused.
        const Real goal = Real::of(settings_.prediction * settings_.prediction);
        const Real noise = Real::of(settings_.noise * settings_.noise);
        const Real contraction = Real::of(settings_.contraction * settings_.contraction);
        const Mask quiet = less(corrected, noise);
        const Mask newton = less(corrected, contraction * predicted);
        const Mask near = less(predicted, Real::of(64) * goal);
        const Mask good = both(near, either(quiet, newton));

        // How far the step may stretch: both the prediction and the contraction of Newton's
        // method, unless that is noise, are to stay within their limits.
        const Real tiny = Real::of(1e-40);
        Real ratio = goal / (predicted + tiny);
        const Real by_newton = contraction * predicted / (corrected + tiny);
        ratio = select(quiet, ratio, smaller(ratio, by_newton));
        const Real root8 = sqrt(sqrt(sqrt(ratio + tiny))); // of the square: the fourth root
        const Real root16 = sqrt(root8);
        const Real high = Real::of(0.9) * root16 * sqrt(root16);
        const Mask full = less(Real::of(2.5), history_.points);
        const Real stretch = smaller(
            larger(select(full, high, Real::of(0.9) * root8), Real::of(0.3)), Real::of(2.5));
        const Real shrink = smaller(larger(Real::of(0.7) * root8, Real::of(0.1)), Real::of(0.5));
        // The second comparison is false for NaN, whose step shrinks at most.
        const Real bounded = select(less(ratio, Real::of(1e80)), shrink, Real::of(0.1));

        const Mask starting = less(history_.points, Real::of(0.5));
        for (int k = 0; k < n; ++k)
            for (int m = 2; m >= 0; --m) {
                const Number& old_point = m > 0 ? history_.point[m - 1][k] : point[k];
                const Number& old_speed = m > 0 ? history_.speed[m - 1][k] : speed[k];
                history_.point[m][k] = select(good, old_point, history_.point[m][k]);
                history_.speed[m][k] = select(good, old_speed, history_.speed[m][k]);
            }
        // At the start the older points stay what they were: none.
        for (int m = 2; m > 0; --m)
            history_.time[m] =
                select(without(good, starting), history_.time[m - 1], history_.time[m]);
        history_.time[0] = select(good, time, history_.time[0]);
        history_.points =
            select(good, smaller(history_.points + one, Real::of(3)), history_.points);
        step_ = select(good, smaller(step_ * stretch, Real::of(settings_.largest_step)),
                       step_ * bounded);
        step_ = select(both(good, starting), Real::of(settings_.first_step), step_);
        settle(good);
    }

    /// Ends the paths that have arrived, and been corrected once more there, or are lost.
    void settle(Mask good) {
        double times[Real::width], steps[Real::width];
        history_.time[0].store(times);
        step_.store(steps);
        for (int lane = 0; lane < Real::width; ++lane) {
            if (path_[lane] == idle) continue;
            ++cost_.steps;
            ++attempts_[lane];
            if (get(good, lane) && arrived_[lane])
                finish(lane, TrackOutcome::arrived);
            else if (get(good, lane) && times[lane] >= 1)
                arrived_[lane] = true;
            else if (steps[lane] < settings_.smallest_step)
                finish(lane, TrackOutcome::stuck);
            else if (attempts_[lane] >= settings_.largest_steps)
                finish(lane, TrackOutcome::endless);
        }
    }

    const TrackedSystem& system_;
    const TrackedImages& images_;
    const TrackSettings& settings_;
    std::size_t count_;
    const CameraPoint* starts_;
    CameraPoint* ends_;
    TrackOutcome* outcomes_;

    Equations equations_;
    History history_;
    Real step_;
    std::size_t next_ = 0;
    std::size_t path_[Real::width];
    int attempts_[Real::width];
    bool arrived_[Real::width];
    int active_ = 0;
    TrackCost cost_;
};

} // namespace

#if defined(PLC_DOUBLE_DOUBLE)
TrackCost track_double_double(
#elif defined(PLC_TRIPLE_DOUBLE)
TrackCost track_triple_double(
#else
TrackCost track(
#endif
    const TrackedSystem& system, const TrackedImages& images, const TrackSettings& settings,
    std::size_t count, const CameraPoint* starts, CameraPoint* ends, TrackOutcome* outcomes) {
    return Tracker(system, images, settings, count, starts, ends, outcomes).run();
}

} // namespace plprove::PLC_LANES
