// Cameras with one focal length and one principal point, unknown and the same for all; square
// pixels.
#include "prover/cameras/pinhole.h"

namespace plprove {

extern const CameraModel shared_focal_center_cameras;
constinit const CameraModel shared_focal_center_cameras =
    Pinhole<SharedFocalCenter, false>::model("shared-focal-center", "shared-focal-center:");

} // namespace plprove
