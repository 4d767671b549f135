// The path tracker for any number of views, with the lanes of the instruction set that the
// including file is compiled for.
//
// No function of the standard library is used here: see prover/tracking/lanes.h.
#pragma once

#include "prover/many_views/tracking/evaluation.h"
#include "prover/tracking/elimination.h"
#include "prover/tracking/tracker.h"

namespace plprove::many_views::PLC_LANES {

namespace {

/// The camera equations of images on a way, as a Tracker wants them. Points and rows are in a
/// workspace, as their sizes are known only now.
class EquationsOnWay {
public:
    EquationsOnWay(const TrackedWay& way, LaneNumber* workspace)
        : way_(way), next_(reinterpret_cast<Number*>(workspace)), step_point_(take(way.unknowns)),
          correction_(take(way.unknowns)), step_speed_(take(way.unknowns)),
          places_(reinterpret_cast<Place*>(take(8 * way.places))), inverse_(take(way.unknowns)),
          entries_(take(way.entries)), rows_(take(rows_size(way))),
          common_rows_(take(way.common() * (way.common() + 2))) {}

    struct History {
        explicit History(EquationsOnWay& system) {
            for (int m = 0; m < 3; ++m) {
                point[m] = system.take(system.unknowns());
                speed[m] = system.take(system.unknowns());
            }
        }
        Number *point[3], *speed[3];
    };
    /// The same memory for each step.
    struct Step {
        explicit Step(EquationsOnWay& system)
            : point(system.step_point_), speed(system.step_speed_) {}
        Number *point, *speed;
    };

    int unknowns() const { return way_.unknowns; }

    template <bool Moving>
    Real correct(Real time, Step& step) {
        evaluate_equations<Moving>(time);
        solve<Moving>();
        Real change = Real::of(0), norm = Real::of(1);
        for (int k = 0; k < way_.unknowns; ++k) {
            change = change + square(correction_[k]);
            norm = norm + square(step.point[k]);
            step.point[k] = step.point[k] + correction_[k];
        }
        return change / norm;
    }

private:
    Number* take(int count) {
        Number* part = next_;
        next_ += count;
        return part;
    }

    /// Calls `visit` with each camera and the rows of its view.
    template <class Visit>
    [[gnu::always_inline]] void for_each_camera(Visit visit) {
        Number* entries = rows_;
        for (int v = 0; v < way_.cameras; ++v) {
            const TrackedCamera& camera = way_.camera[v];
            const Rows rows{entries, camera.equations, camera.coordinates + way_.common() + 2};
            visit(camera, rows);
            entries += rows.rows * rows.columns;
        }
    }

    template <bool Moving>
    void evaluate_equations(Real time) {
        for (int p = 0; p < way_.places; ++p)
            evaluate(way_.place[p], step_point_, time, places_[p]);
        for_each_camera([&](const TrackedCamera& camera, const Rows& rows) {
            Number numbers[most_camera_numbers];
            evaluate(way_, camera, step_point_, numbers);
            if (way_.form == TrackedForm::quaternion) {
                set_rows<Moving>(camera, QuaternionForm{numbers}, time, rows);
            } else if (way_.form == TrackedForm::entries) {
                set_rows<Moving>(camera, EntryForm{numbers}, time, rows);
            } else {
                for (int e = 0; e < way_.entries; ++e)
                    entries_[e] = evaluate(way_.entry[e], numbers);
                set_rows<Moving>(camera, PolynomialForm{way_, entries_}, time, rows);
            }
        });
    }

    template <bool Moving, class Form>
    void set_rows(const TrackedCamera& camera, const Form& form, Real time, const Rows& rows) {
        for (int e = 0; e < camera.equations; ++e) {
            const TrackedEquation& equation = camera.equation[e];
            set_row<Moving>(way_, camera, form, equation, way_.place[equation.place],
                            places_[equation.place], time, rows[e]);
        }
    }

    /// Solves for the correction, and for the speed.
    template <bool Moving>
    void solve() {
        const int common = way_.common();
        const Rows of_common{common_rows_, common, common + 2};
        Number* next = common_rows_;
        for_each_camera([&](const TrackedCamera& camera, const Rows& rows) {
            eliminate(rows, camera.coordinates, inverse_ + camera.first_coordinate);
            for (int i = camera.coordinates; i < rows.rows; ++i)
                for (int c = camera.coordinates; c < rows.columns; ++c)
                    *next++ = rows[i][c];
        });
        eliminate(of_common, common, inverse_);
        substitute_all(of_common, 0, correction_);
        if constexpr (Moving) substitute_all(of_common, 1, step_speed_);
    }

    /// Solves with the right sides in the last column but one, or in the last one.
    void substitute_all(const Rows& of_common, int side, Number* out) {
        const int common = way_.common();
        substitute(of_common, common, inverse_, nullptr, 0, common + side, out);
        for_each_camera([&](const TrackedCamera& camera, const Rows& rows) {
            substitute(rows, camera.coordinates, inverse_ + camera.first_coordinate, out, common,
                       camera.coordinates + common + side, out + camera.first_coordinate);
        });
    }

    const TrackedWay& way_;
    Number* next_; // of the workspace
    Number *step_point_, *correction_, *step_speed_;
    Place* places_;
    Number *inverse_, *entries_, *rows_, *common_rows_;
};

} // namespace

#if defined(PLC_DOUBLE_DOUBLE)
TrackCost track_double_double(
#else
TrackCost track(
#endif
    const TrackedWay& way, const TrackSettings& settings, std::size_t count, const double* starts,
    double* ends, TrackOutcome* outcomes, LaneNumber* workspace) {
    EquationsOnWay equations(way, workspace);
    return Tracker<EquationsOnWay>(equations, settings, count, starts, ends, outcomes).run();
}

} // namespace plprove::many_views::PLC_LANES
