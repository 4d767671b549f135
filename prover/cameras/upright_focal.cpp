// Cameras whose vertical direction is known, with an unknown focal length each.
#include "prover/cameras/pinhole.h"

namespace plprove {

extern const CameraModel upright_focal_cameras;
constinit const CameraModel upright_focal_cameras =
    Pinhole<SharedFocal, true, true>::model("upright-focal", "upright-focal:");

} // namespace plprove
