// Projective cameras: any matrix, up to scale and to transformations of space (FORMAT.md, sections
// 13 and 14).
#include "checker/cameras/camera_model.h"

#include <algorithm>

namespace checker {
/// Row by row, the first entries are fixed.
static std::size_t fixed_entries(bool second) {
    return second ? 5 : 1;
}

template <class T>
static CameraMatrix<Dual<T>> place(Source<T>& source, SharedNumbers<T>, bool second) {
    CameraMatrix<Dual<T>> camera;
    for (std::size_t entry = 0; entry < 12; ++entry) {
        const bool fixed = entry < fixed_entries(second);
        camera[entry % 4][entry / 4] = fixed ? source.fixed() : source.unknown();
    }
    return camera;
}

/// The fixed entries are 1, or 0, 0, 0, 1, 1; the others are the coordinates.
static CameraMatrix<CoordinatePolynomial> of_solution(bool second) {
    CameraMatrix<CoordinatePolynomial> camera;
    const std::size_t fixed = fixed_entries(second);
    for (std::size_t entry = 0; entry < 12; ++entry)
        camera[entry % 4][entry / 4] =
            entry < fixed ? CoordinatePolynomial::constant(second && entry < 3 ? 0 : 1)
                          : CoordinatePolynomial::coordinate(entry - fixed);
    return camera;
}

static std::string_view objection(std::span<const int> numbers, bool second) {
    constexpr std::array first_row{0, 0, 0, 1};
    const bool in_form = std::ranges::equal(numbers.first(4), first_row);
    return second && !in_form ? "camera 2 does not begin with 0 0 0 1" : "";
}

const CameraModel projective_cameras{.name = "projective",
                                     .prefix = "projective:",
                                     .numbers = 12,
                                     .unknowns = 11,
                                     .unknowns_of_second = 7,
                                     .all_matrices = true,
                                     .objection = objection,
                                     .place_modulo = place<Residue>,
                                     .place = place<mpz_class>,
                                     .of_solution = of_solution};
} // namespace checker
