// From a camera map to what a kind of cameras needs of it: a kind writes its matrix once, over any
// ring.
#pragma once

#include "prover/cameras/camera_model.h"
#include "prover/geometry/dual.h"

namespace plprove {

/// The derivative of the matrix along a direction.
template <class Map, class T>
CameraMatrix<T> derivative_along(const T* numbers, const T* direction) {
    std::array<Dual<T>, Map::numbers> moving;
    for (std::size_t i = 0; i < moving.size(); ++i)
        moving[i] = {numbers[i], direction[i]};
    const CameraMatrix<Dual<T>> camera = Map::matrix(moving.data());
    CameraMatrix<T> result;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            result[i][j] = camera[i][j].slope;
    return result;
}

/// The camera of a certificate. Its unknowns are its coordinates (CameraModel::coordinates).
template <class Map, class T>
MovingCamera<T> placed_by_coordinates(const CameraModel& model, const Coordinates& numbers,
                                      bool second) {
    std::array<T, Map::numbers> values;
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = T(numbers[i]);
    MovingCamera<T> camera{Map::matrix(values.data()), {}};
    for (const int k : model.coordinates(second)) {
        std::array<T, Map::numbers> direction{};
        direction[static_cast<std::size_t>(k)] = T(1);
        camera.derivative.push_back(derivative_along<Map>(values.data(), direction.data()));
    }
    return camera;
}

/// The model with all that follows from the map: Map::matrix(const T* numbers) is the matrix, a
/// function of Map::numbers numbers over any ring T with +, - and *, where T{} is 0. A model that
/// says itself how a camera of a certificate moves keeps that.
template <class Map>
constexpr CameraModel with_map(CameraModel model) {
    static_assert(Map::numbers <= most_camera_numbers);
    using Complex = CameraModel::Complex;
    model.numbers = Map::numbers;
    model.matrix = Map::template matrix<Complex>;
    model.derivative = derivative_along<Map, Complex>;
    model.polynomials = Map::template matrix<NumberPolynomial>;
    if (model.over_integers == nullptr)
        model.over_integers = placed_by_coordinates<Map, std::int64_t>;
    if (model.modulo_q == nullptr) model.modulo_q = placed_by_coordinates<Map, Modular>;
    return model;
}

} // namespace plprove
