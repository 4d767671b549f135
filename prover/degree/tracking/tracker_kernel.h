// The path tracker, with the lanes of the instruction set that the including file is compiled for;
// with twice or three times as many digits if that file defines PLC_DOUBLE_DOUBLE or
// PLC_TRIPLE_DOUBLE.
//
// No function of the standard library is used here: see lanes.h.
#pragma once

#include "prover/degree/tracking/linear_solver.h"
#include "prover/degree/tracking/prediction.h"

namespace plprove::PLC_LANES {

namespace {

/// Follows paths, one in each lane, and starts the next path of the list in a lane that is done.
class Tracker {
public:
    Tracker(const TrackedSystem& system, const TrackedImages& images, const TrackSettings& settings,
            std::size_t count, const CameraPoint* starts, CameraPoint* ends, TrackOutcome* outcomes)
        : system_(system), images_(images), settings_(settings), goals_(goals_of(settings)),
          count_(count), starts_(starts), ends_(ends), outcomes_(outcomes) {}

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
        const Real time = smaller(history_.time[0] + step_, Real::of(1));
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
        const Judgement judgement = judge(goals_, predicted, corrected, history_.points);
        const Mask good = judgement.good;
        const Mask starting = less(history_.points, Real::of(0.5));
        remember(good, starting, time, point, speed);
        step_ = next_step(step_, judgement, starting, settings_);
        settle(good);
    }

    /// Makes the point the newest one of the lanes whose step is good.
    [[gnu::always_inline]] void remember(Mask good, Mask starting, Real time, const Number* point,
                                         const Number* speed) {
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
            select(good, smaller(history_.points + Real::of(1), Real::of(3)), history_.points);
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
            else if (attempts_[lane] >= settings_.most_steps)
                finish(lane, TrackOutcome::endless);
        }
    }

    const TrackedSystem& system_;
    const TrackedImages& images_;
    const TrackSettings& settings_;
    StepGoals goals_;
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
