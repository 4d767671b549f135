// How long the next step of a path is, and where it goes, judged by where the path has been.
//
// No function of the standard library is used here: see lanes.h.
#pragma once

#include "prover/tracking/numbers.h"
#include "prover/tracking/track_settings.h"

namespace plprove::PLC_LANES {

namespace {

/// What a step aims at: relative sizes, squared, as everything here is.
struct StepGoals {
    double prediction;  ///< of Newton's first correction
    double contraction; ///< the second correction is at most that much of the first ...
    double noise;       ///< ... or as small as this
};

inline StepGoals goals_of(const TrackSettings& settings) {
    return {settings.prediction * settings.prediction, settings.contraction * settings.contraction,
            settings.noise * settings.noise};
}

/// Whether steps are accepted, and the factor of the next step: where they are, where not.
struct Judgement {
    Mask good;
    Real stretch, shrink;
};

/// Judges by the sizes of Newton's two corrections, squared; `points` is how many points of the
/// path were extrapolated. Comparisons with NaN are false, so a step to nowhere is refused.
[[gnu::always_inline]] inline Judgement judge(const StepGoals& goals, Real predicted,
                                              Real corrected, Real points) {
    const Real goal = Real::of(goals.prediction);
    const Real noise = Real::of(goals.noise);
    const Real contraction = Real::of(goals.contraction);
    const Mask quiet = less(corrected, noise);
    const Mask newton = less(corrected, contraction * predicted);
    const Mask near = less(predicted, Real::of(64) * goal);
    const Mask good = both(near, either(quiet, newton));

    // How far the step may stretch: both the prediction and the contraction of Newton's method,
    // unless that is noise, are to stay within their limits.
    const Real tiny = Real::of(1e-40);
    Real ratio = goal / (predicted + tiny);
    const Real by_newton = contraction * predicted / (corrected + tiny);
    ratio = select(quiet, ratio, smaller(ratio, by_newton));
    const Real root8 = sqrt(sqrt(sqrt(ratio + tiny))); // of the square: the fourth root
    const Real root16 = sqrt(root8);
    const Real high = Real::of(0.9) * root16 * sqrt(root16);
    const Mask full = less(Real::of(2.5), points);
    const Real stretch =
        smaller(larger(select(full, high, Real::of(0.9) * root8), Real::of(0.3)), Real::of(2.5));
    const Real shrink = smaller(larger(Real::of(0.7) * root8, Real::of(0.1)), Real::of(0.5));
    // The comparison is false for NaN, whose step shrinks at most.
    return {good, stretch, select(less(ratio, Real::of(1e80)), shrink, Real::of(0.1))};
}

/// The size of the next step; `starting` are the lanes whose step went nowhere.
[[gnu::always_inline]] inline Real next_step(Real step, const Judgement& judgement, Mask starting,
                                             const TrackSettings& settings) {
    const Real longer = smaller(step * judgement.stretch, Real::of(settings.largest_step));
    const Real next = select(judgement.good, longer, step * judgement.shrink);
    return select(both(judgement.good, starting), Real::of(settings.first_step), next);
}

/// Hermite extrapolation (Newton's form, each node twice) from the last three points of a path, or
/// all if it has fewer, to the time `after` the newest.
class Extrapolation {
public:
    /// The times of the points, the newest first.
    Extrapolation(const Real* time, Real points, Real after)
        : a_(time[0] - time[1]), b_(time[0] - time[2]), c_(time[1] - time[2]),
          by_a_(Real::of(1) / a_), by_b_(Real::of(1) / b_), by_c_(Real::of(1) / c_),
          two_(less(Real::of(1.5), points)), three_(less(Real::of(2.5), points)), s_(after),
          ss_(s_ * s_), w3_(ss_ * (s_ + a_)), w4_(w3_ * (s_ + a_)), w5_(w4_ * (s_ + b_)) {}

    /// Of one coordinate, from its values x and speeds v there.
    [[gnu::always_inline]] Number operator()(Number x0, Number x1, Number x2, Number v0, Number v1,
                                             Number v2) const {
        return {part(x0.re, x1.re, x2.re, v0.re, v1.re, v2.re),
                part(x0.im, x1.im, x2.im, v0.im, v1.im, v2.im)};
    }

private:
    [[gnu::always_inline]] Real part(Real x0, Real x1, Real x2, Real v0, Real v1, Real v2) const {
        const Real zero = Real::of(0);
        const Real d01 = (x0 - x1) * by_a_, d12 = (x1 - x2) * by_c_;
        const Real d001 = (v0 - d01) * by_a_, d011 = (d01 - v1) * by_a_;
        const Real d112 = (v1 - d12) * by_c_, d122 = (d12 - v2) * by_c_;
        const Real d0011 = (d001 - d011) * by_a_, d0112 = (d011 - d112) * by_b_,
                   d1122 = (d112 - d122) * by_c_;
        const Real d00112 = (d0011 - d0112) * by_b_, d01122 = (d0112 - d1122) * by_b_;
        const Real d001122 = (d00112 - d01122) * by_b_;
        Real sum = fma(s_, v0, x0);
        sum = fma(ss_, select(two_, d001, zero), sum);
        sum = fma(w3_, select(two_, d0011, zero), sum);
        sum = fma(w4_, select(three_, d00112, zero), sum);
        return fma(w5_, select(three_, d001122, zero), sum);
    }

    Real a_, b_, c_, by_a_, by_b_, by_c_;
    Mask two_, three_;
    Real s_, ss_, w3_, w4_, w5_;
};

} // namespace

} // namespace plprove::PLC_LANES
