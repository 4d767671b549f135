// Calibrated cameras whose vertical direction is known: each turns about one axis.
#include "prover/cameras/pinhole.h"

namespace plprove {

extern const CameraModel upright_cameras;
constinit const CameraModel upright_cameras =
    Pinhole<Calibrated, true>::model("upright", "upright:");

} // namespace plprove
