// Scenes at which all cubic forms of resection.h vanish, whatever the images show: a camera of rank
// 1 or 2 sees them as any image shows them (proofs/fixed_forms.md).
#pragma once

#include "checker/general_bounds/small_field.h"
#include "checker/general_degrees/scene_system.h"

namespace checker {
/// The scenes where only some depths are not 0: a camera [0 | t] sees them.
struct FewDepths {
    std::vector<std::size_t> depths{};
    std::size_t order = 1; // to which the cubic forms vanish there, at least
};

/// The scenes in which some lines meet one and the same line in space, the *axis*: a camera of rank
/// 2 that projects from the axis sees them. The cubic forms vanish there.
struct Pencil {
    std::vector<std::size_t> places{}; // on the axis: at most two
    std::vector<std::size_t> lines{};  // that meet the axis, but have no point on it
};

/// Scenes D and directions D' of curves D + D' z + ... in which all cubic forms vanish to order 2:
/// near a scene of few depths, at a point of a line with three points, cameras project all else to
/// this line.
struct Tangent {
    std::size_t line = 0;               // with three points; all other points are one at most
    std::size_t point = 0;              // on it
    std::optional<std::size_t> other{}; // point
};

struct BaseScenes {
    std::vector<FewDepths> few_depths{};
    std::vector<Pencil> pencils{};
    std::vector<Tangent> tangents{};

    std::size_t size() const { return few_depths.size() + pencils.size() + tangents.size(); }
};

BaseScenes base_scenes(const Problem& problem, const SceneSystem& system);

/// The own depths of such a scene. Throws Refused where view 1 shows so special images that no
/// depth makes a line meet the axis.
SmallRow choose_scene(const SceneSystem& system, const Pencil& pencil, Choices& choices);
SmallRow choose_scene(const SceneSystem& system, const FewDepths& few, Choices& choices);

/// The own depths of such a scene, and the direction. Throws Refused as well.
std::array<SmallRow, 2> choose_tangent(const Problem& problem, const SceneSystem& system,
                                       const Tangent& tangent, Choices& choices);
} // namespace checker
