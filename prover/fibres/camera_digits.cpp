#include "prover/fibres/camera_digits.h"

#include "prover/fibres/cameras_over.h"

namespace plprove {

using model::BigComplex;
using model::ManyDigits;

std::vector<BigComplex> CameraDigits::values(const Point& point, const ManyDigits& digits) const {
    return CamerasOver(digits, images_, point).values();
}

std::vector<std::vector<BigComplex>> CameraDigits::slopes(const Point& point,
                                                          const ManyDigits& digits) const {
    return CamerasOver(digits, images_, point).gradients();
}

} // namespace plprove
