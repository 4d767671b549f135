// Projective cameras: any matrix, up to scale and to projective transformations of space.
#include "prover/cameras/camera_model.h"

namespace plprove {

namespace {

/// Row by row.
template <class T>
CameraMatrix<T> matrix(const T* numbers) {
    CameraMatrix<T> result;
    for (std::size_t i = 0; i < 12; ++i)
        result[i / 4][i % 4] = numbers[i];
    return result;
}

using Complex = CameraModel::Complex;

CameraMatrix<Complex> derivative(const Complex*, const Complex* direction) {
    return matrix(direction);
}

/// All numbers; of the second camera, whose first row is fixed, the others.
std::vector<std::array<int, 2>> scaled_runs(bool second) {
    if (second) return {{4, 8}};
    return {{0, 12}};
}

/// All entries move, but the first five of the second camera and the first of the others.
template <class T>
MovingCamera<T> placed(const Coordinates& numbers, bool second) {
    std::array<T, 12> entries;
    for (std::size_t i = 0; i < entries.size(); ++i)
        entries[i] = T(numbers[i]);
    MovingCamera<T> camera{matrix(entries.data()), {}};
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
                                     .modulo_q = placed<Modular>,
                                     .scaled_runs = scaled_runs,
                                     .matrix = matrix<Complex>,
                                     .derivative = derivative};

} // namespace plprove
