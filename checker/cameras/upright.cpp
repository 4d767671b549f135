// The vertical direction is known: each camera turns about one axis.
#include "checker/cameras/pinhole.h"

namespace checker {
extern const CameraModel upright_cameras;
const CameraModel upright_cameras = Pinhole<0, true, false>::model("upright", "upright:");
} // namespace checker
