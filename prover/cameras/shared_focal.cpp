// Cameras with one focal length, unknown and the same for all; square pixels, principal point
// known.
#include "prover/cameras/pinhole.h"

namespace plprove {

extern const CameraModel shared_focal_cameras;
constinit const CameraModel shared_focal_cameras =
    Pinhole<SharedFocal, false>::model("shared-focal", "shared-focal:");

} // namespace plprove
