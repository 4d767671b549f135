// Calibrated cameras: a quaternion and a translation, up to similarities of space.
#include "prover/cameras/camera_model.h"
#include "prover/geometry/quaternion.h"

namespace plprove {

namespace {

/// Turns as [w]x R at w = 0. Of the second camera, the first coordinate of the translation is kept.
template <class T>
MovingCamera<T> placed(const Coordinates& numbers, bool second) {
    const auto rotation =
        quaternion_matrix(std::array{T(numbers[0]), T(numbers[1]), T(numbers[2]), T(numbers[3])});
    MovingCamera<T> camera;
    for (std::size_t i = 0; i < 3; ++i)
        camera.matrix[i] = {rotation[i][0], rotation[i][1], rotation[i][2], T(numbers[4 + i])};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
        CameraMatrix<T> turn{};
        for (std::size_t j = 0; j < 3; ++j) {
            turn[next][j] = T{} - rotation[last][j];
            turn[last][j] = rotation[next][j];
        }
        camera.derivative.push_back(turn);
    }
    for (std::size_t i = second ? 1 : 0; i < 3; ++i) {
        CameraMatrix<T> shift{};
        shift[i][3] = T(1);
        camera.derivative.push_back(shift);
    }
    return camera;
}

} // namespace

const CameraModel calibrated_cameras{.name = "calibrated",
                                     .prefix = "",
                                     .numbers = 7,
                                     .unknowns = 6,
                                     .motions_of_space = 7,
                                     .keeps_planes = false,
                                     .keeps_lines = false,
                                     .start_of_second = {},
                                     .over_integers = placed<std::int64_t>,
                                     .modulo_q = placed<Modular>};

} // namespace plprove
