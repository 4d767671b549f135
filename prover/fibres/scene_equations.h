// The equations of cameras and depths for integer images, in the standard chart (certs/FORMAT.md,
// section 14).
#pragma once

#include "prover/many_views/integer_pictures.h"
#include "prover/three_views/integer_vectors.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace plprove {

/// A place (x, d) in space, which a camera [M | t] sees at M x + d t. The depth d is the sum of
/// some unknowns, each times its factor.
struct ScenePlace {
    IntegerVector x{};
    std::vector<std::pair<std::size_t, std::int64_t>> depth{};
};

/// l · (M x + d t) = 0 for the camera [M | t] of the view.
struct SceneEquation {
    std::size_t view = 0; ///< counted from 0; never view 0
    IntegerVector l;
    ScenePlace place;
};

/// A camera as polynomials in the unknowns; and its derivatives by those that it depends on.
struct SceneCamera {
    CameraMatrix<NumberPolynomial> matrix;
    std::vector<std::pair<std::size_t, CameraMatrix<NumberPolynomial>>> derivatives;
};

/// The unknowns are in the order of the file: what all cameras share, the coordinates of each
/// camera, the depths.
struct SceneEquations {
    std::size_t unknowns = 0;
    std::size_t camera_coordinates = 0; ///< the first unknowns
    std::vector<SceneCamera> cameras;   ///< of the views from the second
    std::vector<ScenePlace> points;
    std::vector<std::array<ScenePlace, 2>> lines;
    std::vector<SceneEquation> equations;
};

/// Assumes that the problem is balanced and that all views see everything.
SceneEquations scene_equations(const Problem& problem, const many_views::IntegerImages& integers);

} // namespace plprove
