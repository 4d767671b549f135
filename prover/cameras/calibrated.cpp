// Calibrated cameras: a quaternion and a translation, up to similarities of space.
#include "prover/cameras/camera_map.h"
#include "prover/geometry/quaternion.h"

namespace plprove {

namespace {

using Complex = CameraModel::Complex;

/// [R | t] of a quaternion and t.
struct QuaternionAndTranslation {
    static constexpr int numbers = 7, shared = 0;

    template <class T>
    static CameraMatrix<T> matrix(const T* n) {
        const auto rotation = quaternion_matrix(std::array{n[0], n[1], n[2], n[3]});
        CameraMatrix<T> result;
        for (std::size_t i = 0; i < 3; ++i)
            result[i] = {rotation[i][0], rotation[i][1], rotation[i][2], n[4 + i]};
        return result;
    }

    /// Turns as [w]x R does at w = 0. Of the second camera, the first coordinate of the translation
    /// is kept.
    template <class T>
    static MovingCamera<T> placed(const CameraModel&, const Coordinates& given, bool second) {
        std::array<T, numbers> values;
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = T(given[i]);
        MovingCamera<T> camera{matrix(values.data()), {}, {}};
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
};

/// The matrix is quadratic in the quaternion, so t is multiplied by the square of its factor.
void normalise(Complex* numbers, bool second, Complex& depths) {
    const Complex scale = 1.0 / numbers[0];
    for (int i = 0; i < 4; ++i)
        numbers[i] *= scale;
    if (second) depths = scale * scale * numbers[4];
    const Complex scale_of_t = scale * scale / depths;
    for (int i = 4; i < 7; ++i)
        numbers[i] *= scale_of_t;
}

bool is_camera(const Complex* numbers) {
    return !is_nearly_null(std::span(numbers, 4));
}

constexpr std::array quaternion{ScaledRun{0, 4}};
constexpr std::array quaternion_and_translation{ScaledRun{0, 4}, ScaledRun{4, 3}};

} // namespace

constinit const CameraModel calibrated_cameras =
    with_map<QuaternionAndTranslation>({.name = "calibrated",
                                        .prefix = "",
                                        .unknowns = 6,
                                        .unknowns_of_second = 5,
                                        .may_turn = true,
                                        .scaled = quaternion,
                                        .scaled_in_second = quaternion_and_translation,
                                        .normalise = normalise,
                                        .is_camera = is_camera,
                                        .tracked = TrackedForm::quaternion});

} // namespace plprove
