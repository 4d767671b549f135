// The vertical direction is known, and a focal length of each camera is unknown: the shared number
// is f² of camera 1, each other camera has its ratio to that f.
#include "checker/cameras/pinhole.h"

namespace checker {
extern const CameraModel upright_focal_cameras;
const CameraModel upright_focal_cameras =
    Pinhole<1, true, true>::model("upright-focal", "upright-focal:");
} // namespace checker
