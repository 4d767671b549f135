// The vertical direction is known, and one focal length f is unknown and the same for all cameras:
// the shared number is f².
#include "checker/cameras/pinhole.h"

namespace checker {
extern const CameraModel upright_shared_focal_cameras;
const CameraModel upright_shared_focal_cameras =
    Pinhole<1, true, false>::model("upright-shared-focal", "upright-shared-focal:");
} // namespace checker
