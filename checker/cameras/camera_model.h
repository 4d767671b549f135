// Kinds of cameras. A kind is a row of the table below and a file that says how a record places
// such a camera, and how it moves; nothing else of the checker knows what a camera is.
#pragma once

#include "checker/algebra/dual.h"
#include "checker/file/complaint.h"

#include <array>
#include <span>

namespace checker {
/// The columns of a camera matrix: it takes X to X_1 c_1 + X_2 c_2 + X_3 c_3 + c_4. T is a ring.
template <class T> using CameraMatrix = std::array<Vector3<Dual<T>>, 4>;

struct CameraModel {
    std::string_view name{};
    std::string_view prefix{}; // of a notation; empty for the usual kind
    std::size_t numbers = 0;   // that place a camera in a record
    int unknowns = 0;          // of a camera
    int motions_of_space = 0;  // the dimension of the group that moves all cameras and the scene

    /// The motions of a camera that keep images (FORMAT.md, section 13, *Not minimal*): whether
    /// there are those of a plane, and whether those of a star may keep a subspace, too.
    bool plane_motions = false;
    bool subspace_motions = false;

    /// Why a record may not place the camera of view 2 so; empty if it may.
    std::string_view (*objection)(std::span<const int> second) = nullptr;

    /// The camera that the numbers place, whose unknowns are numbered on. That of view 2, the
    /// `second`, has fewer: what is left out is fixed by moving space.
    CameraMatrix<Residue> (*place_modulo)(Source<Residue>& source, bool second) = nullptr;
    CameraMatrix<mpz_class> (*place)(Source<mpz_class>& source, bool second) = nullptr;
};

extern const CameraModel calibrated_cameras;
extern const CameraModel projective_cameras;

/// All kinds.
inline constexpr std::array<const CameraModel*, 2> camera_models{&calibrated_cameras,
                                                                 &projective_cameras};

/// Camera 1 is [I | 0], whatever the kind.
template <class T> CameraMatrix<T> first_camera() {
    CameraMatrix<T> camera;
    for (std::size_t i = 0; i < 3; ++i)
        camera[i][i] = constant<T>(T{1});
    return camera;
}

inline CameraMatrix<Residue> place_camera(const CameraModel& model, Source<Residue>& source,
                                          bool second) {
    return model.place_modulo(source, second);
}

inline CameraMatrix<mpz_class> place_camera(const CameraModel& model, Source<mpz_class>& source,
                                            bool second) {
    return model.place(source, second);
}
} // namespace checker
