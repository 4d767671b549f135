// Cameras with an unknown focal length each; square pixels, principal point known.
#include "prover/cameras/pinhole.h"

namespace plprove {

extern const CameraModel focal_cameras;
constinit const CameraModel focal_cameras =
    Pinhole<SharedFocal, false, true>::model("focal", "focal:");

} // namespace plprove
