// The kinds of cameras with the one of translating.cpp, in the place of the list of the checker.
#include "checker/cameras/camera_model.h"

namespace checker {
extern const CameraModel calibrated_cameras, projective_cameras, translating_cameras;

std::span<const CameraModel* const> camera_models() {
    static constexpr std::array models{&calibrated_cameras, &projective_cameras,
                                       &translating_cameras};
    return models;
}
} // namespace checker
