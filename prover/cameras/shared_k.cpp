// Cameras with one calibration matrix, all of it unknown: autocalibration.
#include "prover/cameras/pinhole.h"

namespace plprove {

extern const CameraModel shared_k_cameras;
constinit const CameraModel shared_k_cameras =
    Pinhole<SharedMatrix, false>::model("shared-k", "shared-k:");

} // namespace plprove
