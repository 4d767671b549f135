// One focal length f, unknown and the same for all cameras: the shared number is f².
#include "checker/cameras/pinhole.h"

namespace checker {
extern const CameraModel shared_focal_cameras;
const CameraModel shared_focal_cameras =
    Pinhole<1, false, false>::model("shared-focal", "shared-focal:");
} // namespace checker
