// The equations of cameras and depths at points with many digits.
#pragma once

#include "prover/fibres/scene_equations.h"
#include "prover/model/lifting/refinement.h"

namespace plprove {

/// The equations of a problem with integer images.
class SceneDigits : public model::DigitEquations {
public:
    explicit SceneDigits(SceneEquations scene) : scene_(std::move(scene)) {}

    std::vector<model::BigComplex> values(const Point& point,
                                          const model::ManyDigits& digits) const override;
    std::vector<std::vector<model::BigComplex>>
    slopes(const Point& point, const model::ManyDigits& digits) const override;

    /// Whether the solution breaks a condition of the format: a camera of less rank, an image that
    /// is no point or no line. Such solutions are none of the problem.
    bool is_degenerate(const Point& solution, const model::ManyDigits& digits) const;

private:
    SceneEquations scene_;
};

} // namespace plprove
