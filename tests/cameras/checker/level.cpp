// Level cameras, for tests: the vertical direction is known, so that a camera turns about one axis,
// [R | t], up to similarities of space that keep this axis. It is written as those in
// checker/cameras are.
#include "checker/cameras/camera_model.h"

namespace checker {
/// The columns of (a, 0, b, 0), a^2 + b^2 times a rotation about the second axis, and of t.
template <class T>
static CameraMatrix<T> matrix(const T& a, const T& b, const Vector3<T>& t, const T& zero) {
    const T cosine = a * a - b * b, sine = a * b + a * b;
    return {Vector3<T>{cosine, zero, zero - sine}, Vector3<T>{zero, a * a + b * b, zero},
            Vector3<T>{sine, zero, cosine}, t};
}

/// a stays, and the first coordinate of the second translation.
template <class T>
static CameraMatrix<Dual<T>> place(Source<T>& source, SharedNumbers<T>, bool second) {
    const Dual<T> a = source.fixed(), b = source.unknown();
    const Dual<T> x = second ? source.fixed() : source.unknown();
    const Dual<T> y = source.unknown(), z = source.unknown();
    return matrix(a, b, {x, y, z}, constant<T>(T{}));
}

/// The coordinates are b, where a is 1, and the translation; its first coordinate is 1 in the
/// second camera.
static CameraMatrix<CoordinatePolynomial> of_solution(bool second) {
    std::size_t number = 0;
    const auto next = [&] { return CoordinatePolynomial::coordinate(number++); };
    const CoordinatePolynomial one = CoordinatePolynomial::constant(1), b = next();
    const CoordinatePolynomial x = second ? one : next(), y = next(), z = next();
    return matrix(one, b, {x, y, z}, CoordinatePolynomial{});
}

static std::string_view objection(std::span<const int> numbers, bool second) {
    if (numbers[0] == 0 && numbers[1] == 0) return "a rotation is zero";
    return second && numbers[2] == 0 ? "the translation of camera 2 begins with 0" : "";
}

extern const CameraModel level_cameras;
const CameraModel level_cameras{.name = "level",
                                .prefix = "level:",
                                .numbers = 5,
                                .unknowns = 4,
                                .unknowns_of_second = 3,
                                .objection = objection,
                                .place_modulo = place<Residue>,
                                .place = place<mpz_class>,
                                .of_solution = of_solution};
} // namespace checker
