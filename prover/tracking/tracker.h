// The path tracker: follows solutions of a system of equations while its images move, with the
// lanes of the instruction set that the including file is compiled for. What the equations are is
// up to System, which has
//
//     unknowns()                          how many coordinates a point has
//     History, Step                       memory for points, made from the system (below)
//     correct<Moving>(time, step)         one Newton correction of step.point, which this adds, and
//                                         returns its relative size, squared; with step.speed if
//                                         Moving
//     begin(lane, path)                   optional: hears which path the lane follows from now on
//
// No function of the standard library is used here: see lanes.h.
#pragma once

#include "prover/tracking/step_control.h"

#include <cstddef>

namespace plprove::PLC_LANES {

namespace {

/// Follows paths, one in each lane, and starts the next path of the list in a lane that is done.
/// Starts and ends are arrays of `count` points: real and imaginary parts of the coordinates.
template <class System>
class Tracker {
public:
    Tracker(System& system, const TrackSettings& settings, std::size_t count, const double* starts,
            double* ends, TrackOutcome* outcomes)
        : system_(system), settings_(settings), goals_(goals_of(settings)), count_(count),
          starts_(starts), ends_(ends), outcomes_(outcomes), history_(system) {}

    TrackCost run() {
        if (count_ == 0) return cost_;
        known_ = Real::of(1);
        step_ = Real::of(0);
        for (int m = 0; m < 3; ++m) {
            time_[m] = Real::of(-m);
            for (int k = 0; k < system_.unknowns(); ++k)
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

    std::size_t place_of(std::size_t path) const {
        return 2 * static_cast<std::size_t>(system_.unknowns()) * path;
    }

    /// Puts the next path into the lane, or leaves it idle.
    void begin(int lane) {
        path_[lane] = next_ < count_ ? next_++ : idle;
        attempts_[lane] = 0;
        arrived_[lane] = false;
        const double* z = starts_ + place_of(path_[lane] == idle ? 0 : path_[lane]);
        if (path_[lane] != idle) {
            ++active_;
            if constexpr (requires { system_.begin(lane, path_[lane]); })
                system_.begin(lane, path_[lane]);
        }
        for (int k = 0; k < system_.unknowns(); ++k) {
            put(history_.point[0][k].re, lane, z[2 * k]);
            put(history_.point[0][k].im, lane, z[2 * k + 1]);
            put(history_.speed[0][k].re, lane, 0);
            put(history_.speed[0][k].im, lane, 0);
        }
        // The first step goes nowhere: it corrects the start and finds the speed there.
        put(time_[0], lane, 0);
        put(time_[1], lane, -1);
        put(time_[2], lane, -2);
        put(known_, lane, 0);
        put(step_, lane, 0);
    }

    void finish(int lane, TrackOutcome outcome) {
        double* z = ends_ + place_of(path_[lane]);
        for (int k = 0; k < system_.unknowns(); ++k) {
            z[2 * k] = at(history_.point[0][k].re, lane);
            z[2 * k + 1] = at(history_.point[0][k].im, lane);
        }
        outcomes_[path_[lane]] = outcome;
        --active_;
        begin(lane);
    }

    /// One step of all lanes: predict, correct twice by Newton's method, accept or not.
    void advance() {
        const Real time = smaller(time_[0] + step_, Real::of(1));
        typename System::Step step(system_);
        predict(time - time_[0], step.point);
        const Real predicted = system_.template correct<false>(time, step);
        const Real corrected = system_.template correct<true>(time, step);
        const Judgement judgement = judge(goals_, predicted, corrected, known_);
        const Mask good = judgement.good;
        const Mask starting = less(known_, Real::of(0.5));
        remember(good, starting, time, step);
        step_ = next_step(step_, judgement, starting, settings_);
        settle(good);
    }

    /// Where the paths are at the time `after` their newest points.
    void predict(Real after, Number* out) const {
        const Extrapolation extrapolation(time_, known_, after);
        const auto& [point, speed] = history_;
        for (int k = 0; k < system_.unknowns(); ++k)
            out[k] = extrapolation(point[0][k], point[1][k], point[2][k], speed[0][k], speed[1][k],
                                   speed[2][k]);
    }

    /// Makes the point the newest one of the lanes whose step is good.
    [[gnu::always_inline]] void remember(Mask good, Mask starting, Real time,
                                         const typename System::Step& step) {
        for (int k = 0; k < system_.unknowns(); ++k)
            for (int m = 2; m >= 0; --m) {
                const Number& old_point = m > 0 ? history_.point[m - 1][k] : step.point[k];
                const Number& old_speed = m > 0 ? history_.speed[m - 1][k] : step.speed[k];
                history_.point[m][k] = select(good, old_point, history_.point[m][k]);
                history_.speed[m][k] = select(good, old_speed, history_.speed[m][k]);
            }
        // At the start the older points stay what they were: none.
        for (int m = 2; m > 0; --m)
            time_[m] = select(without(good, starting), time_[m - 1], time_[m]);
        time_[0] = select(good, time, time_[0]);
        known_ = select(good, smaller(known_ + Real::of(1), Real::of(3)), known_);
    }

    /// Ends the paths that have arrived, and been corrected once more there, or are lost.
    void settle(Mask good) {
        double times[Real::width], steps[Real::width];
        time_[0].store(times);
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

    System& system_;
    const TrackSettings& settings_;
    StepGoals goals_;
    std::size_t count_;
    const double* starts_;
    double* ends_;
    TrackOutcome* outcomes_;

    typename System::History history_; ///< point[3] and speed[3], the newest first
    Real time_[3];                     ///< of these points
    Real known_;                       ///< how many of them there are
    Real step_;
    std::size_t next_ = 0;
    std::size_t path_[Real::width];
    int attempts_[Real::width];
    bool arrived_[Real::width];
    int active_ = 0;
    TrackCost cost_;
};

} // namespace

} // namespace plprove::PLC_LANES
