#include "prover/fibres/camera_images.h"

#include "prover/minimal/placement.h"

namespace plprove {

namespace {

/// The free vectors of the system, as the certificate has them.
std::vector<IntegerVector> free_vectors(const CameraSystem& system,
                                        const std::vector<FeatureImage>& images) {
    std::vector<IntegerVector> result;
    std::size_t line = 0;
    for (std::size_t n = 0; n < system.free.size(); ++n) {
        const FreeVector& free = system.free[n];
        const ViewImage& image = images[static_cast<std::size_t>(free.feature)]
                                     .views[static_cast<std::size_t>(free.view)];
        const bool same_view = n > 0 && system.free[n - 1].feature == free.feature &&
                               system.free[n - 1].view == free.view;
        if (!same_view) line = 0;
        result.push_back(free.line < 0 ? *image.point : image.lines[line++]);
    }
    return result;
}

} // namespace

CameraImages camera_images(const CameraSystem& system, const std::vector<IntegerVector>& free) {
    CameraImages result{system, {}};
    for (const ImageVector& vector : result.system.vectors) {
        const auto base = static_cast<std::size_t>(vector.base);
        const auto other = static_cast<std::size_t>(vector.other);
        if (vector.kind == VectorKind::free)
            result.vectors.push_back(free[base]);
        else if (vector.kind == VectorKind::meet)
            result.vectors.push_back(cross(free[base], free[other]));
        else
            result.vectors.push_back(cross(result.vectors[base], {1, 0, 0}));
    }
    return result;
}

CameraImages camera_images(const DegreeCertificate& certificate) {
    const CameraSystem system = camera_system(label_classes()[certificate.number]);
    return camera_images(system, free_vectors(system, certificate.images));
}

} // namespace plprove
