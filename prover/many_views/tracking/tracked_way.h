// The camera equations of images on a straight way, in plain arrays for the inner loops.
#pragma once

#include "prover/cameras/tracked_form.h"
#include "prover/tracking/lane_number.h"
#include "prover/tracking/track_settings.h"

#include <cstddef>
#include <cstdint>

namespace plprove::many_views {

/// A polynomial in time: coefficients of 1, t, t^2, ..., as real and imaginary parts.
struct TrackedPolynomial {
    int size = 0;
    const double (*coefficients)[2] = nullptr;
};

/// A point of space: x, which view 1 shows, and the depth, a sum of unknown depths with factors.
struct TrackedPlace {
    TrackedPolynomial x[3];
    int depths = 0;
    const int* unknowns = nullptr; ///< the indices of these depths
    const TrackedPolynomial* factors = nullptr;
};

/// That a camera sees a place on the image line l.
struct TrackedEquation {
    int place = 0;
    TrackedPolynomial l[3];
};

/// The factor of a coordinate of the chart in a number that makes the camera.
struct TrackedBasisEntry {
    int number = 0, coordinate = 0;
    double factor[2] = {};
};

/// A product of numbers that make the camera, with a factor.
struct TrackedMonomial {
    double factor = 0;
    int size = 0;
    const int* numbers = nullptr;
};

/// An entry of the camera matrix, counted row by row, or its derivative by a number: a sum of
/// monomials.
struct TrackedEntry {
    int entry = 0;
    int number = -1; ///< none
    int size = 0;
    const TrackedMonomial* monomials = nullptr;
};

/// A camera in its chart (cameras.h), and the equations of its view.
struct TrackedCamera {
    int coordinates = 0;
    int first_coordinate = 0; ///< among all unknowns
    double origin[most_camera_numbers][2] = {};
    int basis_entries = 0;
    const TrackedBasisEntry* basis = nullptr;
    int equations = 0; ///< no fewer than coordinates
    const TrackedEquation* equation = nullptr;
};

/// The unknowns are the depths and the numbers that all cameras share, which all rows have, and
/// then the coordinates of each camera.
struct TrackedWay {
    TrackedForm form = TrackedForm::polynomials;
    int entries = 0; ///< of the form `polynomials`: those of the matrix, and their derivatives
    const TrackedEntry* entry = nullptr;
    int depths = 0;
    int shared = 0;
    int numbers = 0; ///< of a camera itself; the shared ones come after them
    int unknowns = 0;
    int cameras = 0; ///< without that of view 1
    const TrackedCamera* camera = nullptr;
    int places = 0;
    const TrackedPlace* place = nullptr;

    int common() const { return depths + shared; }
};

/// For any number of views: a little more careful than the defaults.
inline constexpr TrackSettings usual_settings{.prediction = 1e-3,
                                              .contraction = 0.05,
                                              .largest_step = 0.2,
                                              .smallest_step = 1e-10,
                                              .most_steps = 2000};

/// How many entries the rows of all views have: a row is an equation, its columns are the
/// coordinates of the camera, the common unknowns, and two right sides.
int rows_size(const TrackedWay& way);

/// How many LaneNumbers a tracker needs to work with.
std::size_t workspace_size(const TrackedWay& way);

/// Follows each start, `way.unknowns` complex numbers, to t = 1; starts and ends are arrays of
/// `count` points, outcomes as well.
using TrackFunction = TrackCost(const TrackedWay& way, const TrackSettings& settings,
                                std::size_t count, const double* starts, double* ends,
                                TrackOutcome* outcomes, LaneNumber* workspace);

namespace avx512 {
TrackFunction track, track_double_double;
} // namespace avx512
namespace avx2 {
TrackFunction track, track_double_double;
} // namespace avx2
namespace portable {
TrackFunction track, track_double_double;
} // namespace portable

/// The one with most lanes that this machine can run. All give the same results, to the bit.
TrackFunction* fastest_tracker();
/// The same with about 32 digits throughout, some ten times as slow; starts and ends are doubles.
TrackFunction* fastest_double_double_tracker();

} // namespace plprove::many_views
