// The kinds of cameras: CMake writes this list of the files that define one.
#include "checker/cameras/camera_model.h"

namespace checker {
extern const CameraModel calibrated_cameras, projective_cameras;

std::span<const CameraModel* const> camera_models() {
    static constexpr std::array models{&calibrated_cameras, &projective_cameras};
    return models;
}
} // namespace checker
