// One focal length and one principal point, unknown and the same for all cameras.
#include "checker/cameras/pinhole.h"

namespace checker {
extern const CameraModel shared_focal_center_cameras;
const CameraModel shared_focal_center_cameras =
    Pinhole<3, false, false>::model("shared-focal-center", "shared-focal-center:");
} // namespace checker
