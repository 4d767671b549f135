// The path tracker for any number of views, with the lanes of the instruction set that the
// including file is compiled for.
//
// No function of the standard library is used here: see prover/degree/tracking/lanes.h.
#pragma once

#include "prover/multiview/tracking/linear_solver.h"

namespace plprove::multiview::PLC_LANES {

namespace {

/// Hands out parts of the workspace.
class Workspace {
public:
    explicit Workspace(LaneNumber* memory) : next_(reinterpret_cast<Number*>(memory)) {}

    Number* take(int count) {
        Number* part = next_;
        next_ += count;
        return part;
    }

private:
    Number* next_;
};

/// Follows paths, one in each lane, and starts the next path of the list in a lane that is done.
class Tracker {
public:
    Tracker(const TrackedWay& way, const TrackSettings& settings, std::size_t count,
            const double* starts, double* ends, std::uint8_t* arrived, LaneNumber* memory)
        : way_(way), settings_(settings), goals_(goals_of(settings)), count_(count),
          starts_(starts), ends_(ends), outcomes_(arrived) {
        Workspace workspace(memory);
        for (int m = 0; m < 3; ++m) {
            points_[m] = workspace.take(way.unknowns);
            speeds_[m] = workspace.take(way.unknowns);
        }
        point_ = workspace.take(way.unknowns);
        correction_ = workspace.take(way.unknowns);
        speed_ = workspace.take(way.unknowns);
        places_ = reinterpret_cast<Place*>(workspace.take(8 * way.places));
        inverse_ = workspace.take(way.unknowns);
        rows_ = workspace.take(rows_size(way));
        depth_rows_ = workspace.take(way.depths * (way.depths + 2));
    }

    void run() {
        if (count_ == 0) return;
        known_ = Real::of(1);
        step_ = Real::of(0);
        for (int m = 0; m < 3; ++m) {
            time_[m] = Real::of(-m);
            for (int k = 0; k < way_.unknowns; ++k)
                points_[m][k] = speeds_[m][k] = zero();
        }
        for (int lane = 0; lane < Real::width; ++lane)
            begin(lane);
        while (active_ > 0)
            advance();
    }

private:
    static constexpr std::size_t idle = ~std::size_t{0};

    /// Puts the next path into the lane, or leaves it idle.
    void begin(int lane) {
        path_[lane] = next_ < count_ ? next_++ : idle;
        attempts_[lane] = 0;
        at_end_[lane] = false;
        const std::size_t path = path_[lane] == idle ? 0 : path_[lane];
        if (path_[lane] != idle) ++active_;
        const double* z = starts_ + 2 * static_cast<std::size_t>(way_.unknowns) * path;
        for (int k = 0; k < way_.unknowns; ++k) {
            put(points_[0][k].re, lane, z[2 * k]);
            put(points_[0][k].im, lane, z[2 * k + 1]);
            put(speeds_[0][k].re, lane, 0);
            put(speeds_[0][k].im, lane, 0);
        }
        // The first step goes nowhere: it corrects the start and finds the speed there.
        put(time_[0], lane, 0);
        put(time_[1], lane, -1);
        put(time_[2], lane, -2);
        put(known_, lane, 0);
        put(step_, lane, 0);
    }

    void finish(int lane, bool arrived) {
        const std::size_t path = path_[lane];
        double* z = ends_ + 2 * static_cast<std::size_t>(way_.unknowns) * path;
        for (int k = 0; k < way_.unknowns; ++k) {
            z[2 * k] = at(points_[0][k].re, lane);
            z[2 * k + 1] = at(points_[0][k].im, lane);
        }
        outcomes_[path] = arrived ? 1 : 0;
        --active_;
        begin(lane);
    }

    /// One step of all lanes: predict, correct twice by Newton's method, accept or not.
    void advance() {
        const Real time = smaller(time_[0] + step_, Real::of(1));
        const Extrapolation extrapolation(time_, known_, time - time_[0]);
        for (int k = 0; k < way_.unknowns; ++k)
            point_[k] = extrapolation(points_[0][k], points_[1][k], points_[2][k], speeds_[0][k],
                                      speeds_[1][k], speeds_[2][k]);
        const Real predicted = correct<false>(time);
        const Real corrected = correct<true>(time);
        const Judgement judgement = judge(goals_, predicted, corrected, known_);
        const Mask good = judgement.good;
        const Mask starting = less(known_, Real::of(0.5));
        remember(good, starting, time);
        step_ = next_step(step_, judgement, starting, settings_);
        settle(good);
    }

    /// A correction by Newton's method, and its relative size, squared. If the images are moving,
    /// the speeds are found as well.
    template <bool Moving>
    Real correct(Real time) {
        evaluate_equations<Moving>(time);
        solve<Moving>();
        Real change = Real::of(0), norm = Real::of(1);
        for (int k = 0; k < way_.unknowns; ++k) {
            change = change + square(correction_[k]);
            norm = norm + square(point_[k]);
            point_[k] = point_[k] + correction_[k];
        }
        return change / norm;
    }

    /// Calls `visit` with each camera and the rows of its view.
    template <class Visit>
    [[gnu::always_inline]] void for_each_camera(Visit visit) {
        Number* entries = rows_;
        for (int v = 0; v < way_.cameras; ++v) {
            const TrackedCamera& camera = way_.camera[v];
            const Rows rows{entries, camera.equations, camera.coordinates + way_.depths + 2};
            visit(camera, rows);
            entries += rows.rows * rows.columns;
        }
    }

    template <bool Moving>
    void evaluate_equations(Real time) {
        for (int p = 0; p < way_.places; ++p)
            evaluate(way_.place[p], point_, time, places_[p]);
        for_each_camera([&](const TrackedCamera& camera, const Rows& rows) {
            Number numbers[most_camera_numbers];
            evaluate(camera, point_, numbers);
            for (int e = 0; e < camera.equations; ++e)
                set_row<Moving>(way_, camera, numbers, camera.equation[e], places_, time, rows[e]);
        });
    }

    /// Solves for the correction, and for the speed.
    template <bool Moving>
    void solve() {
        const int depths = way_.depths;
        const Rows of_depths{depth_rows_, depths, depths + 2};
        Number* next = depth_rows_;
        for_each_camera([&](const TrackedCamera& camera, const Rows& rows) {
            eliminate(rows, camera.coordinates, inverse_ + camera.first_coordinate);
            for (int i = camera.coordinates; i < rows.rows; ++i)
                for (int c = camera.coordinates; c < rows.columns; ++c)
                    *next++ = rows[i][c];
        });
        eliminate(of_depths, depths, inverse_);
        substitute_all(of_depths, 0, correction_);
        if constexpr (Moving) substitute_all(of_depths, 1, speed_);
    }

    /// Solves with the right sides in the last column but one, or in the last one.
    void substitute_all(const Rows& of_depths, int side, Number* out) {
        const int depths = way_.depths;
        substitute(of_depths, depths, inverse_, nullptr, 0, depths + side, out);
        for_each_camera([&](const TrackedCamera& camera, const Rows& rows) {
            substitute(rows, camera.coordinates, inverse_ + camera.first_coordinate, out, depths,
                       camera.coordinates + depths + side, out + camera.first_coordinate);
        });
    }

    /// Makes the point the newest one of the lanes whose step is good.
    void remember(Mask good, Mask starting, Real time) {
        for (int k = 0; k < way_.unknowns; ++k)
            for (int m = 2; m >= 0; --m) {
                const Number& old_point = m > 0 ? points_[m - 1][k] : point_[k];
                const Number& old_speed = m > 0 ? speeds_[m - 1][k] : speed_[k];
                points_[m][k] = select(good, old_point, points_[m][k]);
                speeds_[m][k] = select(good, old_speed, speeds_[m][k]);
            }
        // At the start the older points stay what they were: none.
        for (int m = 2; m > 0; --m)
            time_[m] = select(without(good, starting), time_[m - 1], time_[m]);
        time_[0] = select(good, time, time_[0]);
        known_ = select(good, smaller(known_ + Real::of(1), Real::of(3)), known_);
    }

    /// Ends the paths that have arrived, and been corrected once more there, or are lost.
    void settle(Mask good) {
        for (int lane = 0; lane < Real::width; ++lane) {
            if (path_[lane] == idle) continue;
            ++attempts_[lane];
            const bool stepped = get(good, lane);
            if (stepped && at_end_[lane])
                finish(lane, true);
            else if (stepped && at(time_[0], lane) >= 1)
                at_end_[lane] = true;
            else if (at(step_, lane) < settings_.smallest_step ||
                     attempts_[lane] >= settings_.most_steps)
                finish(lane, false);
        }
    }

    const TrackedWay& way_;
    const TrackSettings& settings_;
    StepGoals goals_;
    std::size_t count_;
    const double* starts_;
    double* ends_;
    std::uint8_t* outcomes_;

    Number *points_[3], *speeds_[3]; // the newest first
    Real time_[3];
    Real known_; // how many of these points there are
    Real step_;
    Number *point_, *correction_, *speed_;
    Place* places_;
    Number *inverse_, *rows_, *depth_rows_;
    std::size_t next_ = 0;
    std::size_t path_[Real::width];
    int attempts_[Real::width];
    bool at_end_[Real::width];
    int active_ = 0;
};

} // namespace

void track(const TrackedWay& way, const TrackSettings& settings, std::size_t count,
           const double* starts, double* ends, std::uint8_t* arrived, LaneNumber* workspace) {
    Tracker(way, settings, count, starts, ends, arrived, workspace).run();
}

} // namespace plprove::multiview::PLC_LANES
