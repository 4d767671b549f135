#include "prover/three_views/images.h"

#include "prover/geometry/quaternion.h"

#include <algorithm>

namespace plprove {

namespace {

Complex3 combine(const Complex3& a, const Complex3& b, const Complex& factor) {
    return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

Complex3 difference(const Complex3& a, const Complex3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

} // namespace

Complex3 cross(const Complex3& a, const Complex3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Complex3 unit(const Complex3& a) {
    double square = 0;
    for (const Complex& x : a)
        square += x.real() * x.real() + x.imag() * x.imag();
    const double scale = 1 / std::sqrt(square);
    return {a[0] * scale, a[1] * scale, a[2] * scale};
}

Complex3 rotate(const std::array<Complex, 4>& quaternion, const Complex3& x) {
    const auto r = quaternion_matrix(quaternion);
    Complex3 result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = r[i][0] * x[0] + r[i][1] * x[1] + r[i][2] * x[2];
    return result;
}

Complex3 rotate_back(const std::array<Complex, 4>& quaternion, const Complex3& x) {
    const auto r = quaternion_matrix(quaternion);
    Complex3 result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = r[0][i] * x[0] + r[1][i] * x[1] + r[2][i] * x[2];
    return result;
}

Images images_of_scene(const CameraSystem& system, const QuaternionCameras& cameras, Random& random,
                       Field field) {
    std::vector<Complex3> points;
    std::vector<std::vector<Complex3>> directions;
    for (const Feature& feature : system.features) {
        points.push_back(random.vector(field));
        directions.emplace_back();
        for (int line = 0; line < feature.lines; ++line)
            directions.back().push_back(random.vector(field));
    }
    Images images;
    for (const FreeVector& free : system.free) {
        const auto f = static_cast<std::size_t>(free.feature);
        Complex3 x = points[f], d{};
        if (free.line >= 0) d = directions[f][static_cast<std::size_t>(free.line)];
        if (free.view > 0) {
            const auto v = static_cast<std::size_t>(free.view) - 1;
            x = rotate(cameras.quaternion[v], difference(x, cameras.centre[v]));
            d = rotate(cameras.quaternion[v], d);
        }
        if (free.line < 0)
            images.push_back(unit(x));
        else
            images.push_back(unit(free.toward ? combine(d, x, random.number(field)) : cross(x, d)));
    }
    return images;
}

namespace {

Images displaced(const Images& images, double radius, Random& random, Field field) {
    Images result;
    for (const Complex3& x : images)
        result.push_back(combine(x, unit(random.vector(field)), radius));
    return result;
}

} // namespace

Images random_neighbour(const Images& images, Random& random, Field field) {
    return displaced(images, 0.8, random, field);
}

Images detour_midpoint(const Images& from, const Images& to, Random& random) {
    Images middle;
    for (std::size_t i = 0; i < from.size(); ++i)
        middle.push_back(combine(from[i], difference(to[i], from[i]), 0.5));
    return displaced(middle, 0.1, random, Field::complex);
}

Images rephased(Images images, Phases phases, Random& random) {
    for (Complex3& x : images) {
        const Complex phase = phases == Phases::near_one ? random.phase() : random.any_phase();
        for (Complex& coordinate : x)
            coordinate *= phase;
    }
    return images;
}

std::vector<Complex3> random_constants(const CameraSystem& system, Random& random) {
    std::vector<Complex3> constants;
    for (int i = 0; i < system.constants; ++i)
        constants.push_back(unit(random.complex3()));
    return constants;
}

std::vector<Complex3> standard_constants(const CameraSystem& system) {
    return std::vector<Complex3>(static_cast<std::size_t>(system.constants), {1.0, 0.0, 0.0});
}

namespace {

/// The vectors that occur in an equation, ascending: the others only help to make them.
std::vector<int> occurring_vectors(const CameraSystem& system) {
    std::vector<int> result;
    for (int v = 0; v < static_cast<int>(system.vectors.size()); ++v)
        for (const CameraEquation& equation : system.equations)
            if (std::ranges::count(equation.vectors, v) > 0) {
                result.push_back(v);
                break;
            }
    return result;
}

void put(double* out, const Complex& z) {
    out[0] = z.real();
    out[1] = z.imag();
}

} // namespace

TrackedSystem tracked_system(const CameraSystem& system, const CameraChart& chart) {
    TrackedSystem result;
    const std::vector<int> vectors = occurring_vectors(system);
    result.vectors = static_cast<int>(vectors.size());
    for (std::size_t v = 0; v < vectors.size(); ++v)
        result.views[v] = system.vectors[static_cast<std::size_t>(vectors[v])].view;
    for (std::size_t e = 0; e < system.equations.size(); ++e) {
        result.equations[e].kind = system.equations[e].kind;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto vector = std::ranges::find(vectors, system.equations[e].vectors[k]);
            if (vector == vectors.end()) continue; // the third of an epipolar equation
            const auto index = vector - vectors.begin();
            result.equations[e].vectors[k] = static_cast<int>(index);
            result.equations[e].views[k] = result.views[index];
        }
    }
    for (std::size_t v = 0; v < 2; ++v)
        for (std::size_t k = 0; k < 3; ++k)
            put(result.rotation[v][k], chart.rotation[v][k]);
    for (std::size_t k = 0; k < 5; ++k)
        put(result.centre[k], chart.centre[k]);
    return result;
}

namespace {

/// A vector whose coordinates are polynomials in time of degree at most 2.
using MovingVector = std::array<Complex3, 3>;

MovingVector straight(const Complex3& from, const Complex3& to) {
    return {from, difference(to, from), {}};
}

MovingVector cross(const MovingVector& a, const MovingVector& b) {
    MovingVector result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; i + j < 3; ++j)
            result[i + j] = combine(result[i + j], plprove::cross(a[i], b[j]), 1.0);
    return result;
}

std::vector<MovingVector> moving_vectors(const CameraSystem& system,
                                         const std::vector<Complex3>& constants, const Images& from,
                                         const Images& to) {
    std::vector<MovingVector> result;
    for (const ImageVector& vector : system.vectors) {
        const auto base = static_cast<std::size_t>(vector.base);
        const auto other = static_cast<std::size_t>(vector.other);
        switch (vector.kind) {
        case VectorKind::free:
            result.push_back(straight(from[base], to[base]));
            break;
        case VectorKind::meet:
            result.push_back(
                cross(straight(from[base], to[base]), straight(from[other], to[other])));
            break;
        case VectorKind::across:
            result.push_back(cross(result[base], straight(constants[other], constants[other])));
            break;
        }
    }
    return result;
}

} // namespace

std::vector<Complex3> image_vectors(const CameraSystem& system,
                                    const std::vector<Complex3>& constants, const Images& images) {
    std::vector<Complex3> result;
    for (const MovingVector& vector : moving_vectors(system, constants, images, images))
        result.push_back(vector[0]);
    return result;
}

TrackedImages moving_images(const CameraSystem& system, const std::vector<Complex3>& constants,
                            const Images& from, const Images& to) {
    TrackedImages result{};
    const std::vector<MovingVector> moving = moving_vectors(system, constants, from, to);
    const std::vector<int> occurring = occurring_vectors(system);
    for (std::size_t v = 0; v < occurring.size(); ++v)
        for (std::size_t power = 0; power < 3; ++power)
            for (std::size_t k = 0; k < 3; ++k)
                put(result.coefficient[v][k][power],
                    moving[static_cast<std::size_t>(occurring[v])][power][k]);
    return result;
}

} // namespace plprove
