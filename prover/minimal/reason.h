// Why a balanced problem is not minimal, for generic images of any kind: four collinear points, or
// a part of the problem that its images over-constrain (certs/FORMAT.md, section 13; the proofs are
// in proofs/families.md).
#pragma once

#include "prover/problem/problem.h"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace plprove {

/// Four points on a line that two views see: their cross-ratio is the same in both images.
struct FourCollinear {
    std::array<int, 4> points{};
    std::array<int, 2> views{};
};

/// Some of a problem's views, points and lines.
struct Subproblem {
    ViewSet views = 0;
    std::vector<int> points; ///< ascending
    std::vector<int> lines;  ///< ascending
};

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

/// The images of the part satisfy at least `excess` conditions, as the motion keeps them.
struct OverconstrainedPart {
    Subproblem part;
    CameraMotion motion;
    int excess = 0;
};

using Reason = std::variant<FourCollinear, OverconstrainedPart>;

/// The numbers from 1 of what is counted from 0, each after a blank; " -" if there are none.
std::string numbers_from_one(const std::vector<int>& numbers);

/// The whole problem as a part of itself.
Subproblem whole(const Problem& problem);

/// The problem that consists of the part. Its points and lines are numbered anew.
Problem problem_of(const Problem& problem, const Subproblem& part);

/// Whether the part arises by leaving out points and lines one after the other, as FORMAT.md wants
/// it.
bool is_part(const Problem& problem, const Subproblem& part);

/// The part without the points that moving views see and the motion does not keep.
Subproblem kept_part(const Problem& problem, Subproblem part, const CameraMotion& motion);

/// The number kappa of FORMAT.md: a lower bound for the dimension of the motions, up to those of
/// space. Nothing if the motion is not as FORMAT.md requires.
std::optional<int> motions(const Problem& problem, const Subproblem& part,
                           const CameraMotion& motion);

/// How many conditions the images of the part satisfy at least; 0 or less says nothing. Nothing if
/// the motion is not as FORMAT.md requires.
std::optional<int> excess(const Problem& problem, const Subproblem& part,
                          const CameraMotion& motion);

/// A reason why the problem is not minimal; nothing if the search finds none.
std::optional<Reason> find_reason(const Problem& problem);

} // namespace plprove
