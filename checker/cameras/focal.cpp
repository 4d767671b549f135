// A focal length of each camera, unknown: the shared number is f² of camera 1, each other camera
// has its ratio to that f.
#include "checker/cameras/pinhole.h"

namespace checker {
extern const CameraModel focal_cameras;
const CameraModel focal_cameras = Pinhole<1, false, true>::model("focal", "focal:");
} // namespace checker
