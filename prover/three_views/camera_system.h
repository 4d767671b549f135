// The camera equations of a problem: 11 equations in the 11 camera coordinates, as certs/FORMAT.md,
// section 9, has them, in projective charts that suit the tracker.
#pragma once

#include "prover/problem/signature.h"

#include <array>
#include <complex>
#include <vector>

namespace plprove {

using Complex = std::complex<double>;
using Complex3 = std::array<Complex, 3>;

/// The unknowns: 3 for each quaternion, 5 for the centres.
using CameraPoint = std::array<Complex, 11>;

/// Quaternions of cameras 2 and 3 (any length) and centres, which are up to a common factor.
struct QuaternionCameras {
    std::array<std::array<Complex, 4>, 2> quaternion;
    std::array<Complex3, 2> centre;
};

/// The complex conjugates: cameras of the conjugate images.
QuaternionCameras conjugate(const QuaternionCameras& cameras);

/// Affine charts of P^3 x P^3 x P^5, each given by a linear form: quaternion v (a, b, c, d) has
/// a + rotation[v]·(b, c, d) = 1, the six coordinates of the centres have first + centre·rest = 1.
/// The unknowns are what the forms leave: b, c, d of camera 2, of camera 3, and the other five.
struct CameraChart {
    std::array<Complex3, 2> rotation;
    std::array<Complex, 5> centre;

    QuaternionCameras cameras(const CameraPoint& point) const;
    /// Assumes that the cameras are not at infinity of the chart.
    CameraPoint point(const QuaternionCameras& cameras) const;
};

/// The chart of FORMAT.md: quaternions (1, x, y, z), the first coordinate of the second centre 1.
CameraChart standard_chart();

/// How an image vector that occurs in the equations comes from the free vectors of the images.
enum class VectorKind : std::uint8_t {
    free, ///< an image point, or a line of a view that does not see the point: free vector `base`
    meet, ///< the cross product of the free vectors `base` and `other`: the line joining two points
    across ///< the cross product of vector `base` and a constant: an auxiliary line or point
};

struct ImageVector {
    int view = 0;
    VectorKind kind = VectorKind::free;
    int base = 0;
    int other = 0; ///< for `meet`: free vector; for `across`: number of the constant
};

enum class EquationKind : std::uint8_t { epipolar, incidence, pencil };

/// Which image vectors an equation is about: two for `epipolar`, three for the others; that of the
/// ray first for `incidence`.
struct CameraEquation {
    EquationKind kind = EquationKind::pencil;
    std::array<int, 3> vectors{};
};

/// The role of a free vector in its feature, for writing images down.
struct FreeVector {
    int feature = 0; ///< in the list of features of the problem
    int view = 0;
    int line = -1;       ///< -1: the image point; else which pin
    bool toward = false; ///< a second point of a line through the seen point
};

/// Where the point of a feature is in space (a point of the line, if it is a free line), and which
/// image vectors its lines have, -1 in views that do not see them.
struct Triangulation {
    int ray = 0; ///< the image vectors of the ray and the plane that meet there
    int plane = 0;
    std::array<bool, 3> sees_point{};
    std::vector<std::array<int, 3>> lines;
};

struct CameraSystem {
    std::vector<Feature> features;
    std::vector<Triangulation> triangulations; ///< one for each feature
    std::vector<FreeVector> free;
    std::vector<ImageVector> vectors;
    std::vector<CameraEquation> equations; ///< 11
    int constants = 0;                     ///< how many constants `across` refers to
};

/// The equations of a problem that consists of the 27 features, in the order of the table.
CameraSystem camera_system(const Signature& signature);

} // namespace plprove
