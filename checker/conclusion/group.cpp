#include "checker/conclusion/group.h"

#include "checker/conclusion/pages_of_theorems.h"

namespace checker {
std::string group_of(const DegreeBounds& bounds) {
    if (!bounds.exact()) return {};
    const std::size_t degree = bounds.at_least;
    if (bounds.group_theorem == theorem_of_permutations) return say("S", degree);
    if (bounds.group_theorem == theorem_of_five_points) {
        const std::size_t third_cameras = degree / 20; // of each pose of two views
        return third_cameras == 1
                   ? std::string(group_of_five_points)
                   : say("<S", third_cameras, " wr ", group_of_five_points.substr(1));
    }
    return group_shown_by(bounds.cycle_types, degree, Orbits::one);
}

std::string source_of_group(const DegreeBounds& bounds) {
    if (bounds.group_theorem.empty()) return "by fibres: proofs/fibres.md";
    return say("by Theorem ", bounds.group_theorem, " of proofs/", page_of(bounds.group_theorem));
}

bool implies_group(const std::string& known, const std::string& expected) {
    if (known.empty()) return false;
    const auto degree = [](const std::string& group) {
        return group.substr(group.find_first_of("AS") + 1);
    };
    return known == expected || (known.starts_with('S') && expected.starts_with(">=A") &&
                                 degree(known) == degree(expected));
}
} // namespace checker
