// The conditions under which a zero of the camera equations is a solution (FORMAT.md, section 9):
// proved for whole boxes, in ball arithmetic, by numbers that are not zero.
#pragma once

#include "checker/degrees/evaluation.h"

namespace checker {
/// Whether a number is proved not to be zero; a set of numbers, whether none of them is.
template <class T> bool nonzero(const T& x) {
    return x != T(0);
}

template <class T> bool nonzero(const Vector3<T>& x) {
    return nonzero(x[0]) || nonzero(x[1]) || nonzero(x[2]);
}

/// Whether a ray is proved to meet a plane in one point; both by their places in the system's list.
template <class T> bool meets(const BackProjections<T>& space, std::size_t ray, std::size_t plane) {
    return nonzero(dot(space.vectors[ray].vector, space.vectors[plane].vector));
}

/// Which condition on a feature's point and lines is not proved; empty if all are.
template <class T>
std::string_view degeneracy(const CameraSystem& system, const Triangulation& feature,
                            const BackProjections<T>& space) {
    const auto& [ray, plane, seen, lines] = feature;
    if (!meets(space, ray, plane)) return "a ray is parallel to the plane that it should meet";
    const Vector3<T>& direction = space.vectors[ray].vector;
    const Vector3<T>& normal = space.vectors[plane].vector;
    const Vector3<T>& start = space.centres[system.vectors[ray].view];
    const Vector3<T>& other = space.centres[system.vectors[plane].view];
    const T scale = dot(normal, direction);
    const T along = dot(normal, minus(other, start));
    for (std::size_t view = 0; view < 3; ++view) {
        // The point X less the centre c of the view, scaled.
        const Vector3<T> from_centre =
            plus(times(scale, minus(start, space.centres[view])), times(along, direction));
        if (has_view(seen, view) && !nonzero(from_centre))
            return "a point is the centre of a view of it";
        for (const SeenLine& line : lines) {
            if (!has_view(line.views, view)) continue;
            const Vector3<T> line_direction =
                cross(space.vectors[line.first].vector, space.vectors[line.second].vector);
            if (!nonzero(cross(from_centre, line_direction)))
                return "a line has no direction, or meets the centre of a view of it";
        }
    }
    return {};
}

/// Which condition of section 9 is not proved; empty if all are.
template <class T>
std::string_view degeneracy(const CameraSystem& system, const CameraCoordinates<T>& c,
                            const BackProjections<T>& space) {
    for (const T* q : {&c[0], &c[3]}) {
        const T norm = T(1) + q[0] * q[0] + q[1] * q[1] + q[2] * q[2];
        if (!nonzero(norm)) return "the norm of a quaternion is zero";
    }
    for (const auto& [kind, vectors] : system.equations) {
        if (kind != Kind::incidence) continue;
        const auto& [ray, first, second] = vectors;
        if (!meets(space, ray, first) || !meets(space, ray, second))
            return "a ray is parallel to a plane of its incidence";
    }
    for (const Triangulation& feature : system.triangulations) {
        const std::string_view reason = degeneracy(system, feature, space);
        if (!reason.empty()) return reason;
    }
    return {};
}
} // namespace checker
