// From a camera map to what a kind of cameras needs of it: a kind writes its matrix once, over any
// ring.
#pragma once

#include "prover/cameras/camera_model.h"
#include "prover/geometry/dual.h"

namespace plprove {

/// An integer other than 0 in a ring of those that a map is a function over.
template <class T>
T in_ring(int integer) {
    if constexpr (requires { T::constant(integer); })
        return T::constant(integer);
    else
        return T(integer);
}

/// The derivative of the matrix along a direction.
template <class Map, class T>
CameraMatrix<T> derivative_along(const T* numbers, const T* direction) {
    std::array<Dual<T>, Map::numbers + Map::shared> moving;
    for (std::size_t i = 0; i < moving.size(); ++i)
        moving[i] = {numbers[i], direction[i]};
    const CameraMatrix<Dual<T>> camera = Map::matrix(moving.data());
    CameraMatrix<T> result;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            result[i][j] = camera[i][j].slope;
    return result;
}

/// The camera of a certificate. Its unknowns are its coordinates (CameraModel::coordinates), and
/// all shared numbers.
template <class Map, class T>
MovingCamera<T> placed_by_coordinates(const CameraModel& model, const Coordinates& numbers,
                                      bool second) {
    constexpr std::size_t size = Map::numbers + Map::shared;
    std::array<T, size> values;
    for (std::size_t i = 0; i < size; ++i)
        values[i] = T(numbers[i]);
    const auto derivative_by = [&](std::size_t k) {
        std::array<T, size> direction{};
        direction[k] = T(1);
        return derivative_along<Map>(values.data(), direction.data());
    };
    MovingCamera<T> camera{Map::matrix(values.data()), {}, {}};
    for (const int k : model.coordinates(second))
        camera.derivative.push_back(derivative_by(static_cast<std::size_t>(k)));
    for (std::size_t k = Map::numbers; k < size; ++k)
        camera.by_shared.push_back(derivative_by(k));
    return camera;
}

/// The model with all that follows from the map: Map::matrix(const T* numbers) is the matrix, a
/// function of Map::numbers numbers of the camera and then of Map::shared shared ones, over any
/// ring T with +, - and *, where T{} is 0. How a camera of a certificate moves, the map may say
/// itself (Map::placed).
template <class Map>
constexpr CameraModel with_map(CameraModel model) {
    static_assert(Map::numbers + Map::shared <= most_camera_numbers);
    using Complex = CameraModel::Complex;
    model.numbers = Map::numbers;
    model.shared = Map::shared;
    model.matrix = Map::template matrix<Complex>;
    model.derivative = derivative_along<Map, Complex>;
    model.polynomials = Map::template matrix<NumberPolynomial>;
    if constexpr (requires { Map::template placed<Modular>; }) {
        model.over_integers = Map::template placed<std::int64_t>;
        model.modulo_q = Map::template placed<Modular>;
    } else {
        model.over_integers = placed_by_coordinates<Map, std::int64_t>;
        model.modulo_q = placed_by_coordinates<Map, Modular>;
    }
    return model;
}

} // namespace plprove
