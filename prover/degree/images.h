// Images of a problem with complex coordinates, and what moves between them.
#pragma once

#include "prover/degree/random.h"
#include "prover/degree/tracker.h"

namespace plprove {

/// One vector for each free vector of the system; only its direction matters.
using Images = std::vector<Complex3>;

Complex3 cross(const Complex3& a, const Complex3& b);

/// R^T x for the rotation (times a factor) of the quaternion, as FORMAT.md has it; and R x.
Complex3 rotate_back(const std::array<Complex, 4>& quaternion, const Complex3& x);
Complex3 rotate(const std::array<Complex, 4>& quaternion, const Complex3& x);

/// Images of a random scene in these cameras.
Images images_of_scene(const CameraSystem& system, const Cameras& cameras, Random& random);

/// Random images in the neighbourhood: far enough for loops to mix the solutions, near enough for
/// the paths to be short.
Images random_neighbour(const Images& images, Random& random);

/// The same images with each vector multiplied by a random number of modulus 1: another path leads
/// there.
Images turned(Images images, Random& random);

/// The same with any numbers of modulus 1: a longer path.
Images turned_around(Images images, Random& random);

/// The constants that the auxiliary lines and points of the system are made with.
std::vector<Complex3> random_constants(const CameraSystem& system, Random& random);

/// All those of FORMAT.md: (1, 0, 0).
std::vector<Complex3> standard_constants(const CameraSystem& system);

/// The image vectors of the system for given images.
std::vector<Complex3> image_vectors(const CameraSystem& system,
                                    const std::vector<Complex3>& constants, const Images& images);

TrackedSystem tracked_system(const CameraSystem& system, const CameraChart& chart);

/// Images that move on straight lines.
TrackedImages moving_images(const CameraSystem& system, const std::vector<Complex3>& constants,
                            const Images& from, const Images& to);

} // namespace plprove
