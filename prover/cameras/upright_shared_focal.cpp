// Cameras whose vertical direction is known, with one focal length, unknown and the same for all.
#include "prover/cameras/pinhole.h"

namespace plprove {

extern const CameraModel upright_shared_focal_cameras;
constinit const CameraModel upright_shared_focal_cameras =
    Pinhole<SharedFocal, true>::model("upright-shared-focal", "upright-shared-focal:");

} // namespace plprove
