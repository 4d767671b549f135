// Lines of the scene: the classes of the conditions that views see them where the images say.
#pragma once

#include "checker/exactly/fixed_points.h"
#include "checker/exactly/polynomial.h"
#include "checker/problem/features.h"

namespace checker::exactly {
/// The factor of a pin through a point X, in the class of X: a line that the views in `line` see,
/// while those in `point` see X.
inline Polynomial pin_seen(const FixedPoint& at, Views line, Views point) {
    Polynomial f{{Residue{1}}};
    for (std::size_t view = 0; view < 3; ++view)
        if (has_view(line & ~point, view)) f = f * Polynomial{{at.h[view], -Residue{1}}};
    if (line != all_views) return f;
    Residue rest;
    for (const Residue h : at.h)
        rest = rest + h;
    for (const Residue root : at.x)
        rest = rest - root;
    return f * Polynomial{{rest, Residue{1}}};
}

/// The class of a free line that all views see: c_1^2 - c_2 of L_1 + L_2 + L_3 - V, less the F_v.
inline Residue class_of_free_line(const FixedPoint& at) {
    Residue c1, c2;
    for (const Residue h : at.h) {
        c2 = c2 + c1 * h;
        c1 = c1 + h;
    }
    for (const Residue x : at.x) {
        c1 = c1 - x;
        c2 = c2 - c1 * x;
    }
    Residue result = c1 * c1 - c2;
    for (std::size_t view = 0; view < 3; ++view)
        result = result - at.line_through_kappa(view);
    return result;
}
} // namespace checker::exactly
