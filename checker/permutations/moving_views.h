// Three views at a place modulo q, and how the equations of images change when the views move
// (proofs/all_permutations.md, section 5).
#pragma once

#include "checker/algebra/modular.h"
#include "checker/algebra/vector3.h"

#include <cstddef>

namespace checker {
using ResidueVector = Vector3<Residue>;

/// By how views 2 and 3 turn, three numbers each, and then by how their centres move. View 1 rests.
/// A motion, or the derivatives of an equation.
using Motion = std::array<Residue, 12>;

/// How a motion turns a view.
ResidueVector turn_of(std::size_t view, const Motion& motion);

/// A ray or the normal of a plane, in space, that an image fixes in a view: it turns with it.
struct Seen {
    std::size_t view = 0;
    ResidueVector vector{};
};

/// The left side of an equation, which is 0 if the images fit the views.
struct Equation {
    Residue value{};
    Motion derivatives{};

    Residue along(const Motion& motion) const;
};

/// Numbers that look random: any will do, if they are not special. The same on every run.
class Drawn {
public:
    Residue number();
    ResidueVector vector();
    /// The normal of a plane that contains the direction.
    ResidueVector normal_to(const ResidueVector& direction);

private:
    std::uint64_t state_ = 1;
};

/// The centres of the views. As images have any coordinates, their directions do not matter.
class MovingViews {
public:
    explicit MovingViews(Drawn& drawn);

    ResidueVector from(std::size_t view, const ResidueVector& point) const {
        return minus(point, centres_[view]);
    }
    Seen ray(std::size_t view, const ResidueVector& point) const {
        return {view, from(view, point)};
    }
    /// A plane of the view that contains the point.
    Seen plane(Drawn& drawn, std::size_t view, const ResidueVector& point) const {
        return {view, drawn.normal_to(from(view, point))};
    }
    /// The normals of the planes, by view, of a line through the point.
    std::array<ResidueVector, 3> planes(Drawn& drawn, const ResidueVector& point) const;
    ResidueVector baseline(std::size_t first, std::size_t second) const {
        return minus(centres_[second], centres_[first]);
    }

    /// Two rays meet.
    Equation epipolar(const Seen& ray, const Seen& other) const;

    /// A ray and two planes have a point in common.
    Equation incidence(const Seen& ray, const Seen& plane, const Seen& other) const;

    /// The normals of planes of the views 1, 2, 3 are dependent.
    static Equation pencil(const std::array<ResidueVector, 3>& normals);

    /// Vanish for the motions that keep the relative pose of two views, up to scale.
    std::array<Motion, 6> relative_pose(std::size_t first, std::size_t second) const;

private:
    std::array<ResidueVector, 3> centres_{};
};
} // namespace checker
