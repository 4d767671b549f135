// The equations that images put on cameras and scene, for a problem in general whose views all see
// everything (FORMAT.md, section 14).
//
// Camera 1 is [I | 0]. So view 1 shows where in space something is, up to a depth: the image vector
// x stands for (x, depth) in homogeneous coordinates. A camera [M | t] sees it at M x + depth t.
#pragma once

#include "checker/algebra/vector3.h"
#include "checker/file/reader.h"
#include "checker/problem/problem.h"

namespace checker {
/// Of an image point: integers, at most 10^9 in size. Of an image line: at most 2 · 10^18.
using ImageCoordinates = Vector3<std::int64_t>;

/// A linear form of the unknown depths, by its coefficients.
using DepthForm = std::vector<std::int64_t>;

/// A point in space: (x, depth).
struct Place {
    ImageCoordinates x{};
    DepthForm depth{};
};

/// line · (M x + depth t) = 0: the camera sees a place on an image line.
struct SceneEquation {
    std::size_t camera = 0; // 0 is that of view 2
    ImageCoordinates line{};
    std::size_t place = 0;
};

/// An entry of a camera matrix that changes with a coordinate of the camera.
struct ChangingEntry {
    std::size_t coordinate = 0; // shared ones come first
    std::size_t row = 0, column = 0;
    CoordinatePolynomial derivative{};
};

/// A camera [M | t] by the shared coordinates and its own.
struct CameraForm {
    std::size_t shared = 0;
    std::size_t coordinates = 0; // its own
    CameraMatrix<CoordinatePolynomial> matrix{};
    std::vector<ChangingEntry> changes{};
};

CameraForm camera_form(const CameraModel& model, bool second);

/// A problem's equations for its cameras and depths: a square system.
struct SceneSystem {
    CameraForm second{};     // the camera of view 2
    CameraForm other{};      // each camera after it
    std::size_t cameras = 0; // but the first
    std::size_t depths = 0;
    std::vector<Place> places{}; // the points come first
    std::size_t points = 0;
    std::vector<std::array<std::size_t, 2>> lines{}; // two places of each
    std::vector<SceneEquation> equations{};

    const CameraForm& form_of(std::size_t camera) const { return camera == 0 ? second : other; }

    /// How many coordinates all cameras have: these come first.
    std::size_t camera_coordinates() const {
        return second.shared + second.coordinates + (cameras - 1) * other.coordinates;
    }
};

/// How many depths are unknown: one of each free point, and of each end of a line that is no point.
std::size_t depths_of(const Problem& problem);

/// How many numbers say what one view sees.
std::size_t numbers_of_view(const Problem& problem);

/// Takes these numbers and the end of their line. Throws Malformed.
Numbers read_view(Reader& reader, const Problem& problem);

/// The system of a problem and what its views see, a list of numbers a view. Throws Refused if the
/// problem has no such system, or if the images do not meet the conditions.
SceneSystem scene_system(const Problem& problem, const std::vector<Numbers>& views);
} // namespace checker
