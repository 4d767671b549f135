#include "checker/general_bounds/vanishing.h"

#include "checker/file/complaint.h"

namespace checker {
void try_lemmas(const Problem& problem, const SceneSystem& system, const BaseScenes& base,
                const SceneCoordinates& coordinates, const std::vector<Resection>& resections) {
    Choices choices;
    // The places' depths, after the motion that makes three own depths 0: as the forms read them.
    const auto depths = [&](const SmallRow& own) {
        return place_depths(system, coordinates.scene(coordinates.of(own)));
    };
    const auto attempt = [&](const SmallRow& scene, const SmallRow& direction, bool twice) {
        const SmallRow start = depths(scene), change = depths(direction);
        for (const Resection& resection : resections)
            if (!resection.vanish(start, change, twice))
                throw Refused("forms do not vanish as Lemmas F3 to F5 say: report this");
    };
    const auto any_direction = [&] { return choices.row(system.depths); };
    for (const FewDepths& few : base.few_depths)
        attempt(choose_scene(system, few, choices), any_direction(), few.order == 2);
    for (const Pencil& pencil : base.pencils)
        attempt(choose_scene(system, pencil, choices), any_direction(), false);
    for (const Tangent& tangent : base.tangents) {
        const auto [scene, direction] = choose_tangent(problem, system, tangent, choices);
        attempt(scene, direction, true);
    }
}
} // namespace checker
