// Images of a problem with complex coordinates, and what moves between them.
#pragma once

#include "prover/three_views/random.h"
#include "prover/three_views/tracking/tracker.h"

namespace plprove {

/// One vector for each free vector of the system; only its direction matters.
using Images = std::vector<Complex3>;

Complex3 cross(const Complex3& a, const Complex3& b);

/// The multiple of length 1.
Complex3 unit(const Complex3& a);

/// R^T x for the rotation (times a factor) of the quaternion, as FORMAT.md has it; and R x.
Complex3 rotate_back(const std::array<Complex, 4>& quaternion, const Complex3& x);
Complex3 rotate(const std::array<Complex, 4>& quaternion, const Complex3& x);

/// Images of a random scene in these cameras. Of a real scene in real cameras they are real.
Images images_of_scene(const CameraSystem& system, const QuaternionCameras& cameras, Random& random,
                       Field field = Field::complex);

/// Random images in the neighbourhood: far enough for loops to mix the solutions, near enough for
/// the paths to be short.
Images random_neighbour(const Images& images, Random& random, Field field = Field::complex);

/// Images near the middle of the straight way: a detour leads over them.
Images detour_midpoint(const Images& from, const Images& to, Random& random);

/// Which numbers of modulus 1 there are to choose from: those nearer to 1, or all.
enum class Phases : std::uint8_t { near_one, any };

/// The same images with each vector multiplied by a random number of modulus 1: another path leads
/// there, a longer one the farther the numbers are from 1.
Images rephased(Images images, Phases phases, Random& random);

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
