// Level cameras, for tests: the vertical direction is known, so that a camera turns about one axis,
// [R | t], up to similarities of space that keep this axis. It is written as those in
// prover/cameras are.
#include "prover/cameras/camera_map.h"
#include "prover/geometry/quaternion.h"

namespace plprove {

namespace {

using Complex = CameraModel::Complex;

/// [R | t] of the quaternion (a, 0, b, 0) and t.
struct TurnAndTranslation {
    static constexpr int numbers = 5, shared = 0;

    template <class T>
    static CameraMatrix<T> matrix(const T* n) {
        const T& a = n[0];
        const T& b = n[1];
        const T cosine = a * a - b * b, sine = a * b + a * b;
        return {{{cosine, T{}, sine, n[2]},
                 {T{}, a * a + b * b, T{}, n[3]},
                 {T{} - sine, T{}, cosine, n[4]}}};
    }
};

/// The matrix is quadratic in (a, b), so t is multiplied by the square of its factor.
void normalise(Complex* numbers, bool second, Complex& depths) {
    const Complex scale = 1.0 / numbers[0];
    for (int i = 0; i < 2; ++i)
        numbers[i] *= scale;
    if (second) depths = scale * scale * numbers[2];
    for (int i = 2; i < 5; ++i)
        numbers[i] *= scale * scale / depths;
}

bool is_camera(const Complex* numbers) {
    return !is_nearly_null(std::span(numbers, 2));
}

constexpr std::array turn{ScaledRun{0, 2}};
constexpr std::array turn_and_translation{ScaledRun{0, 2}, ScaledRun{2, 3}};

} // namespace

extern const CameraModel level_cameras;
constinit const CameraModel level_cameras =
    with_map<TurnAndTranslation>({.name = "level",
                                  .prefix = "level:",
                                  .unknowns = 4,
                                  .unknowns_of_second = 3,
                                  .scaled = turn,
                                  .scaled_in_second = turn_and_translation,
                                  .normalise = normalise,
                                  .is_camera = is_camera});

} // namespace plprove
