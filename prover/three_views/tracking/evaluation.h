// The camera equations at a point of the chart and a time, with their derivatives.
//
// No function of the standard library is used here: see lanes.h.
#pragma once

#include "prover/three_views/tracking/tracker.h"
#include "prover/tracking/numbers.h"

namespace plprove::PLC_LANES {

namespace {

constexpr int n = camera_dimension;

/// The Jacobian, the values (column n) and their derivatives with respect to time (column n + 1).
struct Equations {
    Number entry[n][n + 2];
};

/// The cameras at a point of the chart.
struct MovingCameras {
    Number quaternion[3][4];
    Number rotation[3][3][3];
    Vector centre[3];

    MovingCameras(const TrackedSystem& system, const Number* point) {
        const Number zero{Real::of(0), Real::of(0)}, one{Real::of(1), Real::of(0)};
        for (int v = 1; v < 3; ++v) {
            Number* q = quaternion[v];
            q[0] = one;
            for (int k = 0; k < 3; ++k) {
                q[k + 1] = point[3 * (v - 1) + k];
                q[0] = subtract(q[0], constant(system.rotation[v - 1][k]), q[k + 1]);
            }
            rotate(q, rotation[v]);
        }
        centre[0] = {{zero, zero, zero}};
        centre[1].x[0] = one;
        for (int k = 0; k < 5; ++k) {
            centre[1].x[0] = subtract(centre[1].x[0], constant(system.centre[k]), point[6 + k]);
            centre[1 + (k + 1) / 3].x[(k + 1) % 3] = point[6 + k];
        }
    }

    /// R^T x in the given view.
    Vector back(int view, const Vector& x) const {
        if (view == 0) return x;
        const Number(*r)[3] = rotation[view];
        Vector result;
        for (int k = 0; k < 3; ++k)
            result.x[k] = add(add(r[0][k] * x.x[0], r[1][k], x.x[1]), r[2][k], x.x[2]);
        return result;
    }

private:
    static void rotate(const Number* q, Number (*r)[3]) {
        const Number aa = q[0] * q[0], bb = q[1] * q[1], cc = q[2] * q[2], dd = q[3] * q[3];
        const Number ab = q[0] * q[1], ac = q[0] * q[2], ad = q[0] * q[3];
        const Number bc = q[1] * q[2], bd = q[1] * q[3], cd = q[2] * q[3];
        r[0][0] = (aa + bb) - (cc + dd);
        r[1][1] = (aa + cc) - (bb + dd);
        r[2][2] = (aa + dd) - (bb + cc);
        r[0][1] = twice(bc - ad), r[1][0] = twice(bc + ad);
        r[0][2] = twice(bd + ac), r[2][0] = twice(bd - ac);
        r[1][2] = twice(cd - ab), r[2][1] = twice(cd + ab);
    }
};

/// The coefficient of a power of time: that of images which all lanes share.
[[gnu::always_inline]] inline Number coefficient(const TrackedImages& images, int vector,
                                                 int coordinate, int power) {
    return constant(images.coefficient[vector][coordinate][power]);
}

/// Images of its own for each lane.
struct LaneImages {
    Number coefficient[max_vectors][3][3]; ///< [vector][coordinate][power of t]
};
[[gnu::always_inline]] inline Number coefficient(const LaneImages& images, int vector,
                                                 int coordinate, int power) {
    return images.coefficient[vector][coordinate][power];
}

/// An image vector at a time.
template <class Images>
Vector image_vector(const Images& images, int index, Real time) {
    Vector x;
    for (int k = 0; k < 3; ++k) {
        const Number c0 = coefficient(images, index, k, 0), c1 = coefficient(images, index, k, 1),
                     c2 = coefficient(images, index, k, 2);
        x.x[k] = {fma(time, fma(time, c2.re, c1.re), c0.re),
                  fma(time, fma(time, c2.im, c1.im), c0.im)};
    }
    return x;
}

/// Evaluates the equations and their Jacobian and, if Moving, the derivatives with respect to time.
template <class Images>
class Evaluator {
public:
    Evaluator(const TrackedSystem& system, const Images& images, const Number* point)
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
                const Number c1 = coefficient(images_, index, k, 1),
                             c2 = coefficient(images_, index, k, 2);
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
                                               constant(system_.rotation[view - 1][k]), real);
    }

    /// Columns of the centres, from the gradients by the second and third centre.
    void translate(const Vector& g2, const Vector& g3, Number* row) const {
        const Number g[5] = {g2.x[1], g2.x[2], g3.x[0], g3.x[1], g3.x[2]};
        for (int k = 0; k < 5; ++k)
            row[6 + k] = subtract(g[k], constant(system_.centre[k]), g2.x[0]);
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
    const Images& images_;
    MovingCameras cameras_;
    Vector direction_[max_vectors];
    Vector speed_[max_vectors];
    Number product_[max_vectors][4];
};

} // namespace

} // namespace plprove::PLC_LANES
