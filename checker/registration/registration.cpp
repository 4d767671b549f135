#include "checker/registration/registration.h"

namespace checker {
/// What the third view sees of a feature, and what is known of this from the pair: a row of the
/// table of section 10.
struct Look {
    bool point = false;       // the third view sees the point
    bool located = false;     // the pair determines the point
    Views seen_by{};          // the views of the pair that see the point
    unsigned known_lines = 0; // that the third view and both views of the pair see
    unsigned other_lines = 0; // that the third view sees
};

static Look look_at(const Feature& feature, Views pair) {
    const Views third = all_views & ~pair;
    Look look;
    look.point = (feature.point & third) != 0;
    look.seen_by = feature.point & pair;
    look.located = look.seen_by == pair;
    const Views not_seen_by = pair & ~feature.point;
    for (unsigned pin = 0; pin < feature.pins; ++pin) {
        const Views seen = feature.pin[pin];
        if (look.seen_by != 0 && (seen & not_seen_by) != 0) look.located = true;
        if ((seen & third) == 0) continue;
        if ((seen & pair) == pair)
            ++look.known_lines;
        else
            ++look.other_lines;
    }
    return look;
}

Registration registration(const Signature& signature, Views pair) {
    Registration type;
    std::array<unsigned, 4> group{}; // of rays, by the view of the pair that sees their points
    for (std::size_t i = 0; i < feature_count; ++i) {
        const unsigned count = signature[i];
        const Look look = look_at(features[i], pair);
        if (look.point && look.located)
            type.stars[look.known_lines] += count;
        else if (look.point && look.seen_by == 0)
            type.groups[1] += count;
        else if (look.point)
            group[static_cast<std::size_t>(std::countr_zero(look.seen_by))] += count;
        else if (look.known_lines > 0)
            type.lines += count;
        else if (look.other_lines > 0)
            type.incidences += count;
    }
    for (const unsigned size : group)
        if (size > 0) ++type.groups[size];
    return type;
}

std::optional<RegistrationBound> bound_by_registration(const Signature& signature,
                                                       const RegistrationBounds& bounds) {
    std::optional<RegistrationBound> best;
    const auto poses = bounds.find(relative_pose);
    if (poses == bounds.end()) return best;
    for (const Views pair : view_pairs) {
        if (shared_points(signature, pair) != 5) continue;
        const Registration type = registration(signature, pair);
        const auto left = bounds.find(type);
        if (left == bounds.end()) continue;
        const std::size_t bound = poses->second * left->second;
        if (!best || bound < best->bound) best = RegistrationBound{bound, type};
    }
    return best;
}
} // namespace checker
