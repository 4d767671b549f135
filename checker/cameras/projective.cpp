// Projective cameras: any matrix, up to scale and to transformations of space (FORMAT.md, section
// 13).
#include "checker/cameras/camera_model.h"

#include <algorithm>

namespace checker {
/// A matrix row by row, whose first entries are fixed.
template <class T> static CameraMatrix<T> place(Source<T>& source, bool second) {
    CameraMatrix<T> camera;
    for (std::size_t entry = 0; entry < 12; ++entry) {
        const bool fixed = entry < (second ? 5 : 1);
        camera[entry % 4][entry / 4] = fixed ? source.fixed() : source.unknown();
    }
    return camera;
}

static std::string_view objection(std::span<const int> second) {
    constexpr std::array first_row{0, 0, 0, 1};
    const bool in_form = std::ranges::equal(second.first(4), first_row);
    return in_form ? "" : "camera 2 does not begin with 0 0 0 1";
}

const CameraModel projective_cameras{.name = "projective",
                                     .prefix = "projective:",
                                     .numbers = 12,
                                     .unknowns = 11,
                                     .motions_of_space = 15,
                                     .plane_motions = true,
                                     .subspace_motions = true,
                                     .objection = objection,
                                     .place_modulo = place<Residue>,
                                     .place = place<mpz_class>};
} // namespace checker
