// The equations that the constraints of a template put on the rotation alone (FORMAT.md, section
// 10), numbered as a file has to number them.
#pragma once

#include "checker/bounds/conditions.h"

namespace checker {
/// Throws Refused unless the constraints have the weight and the coordinates that the frame asks
/// for.
void check_frame(const Constraints& constraints);

/// The equations of constraints that check_frame accepts.
std::vector<RotationEquation> template_equations(const Constraints& constraints,
                                                 const FrameRotations& rotations);
} // namespace checker
