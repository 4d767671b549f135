// Calibrated cameras: a quaternion and a translation, up to similarities of space.
#include "prover/cameras/camera_model.h"
#include "prover/geometry/dual.h"
#include "prover/geometry/quaternion.h"

namespace plprove {

namespace {

/// [R | t] of a quaternion and t.
template <class T>
CameraMatrix<T> matrix(const T* numbers) {
    const auto rotation =
        quaternion_matrix(std::array{numbers[0], numbers[1], numbers[2], numbers[3]});
    CameraMatrix<T> result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = {rotation[i][0], rotation[i][1], rotation[i][2], numbers[4 + i]};
    return result;
}

using Complex = CameraModel::Complex;

CameraMatrix<Complex> derivative(const Complex* numbers, const Complex* direction) {
    std::array<Dual<Complex>, 7> moving;
    for (std::size_t i = 0; i < moving.size(); ++i)
        moving[i] = {numbers[i], direction[i]};
    const CameraMatrix<Dual<Complex>> camera = matrix(moving.data());
    CameraMatrix<Complex> result;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            result[i][j] = camera[i][j].slope;
    return result;
}

/// The quaternion; t of the second camera, too.
std::vector<std::array<int, 2>> scaled_runs(bool second) {
    if (second) return {{0, 4}, {4, 3}};
    return {{0, 4}};
}

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
            turn[next][j] = T{} - camera.matrix[last][j];
            turn[last][j] = camera.matrix[next][j];
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
                                     .modulo_q = placed<Modular>,
                                     .scaled_runs = scaled_runs,
                                     .matrix = matrix<Complex>,
                                     .derivative = derivative};

} // namespace plprove
