#include "prover/degree/spurious_zeros.h"

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
    const TrackedImages at_rest = moving_images(system, constants, images, images);
    const TrackedImages turned = moving_images(system, others, images, images);
    const TrackedImages scale = moving_images(system, others, unrelated, unrelated);
    for (std::size_t e = 0; e < system.equations.size(); ++e)
        if (has_auxiliary(system, system.equations[e]))
            pencils_.push_back({static_cast<int>(e), at_rest, scale, turned});
}

std::vector<double> SpuriousZeros::residuals(const std::vector<CameraPoint>& zeros) const {
    std::vector<double> result(zeros.size(), 0);
    if (pencils_.empty()) return result;
    std::vector<TraceTerm> terms(zeros.size() * pencils_.size());
    fastest_trace()(system_, pencils_.data(), pencils_.size(), zeros.size(), zeros.data(),
                    terms.data());
    for (std::size_t i = 0; i < terms.size(); ++i) {
        double& largest = result[i / pencils_.size()];
        largest = std::max(largest, std::abs(terms[i].constant));
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
