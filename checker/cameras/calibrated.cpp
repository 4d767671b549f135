// Calibrated cameras: a rotation and a translation, up to similarities of space (FORMAT.md,
// sections 2, 13 and 14).
#include "checker/cameras/camera_model.h"

#include <algorithm>

namespace checker {
/// The columns of the rotation of a quaternion, times the square of its norm.
template <class T>
static std::array<Vector3<T>, 3> rotation(const T& a, const T& b, const T& c, const T& d) {
    const auto twice = [](const T& x) -> T { return x + x; };
    return {Vector3<T>{a * a + b * b - c * c - d * d, twice(b * c + a * d), twice(b * d - a * c)},
            Vector3<T>{twice(b * c - a * d), a * a - b * b + c * c - d * d, twice(c * d + a * b)},
            Vector3<T>{twice(b * d + a * c), twice(c * d - a * b), a * a - b * b - c * c + d * d}};
}

/// Turns as [ω]× R does at ω = 0. The first coordinate of the second translation is fixed.
template <class T>
static CameraMatrix<Dual<T>> place(Source<T>& source, SharedNumbers<T>, bool second) {
    const Dual<T> a = source.fixed(), b = source.fixed(), c = source.fixed(), d = source.fixed();
    const auto columns = rotation(a, b, c, d);
    const Vector3<Dual<T>> turn{source.varied(T{}), source.varied(T{}), source.varied(T{})};
    CameraMatrix<Dual<T>> camera;
    for (std::size_t i = 0; i < 3; ++i)
        camera[i] = plus(columns[i], cross(turn, columns[i]));
    camera[3][0] = second ? source.fixed() : source.unknown();
    camera[3][1] = source.unknown();
    camera[3][2] = source.unknown();
    return camera;
}

/// The coordinates are x, y, z of the quaternion (1, x, y, z), and the translation, whose first
/// coordinate is 1 in the second camera.
static CameraMatrix<CoordinatePolynomial> of_solution(bool second) {
    std::size_t number = 0;
    const auto next = [&] { return CoordinatePolynomial::coordinate(number++); };
    const CoordinatePolynomial one = CoordinatePolynomial::constant(1), x = next(), y = next(),
                               z = next();
    const auto columns = rotation(one, x, y, z);
    const CoordinatePolynomial t = second ? one : next();
    return {columns[0], columns[1], columns[2], {t, next(), next()}};
}

static std::string_view objection(std::span<const int> numbers, bool second) {
    const auto is_zero = [](int number) { return number == 0; };
    if (std::ranges::all_of(numbers.first(4), is_zero)) return "a quaternion is zero";
    return second && numbers[4] == 0 ? "the translation of camera 2 begins with 0" : "";
}

const CameraModel calibrated_cameras{.name = "calibrated",
                                     .numbers = 7,
                                     .unknowns = 6,
                                     .unknowns_of_second = 5,
                                     .may_turn = true,
                                     .objection = objection,
                                     .place_modulo = place<Residue>,
                                     .place = place<mpz_class>,
                                     .of_solution = of_solution};
} // namespace checker
