// Which cameras, points or lines of a part move while it keeps its images.
#pragma once

#include "prover/reasons/part.h"

#include <array>
#include <cstdint>
#include <optional>

namespace plprove {

/// Which cameras move, and the points and lines that span what they keep (W): as `plane` says, or
/// towards centres (`central`). Or none moves, but a point with some lines through it, or a line
/// with some of its points (`loose`). Or one camera moves alone (`camera`). Or the images say more
/// than what has parameters: of the directions of lines and of joins of two points, with rotations
/// and calibrations (`directions`); of the lines through a point and its joins with others, with
/// the maps of these to pencils in the images (`pencils`). Directions may have a core, some of the
/// part of which all parameters count.
enum class MotionKind : std::uint8_t { none, loose, camera, plane, central, directions, pencils };

/// Cameras that slide towards a centre, each as far as the others, with all that they alone see; or
/// that turn about a line, the axis. They keep the span of the generators of the motion and of
/// their own.
struct CentralElement {
    enum class Centre : std::uint8_t { point, line, view, axis };
    Centre kind = Centre::point;
    /// A point; a line, on it a generic point; a view: the centre of its camera; or a line.
    int centre = 0;
    ViewSet views = 0;
    std::vector<int> points{}; ///< generators of its own, ascending
    std::vector<int> lines{};

    bool operator==(const CentralElement&) const = default;
};

struct CameraMotion {
    MotionKind kind = MotionKind::none;
    bool projective = false; ///< the cameras are taken as projective ones
    int centre = 0;          ///< the point O of pencils
    ViewSet moving = 0;      ///< of a plane, or one camera
    /// The generators of W, points and lines of the part, ascending; or those that are loose.
    std::vector<int> points{};
    std::vector<int> lines{};
    std::vector<CentralElement> elements{};  ///< of a central motion
    std::vector<std::array<int, 2>> joins{}; ///< of directions: a forest
    Subproblem core{};                       ///< of directions; without views: none
};

/// The motion in which each of these cameras slides towards a point by itself.
CameraMotion star(int point, ViewSet moving);

/// The point of a star; nothing if the motion is none.
std::optional<int> point_of_star(const CameraMotion& motion);

/// The views that a motion moves.
ViewSet moving_views(const CameraMotion& motion);

/// The elements about a centre that move as few views as possible: what one of them sees and W does
/// not contain moves with it, and so do the views that see that. None without a view. They have no
/// generators of their own.
std::vector<CentralElement> elements_about(const Problem& problem, const Subproblem& part,
                                           const CameraMotion& generators,
                                           CentralElement::Centre kind, int centre);

/// The part without the points that moving views see and the motion does not keep.
Subproblem kept_part(const Problem& problem, Subproblem part, const CameraMotion& motion);

/// The number kappa of FORMAT.md: a lower bound for the dimension of the motions, up to those of
/// space. Nothing if the motion is not as FORMAT.md requires.
std::optional<int> motions(const Problem& problem, const Subproblem& part,
                           const CameraMotion& motion);

} // namespace plprove
