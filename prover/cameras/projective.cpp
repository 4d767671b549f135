// Projective cameras: any matrix, up to scale and to projective transformations of space.
#include "prover/cameras/camera_model.h"

namespace plprove {

namespace {

/// All entries move, but the first five of the second camera and the first of the others.
template <class T>
MovingCamera<T> placed(const Coordinates& numbers, bool second) {
    MovingCamera<T> camera;
    for (std::size_t i = 0; i < 12; ++i)
        camera.matrix[i / 4][i % 4] = T(numbers[i]);
    for (std::size_t i = second ? 5 : 1; i < 12; ++i) {
        CameraMatrix<T> entry{};
        entry[i / 4][i % 4] = T(1);
        camera.derivative.push_back(entry);
    }
    return camera;
}

} // namespace

const CameraModel projective_cameras{.name = "projective",
                                     .prefix = "projective:",
                                     .numbers = 12,
                                     .unknowns = 11,
                                     .motions_of_space = 15,
                                     .keeps_planes = true,
                                     .keeps_lines = true,
                                     .start_of_second = {0, 0, 0, 1},
                                     .over_integers = placed<std::int64_t>,
                                     .modulo_q = placed<Modular>};

} // namespace plprove
