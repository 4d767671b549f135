// Which cameras, points or lines of a part move while it keeps its images.
#pragma once

#include "prover/reasons/part.h"

#include <array>
#include <optional>

namespace plprove {

/// Which cameras move, and the points and lines that span what they keep (W). Or none moves, but a
/// point with some lines through it, or a line with some of its points (`loose`). Or one camera
/// moves alone (`camera`). Or the images say more than what has parameters: of the directions of
/// lines and of joins of two points, with rotations and calibrations (`directions`); of the lines
/// through a point and its joins with others, with the maps of these to pencils in the images
/// (`pencils`). Directions may have a core, some of the part of which all parameters count.
enum class MotionKind : std::uint8_t {
    none,
    loose,
    camera,
    apart,
    plane,
    star,
    directions,
    pencils
};
struct CameraMotion {
    MotionKind kind = MotionKind::none;
    bool projective = false; ///< the cameras are taken as projective ones
    int centre = 0;          ///< the point O of a star or of pencils
    ViewSet moving = 0;
    /// The generators of W, points and lines of the part, ascending; or those that are loose.
    std::vector<int> points{};
    std::vector<int> lines{};
    std::vector<std::array<int, 2>> joins{}; ///< of directions: a forest
    Subproblem core{};                       ///< of directions; without views: none
};

/// The part without the points that moving views see and the motion does not keep.
Subproblem kept_part(const Problem& problem, Subproblem part, const CameraMotion& motion);

/// The number kappa of FORMAT.md: a lower bound for the dimension of the motions, up to those of
/// space. Nothing if the motion is not as FORMAT.md requires.
std::optional<int> motions(const Problem& problem, const Subproblem& part,
                           const CameraMotion& motion);

} // namespace plprove
