#include "prover/fibres/camera_digits.h"

#include "prover/fibres/cameras_over.h"

namespace plprove {

using model::BigComplex;
using model::ManyDigits;

CameraDigits::CameraDigits(const DegreeCertificate& certificate)
    : images_(camera_images(certificate)) {}

std::vector<BigComplex> CameraDigits::values(const Point& point, const ManyDigits& digits) const {
    CamerasOver cameras(digits, images_, point);
    std::vector<BigComplex> result;
    for (const CameraEquation& equation : images_.system.equations)
        result.push_back(cameras.value(equation));
    return result;
}

std::vector<std::vector<BigComplex>> CameraDigits::slopes(const Point& point,
                                                          const ManyDigits& digits) const {
    CamerasOver cameras(digits, images_, point);
    std::vector<std::vector<BigComplex>> result;
    for (const CameraEquation& equation : images_.system.equations)
        result.push_back(cameras.gradient(equation));
    return result;
}

} // namespace plprove
