// A third kind of cameras, for tests: all rotations are known, so that a camera is [I | t], up to
// translations and scalings of space. It is written as those in checker/cameras are.
#include "checker/cameras/camera_model.h"

namespace checker {
/// The first coordinate of the second translation is fixed.
template <class T>
static CameraMatrix<Dual<T>> place(Source<T>& source, SharedNumbers<T>, bool second) {
    CameraMatrix<Dual<T>> camera = first_camera<T>();
    camera[3][0] = second ? source.fixed() : source.unknown();
    camera[3][1] = source.unknown();
    camera[3][2] = source.unknown();
    return camera;
}

/// The coordinates are those of the translation, of the second camera without the first, 1.
static CameraMatrix<CoordinatePolynomial> of_solution(bool second) {
    std::size_t number = 0;
    const auto next = [&] { return CoordinatePolynomial::coordinate(number++); };
    CameraMatrix<CoordinatePolynomial> camera;
    for (std::size_t i = 0; i < 3; ++i) {
        camera[i][i] = CoordinatePolynomial::constant(1);
        camera[3][i] = second && i == 0 ? CoordinatePolynomial::constant(1) : next();
    }
    return camera;
}

static std::string_view objection(std::span<const int> numbers, bool second) {
    return second && numbers[0] == 0 ? "the translation of camera 2 begins with 0" : "";
}

extern const CameraModel translating_cameras;
const CameraModel translating_cameras{.name = "translating",
                                      .prefix = "translating:",
                                      .numbers = 3,
                                      .unknowns = 3,
                                      .unknowns_of_second = 2,
                                      .objection = objection,
                                      .place_modulo = place<Residue>,
                                      .place = place<mpz_class>,
                                      .of_solution = of_solution};
} // namespace checker
