// Pools of coordinates as a file has them (FORMAT.md, sections 2 and 5).
#pragma once

#include "checker/minimal/block.h"

namespace checker {
/// Takes the head of a pool: its number, and the cameras from the second, in two or three views.
inline std::vector<Numbers> read_cameras(Reader& reader, std::size_t pool, unsigned views) {
    if (pool > 99) reader.fail("pool", "at most 99 pools");
    reader.take(say("pool ", pool, " $"));
    std::vector<Numbers> cameras;
    for (unsigned view = 2; view <= views; ++view)
        cameras.push_back(
            reader.take(say("camera ", view, " quaternion @ @ @ @ translation @ @ @ $")));
    return cameras;
}

/// Takes the rest of a feature line: the point and the directions of its pins.
inline Numbers read_placement(Reader& reader, unsigned pins) {
    std::string pattern = "point @ @ @";
    for (unsigned pin = 0; pin < pins; ++pin)
        pattern += " pin @ @ @";
    return reader.take(pattern + " $");
}

/// The rows of J of a feature in this number of views. Throws Refused if they violate section 2.
inline Jacobian<mpz_class> rows_of(const Feature& feature, unsigned views,
                                   const Placement& placement) {
    const Problem problem = problem_of(feature, views);
    require_section_2(problem, placement);
    return jacobian<mpz_class>(problem, placement);
}
} // namespace checker
