// Whether the images that fit two cameras, general ones that satisfy some conditions, are
// irreducible: proofs/all_permutations.md, section 4. The two are taken infinitely near, so that a
// motion of the cameras says how they differ.
#pragma once

#include "checker/permutations/echelon.h"

namespace checker {
/// For each view the normals of two planes that contain its ray to a point.
using NormalsOfPin = std::array<std::array<ResidueVector, 2>, 3>;

/// By the planes of two views that span those through their rays to a point.
using BilinearForm = std::array<std::array<Equation, 2>, 2>;

/// Directions of a pin in three views (Lemma 3).
bool pin_is_general(const NormalsOfPin& normals, const Echelon& cameras, Drawn& drawn);

/// A line through a known point, and its direction in view u, if the two other views do not move
/// relative to each other (proofs/five_shared_points.md, Lemma P5).
bool known_pin_is_general(const std::array<ResidueVector, 2>& normals, std::size_t u,
                          const Echelon& cameras, Drawn& drawn);

/// Directions of a line in two views (Lemma 4).
bool line_is_general(const BilinearForm& form, const Echelon& cameras, Drawn& drawn);

/// Pairs of points in views i and j (Lemma 5).
bool epipolar_form_is_general(const MovingViews& views, std::size_t i, std::size_t j,
                              const Motion& motion);

/// A point in view i and lines in the two others (Lemma 6).
bool tensor_is_general(const MovingViews& views, std::size_t i, const Motion& motion, Drawn& drawn);
} // namespace checker
