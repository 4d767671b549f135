// Parts of a problem without some of its points, lines or views.
#pragma once

#include "prover/reasons/motion.h"

namespace plprove {

/// The part of a problem that two views or more see in common: of each point and line, it has those
/// that all these views see.
Subproblem common_part(const Problem& problem, ViewSet views);

/// The part without the point and its pins, or without the line.
Subproblem without_point(const Problem& problem, Subproblem part, int point);
Subproblem without_line(Subproblem part, int line);

/// Leaves out points and lines as long as the images of the rest, which the motion keeps, have more
/// parameters to spare.
Subproblem densest(const Problem& problem, Subproblem part, const CameraMotion& motion = {});

/// The part of it that these views see.
Subproblem seen_in(const Problem& problem, Subproblem part, ViewSet views);

} // namespace plprove
