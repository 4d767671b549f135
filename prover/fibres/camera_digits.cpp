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

std::vector<model::RefinedSolution> starting_points(const DegreeCertificate& certificate) {
    std::vector<model::RefinedSolution> result;
    for (const StartingValues& solution : certificate.solutions) {
        result.push_back({solution.real, std::vector<BigComplex>(camera_dimension)});
        auto value = solution.values.begin();
        for (BigComplex& x : result.back().coordinates) {
            arb_set_si(acb_realref(x.get()), *value++);
            if (!solution.real) arb_set_si(acb_imagref(x.get()), *value++);
            acb_mul_2exp_si(x.get(), x.get(), -solution.bits);
        }
    }
    return result;
}

} // namespace plprove
