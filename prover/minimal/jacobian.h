// The Jacobian of the joint camera map of a problem at a point with integer coordinates
// (certs/FORMAT.md, sections 3 and 13), over the integers or modulo q.
#pragma once

#include "prover/problem/problem.h"

namespace plprove {

/// Coordinates of cameras and scene.
struct Instance {
    /// What all cameras have in common: CameraModel::shared of them.
    Coordinates shared{};
    /// Of each camera but the first: CameraModel::numbers of them.
    std::vector<Coordinates> cameras{};
    /// Of the points in order: the coordinates of a free point, or the s of A + s (B - A), where A
    /// and B are the first two points of the line. Then of the lines in order: a point and a
    /// direction of a line without points, the direction of a line with one point.
    Coordinates scene{};
};

/// How many integers Instance::scene has.
int scene_coordinates(const Problem& problem);

/// A matrix, row by row; zero at first.
template <class T>
struct Matrix {
    int rows = 0;
    int columns = 0;
    std::vector<T> entries;

    Matrix(int row_count, int column_count)
        : rows(row_count), columns(column_count),
          entries(static_cast<std::size_t>(row_count) * static_cast<std::size_t>(column_count)) {}
    T& at(int row, int column) { return entries[static_cast<std::size_t>(row * columns + column)]; }
    const T& at(int row, int column) const {
        return entries[static_cast<std::size_t>(row * columns + column)];
    }
};

/// The Jacobian: dimension_in_views(problem) rows; dimension_in_space(problem) columns, and then
/// those of the cameras, shared ones first. Assumes the order of construction, and the number of
/// coordinates that the problem needs. T is Modular; or std::int64_t, if no entry is too large for
/// it.
template <class T>
Matrix<T> jacobian(const Problem& problem, const Instance& instance);

/// The same modulo q, for FLINT.
ResidueMatrix jacobian_modulo_q(const Problem& problem, const Instance& instance);

} // namespace plprove
