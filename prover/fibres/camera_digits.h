// The camera equations at points with many digits.
#pragma once

#include "prover/fibres/camera_images.h"
#include "prover/model/lifting/refinement.h"

namespace plprove {

/// The camera equations of a class with integer images.
class CameraDigits : public model::DigitEquations {
public:
    explicit CameraDigits(CameraImages images) : images_(std::move(images)) {}

    std::vector<model::BigComplex> values(const Point& point,
                                          const model::ManyDigits& digits) const override;
    std::vector<std::vector<model::BigComplex>>
    slopes(const Point& point, const model::ManyDigits& digits) const override;

private:
    CameraImages images_;
};

} // namespace plprove
