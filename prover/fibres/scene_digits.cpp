#include "prover/fibres/scene_digits.h"

#include "prover/fibres/exact_solutions.h"
#include "prover/fibres/scenes_over.h"

#include <algorithm>

namespace plprove {

std::vector<model::BigComplex> SceneDigits::values(const Point& point,
                                                   const model::ManyDigits& digits) const {
    return ScenesOver(digits, scene_, point).values();
}

std::vector<std::vector<model::BigComplex>>
SceneDigits::slopes(const Point& point, const model::ManyDigits& digits) const {
    return ScenesOver(digits, scene_, point).gradients();
}

bool SceneDigits::is_degenerate(const Point& solution, const model::ManyDigits& digits) const {
    const auto vanishes = [&](const model::BigComplex& x) { return is_small(x, digits.bits); };
    return std::ranges::any_of(
        ScenesOver(digits, scene_, solution).conditions(),
        [&](const auto& group) { return std::ranges::all_of(group, vanishes); });
}

} // namespace plprove
