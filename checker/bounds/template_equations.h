// The equations that the constraints of a template put on the rotation alone (FORMAT.md, section
// 10), numbered as a file has to number them.
#pragma once

#include "checker/bounds/conditions.h"

namespace checker {
/// Throws Refused unless the constraints have the weight and the coordinates that the frame asks
/// for.
void check_frame(const Constraints& constraints);

/// The equations of constraints that check_frame accepts. They need the constraints and rotations
/// as long as they are used.
class TemplateEquations {
public:
    TemplateEquations(const Constraints& constraints, const FrameRotations& rotations);
    TemplateEquations(const TemplateEquations&) = delete;
    TemplateEquations& operator=(const TemplateEquations&) = delete;

    const std::vector<RotationEquation>& all() const { return equations_; }

private:
    void add(const std::vector<RotationEquation>& more);
    void add_constraints_alone();

    const Constraints& constraints_;
    const FrameRotations& rotations_;
    std::vector<Condition> conditions_;
    Determinants determinants_;
    std::vector<RotationEquation> equations_;
};
} // namespace checker
