#include "prover/three_views/spurious_zeros.h"

#include <algorithm>

namespace plprove {

namespace {

bool has_auxiliary(const CameraSystem& system, const CameraEquation& equation) {
    return std::ranges::any_of(equation.vectors, [&](int vector) {
        return vector >= 0 &&
               system.vectors[static_cast<std::size_t>(vector)].kind == VectorKind::across;
    });
}

} // namespace

SpuriousZeros::SpuriousZeros(const CameraSystem& system, const CameraChart& chart,
                             const std::vector<Complex3>& constants, const Images& images,
                             Random& random)
    : system_(tracked_system(system, chart)) {
    const std::vector<Complex3> others = random_constants(system, random);
    const Images unrelated = random_neighbour(images, random);
    at_rest_ = moving_images(system, constants, images, images);
    turned_ = moving_images(system, others, images, images);
    scale_ = moving_images(system, others, unrelated, unrelated);
    for (std::size_t e = 0; e < system.equations.size(); ++e)
        if (has_auxiliary(system, system.equations[e])) equations_.push_back(e);
}

std::vector<double> SpuriousZeros::residuals(const std::vector<CameraPoint>& zeros) const {
    std::vector<double> result(zeros.size(), 0);
    if (equations_.empty()) return result;
    const auto values_for = [&](const TrackedImages& others) {
        std::vector<Complex> values(zeros.size() * camera_dimension);
        fastest_refined_values()(system_, at_rest_, others, zeros.size(), zeros.data(),
                                 values.data());
        return values;
    };
    const std::vector<Complex> above = values_for(turned_), below = values_for(scale_);
    for (std::size_t i = 0; i < zeros.size(); ++i)
        for (const std::size_t e : equations_) {
            const std::size_t at = i * camera_dimension + e;
            result[i] = std::max(result[i], std::abs(above[at] / below[at]));
        }
    return result;
}

std::vector<bool> SpuriousZeros::among(const std::vector<CameraPoint>& zeros) const {
    constexpr double rounding = 1e-10;
    std::vector<bool> spurious;
    for (const double residual : residuals(zeros))
        spurious.push_back(residual > rounding);
    return spurious;
}

} // namespace plprove
