// The Jacobian J of the joint camera map of a problem, at the cameras and the scene of a record
// (FORMAT.md, sections 2, 3 and 13): over the integers, or modulo q.
#pragma once

#include "checker/file/reader.h"
#include "checker/problem/problem.h"

namespace checker {
/// Where a record places cameras and scene: its numbers as written.
struct Placement {
    std::vector<Numbers> cameras{}; // from the second
    Numbers scene{};
    Numbers shared{}; // by all cameras
};

template <class T> using Rows = std::vector<std::vector<T>>;

/// The columns are those of the scene, points before lines, then what all cameras share, and then
/// those of each camera; the rows are those of the views in order, and in a view those of points
/// before those of lines.
template <class T> struct Jacobian {
    std::size_t own = 0; // columns of the scene
    Rows<T> rows{};
};

/// How many numbers place the scene.
std::size_t scene_size(const Problem& problem);

/// T is mpz_class or Residue.
template <class T> Jacobian<T> jacobian(const Problem& problem, const Placement& placement);

/// Throws Refused if a record may not place cameras so, from the second.
void require_cameras(const CameraModel& model, const std::vector<Numbers>& cameras);

/// Throws Refused if the requirements of section 2 are violated.
void require_section_2(const Problem& problem, const Placement& placement);
} // namespace checker
