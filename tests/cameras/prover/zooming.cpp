// Zooming cameras, for tests: all rotations are known, and focal lengths are not. A camera is
// [diag(r, r, 1) | t], where r is its focal length divided by that of camera 1, up to translations
// and scalings of space. It is written as those in prover/cameras are.
#include "prover/cameras/camera_map.h"

namespace plprove {

namespace {

using Complex = CameraModel::Complex;

/// [diag(r, r, 1) | t] of r and t.
struct ZoomAndTranslation {
    static constexpr int numbers = 4, shared = 0;

    template <class T>
    static CameraMatrix<T> matrix(const T* n) {
        return {{{n[0], T{}, T{}, n[1]}, {T{}, n[0], T{}, n[2]}, {T{}, T{}, in_ring<T>(1), n[3]}}};
    }
};

/// Depths are in units of the first coordinate of t in camera 2.
void normalise(Complex* numbers, bool second, Complex& depths) {
    if (second) depths = numbers[1];
    for (int i = 1; i < 4; ++i)
        numbers[i] /= depths;
}

bool is_camera(const Complex* numbers) {
    return std::norm(numbers[0]) > 1e-16;
}

constexpr std::array translation{ScaledRun{1, 3}};

} // namespace

extern const CameraModel zooming_cameras;
constinit const CameraModel zooming_cameras =
    with_map<ZoomAndTranslation>({.name = "zooming",
                                  .prefix = "zooming:",
                                  .unknowns = 4,
                                  .unknowns_of_second = 3,
                                  .scaled_in_second = translation,
                                  .normalise = normalise,
                                  .is_camera = is_camera});

} // namespace plprove
