// The kinds of cameras: CMake writes this list of the files that define one.
#include "checker/cameras/camera_model.h"

namespace checker {
extern const CameraModel calibrated_cameras, focal_cameras, projective_cameras, shared_focal_cameras, shared_focal_center_cameras, shared_k_cameras, upright_cameras, upright_focal_cameras, upright_shared_focal_cameras;

std::span<const CameraModel* const> camera_models() {
    static constexpr std::array models{&calibrated_cameras, &focal_cameras, &projective_cameras, &shared_focal_cameras, &shared_focal_center_cameras, &shared_k_cameras, &upright_cameras, &upright_focal_cameras, &upright_shared_focal_cameras};
    return models;
}
} // namespace checker
