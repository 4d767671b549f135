// Zooming cameras, for tests: all rotations are known, and focal lengths are not. A camera is
// [diag(r, r, 1) | t], where r is its focal length divided by that of camera 1, up to translations
// and scalings of space. It is written as those in checker/cameras are.
#include "checker/cameras/camera_model.h"

namespace checker {
template <class T>
static CameraMatrix<T> matrix(const T& r, const Vector3<T>& t, const T& zero, const T& one) {
    return {Vector3<T>{r, zero, zero}, Vector3<T>{zero, r, zero}, Vector3<T>{zero, zero, one}, t};
}

/// The first coordinate of the second translation stays.
template <class T>
static CameraMatrix<Dual<T>> place(Source<T>& source, SharedNumbers<T>, bool second) {
    const Dual<T> r = source.unknown();
    const Dual<T> x = second ? source.fixed() : source.unknown();
    const Dual<T> y = source.unknown(), z = source.unknown();
    return matrix<Dual<T>>(r, {x, y, z}, constant<T>(T{}), constant<T>(T{1}));
}

/// The coordinates are r and the translation, whose first coordinate is 1 in the second camera.
static CameraMatrix<CoordinatePolynomial> of_solution(bool second) {
    std::size_t number = 0;
    const auto next = [&] { return CoordinatePolynomial::coordinate(number++); };
    const CoordinatePolynomial one = CoordinatePolynomial::constant(1), r = next();
    const CoordinatePolynomial x = second ? one : next(), y = next(), z = next();
    return matrix<CoordinatePolynomial>(r, {x, y, z}, {}, one);
}

static std::string_view objection(std::span<const int> numbers, bool second) {
    if (numbers[0] == 0) return "the focal length is zero";
    return second && numbers[1] == 0 ? "the translation of camera 2 begins with 0" : "";
}

extern const CameraModel zooming_cameras;
const CameraModel zooming_cameras{.name = "zooming",
                                  .prefix = "zooming:",
                                  .numbers = 4,
                                  .unknowns = 4,
                                  .unknowns_of_second = 3,
                                  .objection = objection,
                                  .place_modulo = place<Residue>,
                                  .place = place<mpz_class>,
                                  .of_solution = of_solution};
} // namespace checker
