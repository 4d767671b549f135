// Projective cameras: any matrix, up to scale and to projective transformations of space.
#include "prover/cameras/camera_map.h"

namespace plprove {

namespace {

using Complex = CameraModel::Complex;

/// The matrix, row by row.
struct Entries {
    static constexpr int numbers = 12, shared = 0;

    template <class T>
    static CameraMatrix<T> matrix(const T* n) {
        return {{{n[0], n[1], n[2], n[3]}, {n[4], n[5], n[6], n[7]}, {n[8], n[9], n[10], n[11]}}};
    }
};

constexpr std::array<std::int64_t, 4> first_row{0, 0, 0, 1};
constexpr std::array all_entries{ScaledRun{0, 12}};
constexpr std::array other_rows{ScaledRun{4, 8}};

/// Depths are multiplied with the second and third row of the second camera, but not its last
/// column.
void normalise(Complex* numbers, bool second, Complex& depths) {
    if (second) {
        depths = 1.0 / numbers[4];
        for (const int entry : {4, 5, 6, 8, 9, 10})
            numbers[entry] *= depths;
        return;
    }
    for (const int last : {3, 7, 11})
        numbers[last] /= depths;
    const Complex first = numbers[0];
    for (int i = 0; i < 12; ++i)
        numbers[i] /= first;
}

} // namespace

constinit const CameraModel projective_cameras =
    with_map<Entries>({.name = "projective",
                       .prefix = "projective:",
                       .unknowns = 11,
                       .unknowns_of_second = 7,
                       .all_matrices = true,
                       .start_of_second = first_row,
                       .scaled = all_entries,
                       .scaled_in_second = other_rows,
                       .normalise = normalise,
                       .tracked = TrackedForm::entries});

} // namespace plprove
