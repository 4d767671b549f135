// Calibrated cameras: a rotation and a translation, up to similarities of space (FORMAT.md,
// sections 2 and 13).
#include "checker/cameras/camera_model.h"

namespace checker {
/// Turns as [ω]× R does at ω = 0. The first coordinate of the translation of view 2 is fixed.
template <class T> static CameraMatrix<T> place(Source<T>& source, bool second) {
    const Dual<T> a = source.fixed(), b = source.fixed(), c = source.fixed(), d = source.fixed();
    const Dual<T> two = constant<T>(T{2});
    using Vector = Vector3<Dual<T>>;
    const std::array<Vector, 3> rotation{
        Vector{a * a + b * b - c * c - d * d, two * (b * c + a * d), two * (b * d - a * c)},
        Vector{two * (b * c - a * d), a * a - b * b + c * c - d * d, two * (c * d + a * b)},
        Vector{two * (b * d + a * c), two * (c * d - a * b), a * a - b * b - c * c + d * d}};
    const Vector turn{source.varied(T{}), source.varied(T{}), source.varied(T{})};
    CameraMatrix<T> camera;
    for (std::size_t i = 0; i < 3; ++i)
        camera[i] = plus(rotation[i], cross(turn, rotation[i]));
    camera[3][0] = second ? source.fixed() : source.unknown();
    camera[3][1] = source.unknown();
    camera[3][2] = source.unknown();
    return camera;
}

const CameraModel calibrated_cameras{
    .name = "calibrated",
    .numbers = 7,
    .unknowns = 6,
    .motions_of_space = 7,
    .objection = [](std::span<const int>) { return std::string_view{}; },
    .place_modulo = place<Residue>,
    .place = place<mpz_class>};
} // namespace checker
