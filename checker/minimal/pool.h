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

/// What an instance of a feature contributes to J: its rows of J, and what is left when its own
/// unknowns are eliminated.
struct Contribution {
    std::size_t unknowns = 0;
    Rows<mpz_class> rows{}; // of J: own columns, then those of the cameras
    /// Of the motions of the cameras with which the feature can move along; none if its own columns
    /// are dependent modulo q, and the block has factor 0.
    Rows<mpz_class> conditions{};
    Block block{};
};

inline Contribution contribution_of(std::size_t unknowns, Rows<mpz_class> rows) {
    Block block = eliminate(unknowns, modulo_q(rows));
    Rows<mpz_class> conditions = conditions_on_cameras(unknowns, rows);
    return {unknowns, std::move(rows), std::move(conditions), std::move(block)};
}

/// The rows of J of a feature in this number of views. Throws Refused if they violate section 2.
inline Jacobian<mpz_class> rows_of(const Feature& feature, unsigned views,
                                   const Placement& placement) {
    const Problem problem = problem_of(feature, views);
    require_section_2(problem, placement);
    return jacobian<mpz_class>(problem, placement);
}
} // namespace checker
