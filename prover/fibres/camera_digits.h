// The camera equations at points with many digits, and the solutions of a certificate.
#pragma once

#include "prover/fibres/camera_images.h"
#include "prover/model/lifting/refinement.h"

namespace plprove {

/// The camera equations of a certificate with integer images.
class CameraDigits : public model::DigitEquations {
public:
    explicit CameraDigits(const DegreeCertificate& certificate);

    std::vector<model::BigComplex> values(const Point& point,
                                          const model::ManyDigits& digits) const override;
    std::vector<std::vector<model::BigComplex>>
    slopes(const Point& point, const model::ManyDigits& digits) const override;

private:
    CameraImages images_;
};

/// The solutions of a certificate, as it has them.
std::vector<model::RefinedSolution> starting_points(const DegreeCertificate& certificate);

} // namespace plprove
