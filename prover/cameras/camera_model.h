// Kinds of cameras. A kind is one value of CameraModel, in a file of its own, and an entry of the
// list below: how many numbers and unknowns it has, how a certificate places it, how it moves, and
// which complex numbers are such cameras.
#pragma once

#include "prover/geometry/modular.h"

#include <array>
#include <complex>
#include <string_view>
#include <vector>

namespace plprove {

/// A 3 x 4 matrix, row by row.
template <class T>
using CameraMatrix = std::array<std::array<T, 4>, 3>;

/// A camera and its derivatives by its own unknowns.
template <class T>
struct MovingCamera {
    CameraMatrix<T> matrix{};
    std::vector<CameraMatrix<T>> derivative;
};

using Coordinates = std::vector<std::int64_t>;

/// A kind of cameras, as certs/FORMAT.md describes it in section 13.
struct CameraModel {
    std::string_view name;
    std::string_view prefix;  ///< of a notation; empty for the usual kind
    int numbers = 0;          ///< that place a camera in a certificate
    int unknowns = 0;         ///< of a camera
    int motions_of_space = 0; ///< dimension of the group of these

    /// Whether a camera can move and keep the images of a plane; and those of all lines through a
    /// point, where it may keep those of more points and lines, too.
    bool keeps_planes = false;
    bool keeps_lines = false;

    /// The first numbers of the second camera, which are the same in all certificates.
    std::vector<std::int64_t> start_of_second;

    /// The camera that the numbers place. That of view 2, `second`, has fewer unknowns: some are
    /// fixed by moving space. Entries of the derivatives are integers, or residues modulo q.
    MovingCamera<std::int64_t> (*over_integers)(const Coordinates& numbers, bool second) = nullptr;
    MovingCamera<Modular> (*modulo_q)(const Coordinates& numbers, bool second) = nullptr;

    using Complex = std::complex<double>;

    /// Runs of a camera's numbers that count up to a common factor: the first of each, and how
    /// many. One of the factors is fixed by moving space if the camera is the second.
    std::vector<std::array<int, 2>> (*scaled_runs)(bool second) = nullptr;

    /// The matrix of complex numbers, and its derivative along a direction.
    CameraMatrix<Complex> (*matrix)(const Complex* numbers) = nullptr;
    CameraMatrix<Complex> (*derivative)(const Complex* numbers, const Complex* direction) = nullptr;

    /// Parameters of `views` cameras, two or more, up to the motions of space.
    int dimension(int views) const { return unknowns * views - motions_of_space; }
};

extern const CameraModel calibrated_cameras;
extern const CameraModel projective_cameras;

/// All kinds.
inline constexpr std::array<const CameraModel*, 2> camera_models{&calibrated_cameras,
                                                                 &projective_cameras};

/// T is std::int64_t or Modular.
template <class T>
MovingCamera<T> place(const CameraModel& model, const Coordinates& numbers, bool second) {
    if constexpr (std::is_same_v<T, Modular>)
        return model.modulo_q(numbers, second);
    else
        return model.over_integers(numbers, second);
}

} // namespace plprove
