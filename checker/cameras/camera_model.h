// Kinds of cameras. A kind is a file beside this one, NAME.cpp, which defines NAME_cameras: it says
// how a record places such a camera, how it moves, and what the coordinates of a solution mean.
// Nothing else of the checker knows what a camera is (docs/cameras.md).
#pragma once

#include "checker/algebra/dual.h"
#include "checker/cameras/coordinate_polynomial.h"
#include "checker/file/complaint.h"

#include <array>
#include <span>

namespace checker {
/// The columns of a camera matrix: it takes X to X_1 c_1 + X_2 c_2 + X_3 c_3 + c_4. T is a ring.
template <class T> using CameraMatrix = std::array<Vector3<T>, 4>;

template <class T> using SharedNumbers = std::span<const Dual<T>>;

/// Takes a camera from a record.
template <class T>
using Placed = CameraMatrix<Dual<T>>(Source<T>& source, SharedNumbers<T> shared, bool second);

/// Camera 1 is [I | 0], whatever the kind. That of view 2, the `second`, has fewer unknowns than
/// those after it: what it lacks is fixed by moving space.
struct CameraModel {
    std::string_view name{};
    std::string_view prefix{}; // of a notation; empty for the usual kind
    std::size_t numbers = 0;   // that place a camera in a record
    std::size_t shared = 0;    // numbers, all unknown, that all cameras have in common
    int unknowns = 0;          // of a camera from the third
    int unknowns_of_second = 0;

    /// Whether all matrices of rank 3 are such cameras. Then a camera may also move so that it
    /// keeps the images of a plane, or of a subspace (FORMAT.md, section 13, *Not minimal*).
    /// Theorems on projective cameras are about this kind.
    bool all_matrices = false;

    /// Whether a rotation of space about any line takes cameras to such cameras.
    bool may_turn = false;

    /// Why a record may not place a camera so; empty if it may.
    std::string_view (*objection)(std::span<const int> numbers, bool second) = nullptr;

    /// The camera that the shared numbers and those of a record place; its unknowns are numbered
    /// on.
    Placed<Residue>* place_modulo = nullptr;
    Placed<mpz_class>* place = nullptr;

    /// The camera by the coordinates of a solution: the shared ones, and then its own, as many as
    /// it has unknowns (FORMAT.md, section 14).
    CameraMatrix<CoordinatePolynomial> (*of_solution)(bool second) = nullptr;

    /// How many unknowns, and coordinates in a solution, a camera has.
    std::size_t unknowns_of(bool second) const {
        return static_cast<std::size_t>(second ? unknowns_of_second : unknowns);
    }
};

// Two kinds in which there are families of problems. A notation without a prefix means the first.
extern const CameraModel calibrated_cameras;
extern const CameraModel projective_cameras;

/// All kinds.
std::span<const CameraModel* const> camera_models();

template <class T> CameraMatrix<Dual<T>> first_camera() {
    CameraMatrix<Dual<T>> camera;
    for (std::size_t i = 0; i < 3; ++i)
        camera[i][i] = constant<T>(T{1});
    return camera;
}

inline CameraMatrix<Dual<Residue>> place_camera(const CameraModel& model, Source<Residue>& source,
                                                SharedNumbers<Residue> shared, bool second) {
    return model.place_modulo(source, shared, second);
}

inline CameraMatrix<Dual<mpz_class>> place_camera(const CameraModel& model,
                                                  Source<mpz_class>& source,
                                                  SharedNumbers<mpz_class> shared, bool second) {
    return model.place(source, shared, second);
}
} // namespace checker
