// One calibration matrix, unknown and the same for all cameras.
#include "checker/cameras/pinhole.h"

namespace checker {
extern const CameraModel shared_k_cameras;
const CameraModel shared_k_cameras = Pinhole<5, false, false>::model("shared-k", "shared-k:");
} // namespace checker
