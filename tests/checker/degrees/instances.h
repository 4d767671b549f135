// Systems and degree records made from known cameras and scenes, by exact arithmetic and without
// any tracker.
#pragma once

#include "checker/degrees/degeneracy.h"
#include "checker/replay.h"
#include "tests/support/minimal_classes.h"
#include "tests/support/text.h"

#include <gmpxx.h>

#include <complex>
#include <initializer_list>
#include <random>
#include <string>
#include <vector>

namespace instances {
using Rational = mpq_class;
using Complex = std::complex<double>;
using Space = checker::Vector3<Rational>; // a point or a vector
using RationalCameras = checker::CameraCoordinates<Rational>;
using ComplexCameras = checker::CameraCoordinates<Complex>;

/// Reproducible integers from -bound to bound.
struct Random {
    std::mt19937_64 engine{7};
    int operator()(int bound) { return std::uniform_int_distribution<int>(-bound, bound)(engine); }
};

/// The class of the Chicago problem, 2*Pa/Pa/Pa + P/P/P.
inline constexpr std::size_t chicago = 2394;

/// The first minimal class that has all of these features.
std::size_t class_with(std::initializer_list<std::size_t> wanted);

/// Classes that together have all the features of minimal problems.
const std::vector<std::size_t>& all_kinds();

/// Cameras, and a scene: points, each with a second point on each pin; of a free line two points.
struct Instance {
    RationalCameras cameras{};
    std::vector<std::size_t> features{};
    std::vector<std::vector<Space>> points{};
};

/// The centre of a view: 0, 1 or 2.
Space centre_of(const RationalCameras& cameras, std::size_t view);

/// A vector turned by the rotation of a view, scaled by the norm of its quaternion.
Space turned(const RationalCameras& cameras, std::size_t view, const Space& vector);

/// The image of a point, by the formula of section 2, which knows nothing of derivatives.
Space image_of(const RationalCameras& cameras, std::size_t view, const Space& point);

/// Coprime integers in the same proportions; zeros for zeros.
std::array<mpz_class, 3> coprime(const Space& vector);

/// An instance of a class in general position: nothing in it is degenerate, no image too long.
Instance good_instance(std::size_t number, std::uint64_t seed = 7);

/// The instance's images, as the lines of a record.
std::string image_lines(const Instance& instance);

/// The same images as a system of equations. Throws Refused if one is zero.
checker::CameraSystem system_of(const Instance& instance);

/// A record of the images, without solutions.
std::string record(std::size_t number, const Instance& instance);

ComplexCameras approximate(const RationalCameras& exact);

/// The line of a solution, real or one of a pair, with 50 bits behind the point.
std::string solution_line(const ComplexCameras& cameras, bool real);

/// A record of the Chicago problem: its instance, its head and images, its true cameras.
const Instance& example();
const std::string& example_images();
std::string example_solution();

/// Zeros of the camera equations, degenerate ones too: where Newton's method leads from random
/// points.
std::vector<ComplexCameras> hunt(const checker::CameraSystem& system, std::size_t tries);

/// What these records prove.
checker::DegreeFile replayed(const std::string& records);

/// Why the only record of a file is refused, with the line.
std::string refusal(const std::string& records);

/// Why a file of these records does not conform, with the line.
std::string violation(const std::string& records);
} // namespace instances
