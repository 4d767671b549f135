#include "checker/permutations/half_turns.h"

namespace checker {
namespace {
/// How much a view sees.
struct Sight {
    unsigned points = 0, bare_points = 0; // of these, points without a line that it sees
    unsigned lines_elsewhere = 0;         // through points that it does not see
    bool is_more = false;                 // a free line, or a line elsewhere that all views see
};

Sight sight_of(const Signature& signature, std::size_t view) {
    Sight sight;
    for (std::size_t f = 0; f < feature_count; ++f) {
        const Feature& feature = features[f];
        if (signature[f] == 0 || !has_view(feature.views, view)) continue;
        unsigned lines = 0;
        for (std::size_t pin = 0; pin < feature.pins; ++pin)
            lines += has_view(feature.pin[pin], view) ? signature[f] : 0;
        if (has_view(feature.point, view)) {
            sight.points += signature[f];
            if (lines == 0) sight.bare_points += signature[f];
        } else {
            sight.lines_elsewhere += lines;
            sight.is_more |= feature.free_line || feature.pin[0] == all_views;
        }
    }
    return sight;
}
} // namespace

std::optional<Views> views_beside_half_turns(const Signature& signature) {
    for (std::size_t view = 0; view < 3; ++view) {
        const Sight sight = sight_of(signature, view);
        if (sight.is_more) continue;
        const bool another_point =
            sight.points == 2 && sight.bare_points > 0 && sight.lines_elsewhere == 0;
        if (another_point || (sight.points == 1 && sight.lines_elsewhere == 1))
            return all_views ^ 1U << view;
    }
    return std::nullopt;
}
} // namespace checker
