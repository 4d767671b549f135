// Kinds of cameras. A kind is one file beside this one, NAME.cpp, which defines NAME_cameras: how
// many numbers and unknowns such a camera has, its matrix as a function of the numbers, and how a
// certificate places and normalises it. No other file of the prover has to change for a new kind:
// docs/cameras.md says how to add one.
#pragma once

#include "prover/cameras/number_polynomial.h"
#include "prover/cameras/tracked_form.h"
#include "prover/geometry/modular.h"

#include <algorithm>
#include <array>
#include <complex>
#include <span>
#include <string_view>
#include <vector>

namespace plprove {

/// A 3 x 4 matrix, row by row.
template <class T>
using CameraMatrix = std::array<std::array<T, 4>, 3>;

/// A camera and its derivatives by its own unknowns, and by those that all cameras share.
template <class T>
struct MovingCamera {
    CameraMatrix<T> matrix{};
    std::vector<CameraMatrix<T>> derivative;
    std::vector<CameraMatrix<T>> by_shared{};
};

using Coordinates = std::vector<std::int64_t>;

/// Numbers in a row that count up to a common factor.
struct ScaledRun {
    int first = 0, count = 0;
};

/// A kind of cameras, as certs/FORMAT.md describes it in section 13. Camera 1 is [I | 0], whatever
/// the kind. That of view 2, the `second`, has fewer unknowns than those after it: what it lacks is
/// fixed by moving space.
struct CameraModel {
    using Complex = std::complex<double>;

    std::string_view name;
    std::string_view prefix; ///< of a notation; empty for the usual kind
    int unknowns = 0;        ///< of a camera from the third
    int unknowns_of_second = 0;
    int shared = 0; ///< unknowns that all cameras have in common, such as a focal length

    /// Whether all matrices of rank 3 are such cameras. Then a camera may also move so that it
    /// keeps the images of a plane, or of a subspace (certs/FORMAT.md, section 13, *Not minimal*).
    bool all_matrices = false;
    /// Whether a rotation of space about any line takes cameras to such cameras.
    bool may_turn = false;

    /// The first numbers of the second camera, where they are always the same.
    std::span<const std::int64_t> start_of_second{};
    /// What counts up to a factor in a camera; in the second, too, where a scaling of space adds
    /// one.
    std::span<const ScaledRun> scaled{};
    std::span<const ScaledRun> scaled_in_second{};

    /// Multiplies the scaled runs of a camera, so that each begins with 1, and the other numbers
    /// with them: the camera stays what it is up to a factor, and up to the motion of space that
    /// multiplies all depths by `depths`. The second camera sets this, the others get it.
    void (*normalise)(Complex* numbers, bool second, Complex& depths) = nullptr;

    /// Whether the numbers make a camera, not nearly a matrix of less rank that solves the
    /// equations of all images. None: they always do.
    bool (*is_camera)(const Complex* numbers) = nullptr;

    TrackedForm tracked = TrackedForm::polynomials;

    // What follows from the map from numbers to matrices: camera_map.h fills it in.

    int numbers = 0; ///< of a camera itself; with the shared ones, after these, they make it
    /// The matrix, and its derivative along a direction.
    CameraMatrix<Complex> (*matrix)(const Complex* numbers) = nullptr;
    CameraMatrix<Complex> (*derivative)(const Complex* numbers, const Complex* direction) = nullptr;
    CameraMatrix<NumberPolynomial> (*polynomials)(const NumberPolynomial* numbers) = nullptr;

    /// The camera that the numbers of a certificate place, with the shared ones after its own, and
    /// how it moves with its unknowns. Entries of the derivatives are integers, or residues modulo
    /// q.
    MovingCamera<std::int64_t> (*over_integers)(const CameraModel& model,
                                                const Coordinates& numbers, bool second) = nullptr;
    MovingCamera<Modular> (*modulo_q)(const CameraModel& model, const Coordinates& numbers,
                                      bool second) = nullptr;

    /// Parameters of `views` cameras, two or more, up to the motions of space.
    int dimension(int views) const { return shared + unknowns_of_second + unknowns * (views - 2); }
    int all_numbers() const { return numbers + shared; }

    std::span<const ScaledRun> scaled_runs(bool second) const {
        return second ? scaled_in_second : scaled;
    }
    /// The numbers, counted from 0, that are neither always the same nor the first of a scaled run:
    /// as many as a camera has unknowns. They are the coordinates of a normalised camera.
    std::vector<int> coordinates(bool second) const {
        std::vector<int> result;
        for (int k = second ? static_cast<int>(start_of_second.size()) : 0; k < numbers; ++k) {
            const auto begins_at_k = [&](const ScaledRun& run) { return run.first == k; };
            if (std::ranges::none_of(scaled_runs(second), begins_at_k)) result.push_back(k);
        }
        return result;
    }
};

/// The usual kind: a notation without a prefix means these cameras, and the classification.
extern const CameraModel calibrated_cameras;
extern const CameraModel projective_cameras;

/// All kinds.
std::span<const CameraModel* const> camera_models();

/// The camera of these numbers and the shared ones. T is std::int64_t or Modular.
template <class T>
MovingCamera<T> place(const CameraModel& model, Coordinates numbers, const Coordinates& shared,
                      bool second) {
    numbers.insert(numbers.end(), shared.begin(), shared.end());
    if constexpr (std::is_same_v<T, Modular>)
        return model.modulo_q(model, numbers, second);
    else
        return model.over_integers(model, numbers, second);
}

} // namespace plprove
