// Where features may have common points at the boundary of the space M of cameras: the strata and
// the table of Lemma R7 of proofs/relations.md, and whether features avoid a stratum.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace proofs {

/// A number for each space of a stratum: its dimension, or how many conditions there are on it. The
/// spaces are the image of the stratum, v', and others, as in Lemma R7.
using OnSpaces = std::array<unsigned, 5>;

/// One of the ways in which data of a feature meet conditions: an entry of Lemma R7. `Pa/a/P` and
/// `Pa/P/a` stand there for `P/a/Pa` and `P/Pa/a`, which have the same constraint.
struct Way {
    std::string_view feature;
    OnSpaces conditions; // at least so many, on each space
};

/// In A_2 and A_3: on the image, v', f_2 and f_3. The fifth space is not used.
inline constexpr std::array<Way, 19> ways_in_both{{
    {"P/a/a", {1, 0, 0, 0, 0}},    {"P/a/a", {1, 1, 0, 0, 0}},   {"P/-/P", {1, 0, 0, 1, 0}},
    {"P/-/P", {1, 1, 0, 0, 0}},    {"P/P/-", {1, 0, 1, 0, 0}},   {"P/P/-", {1, 1, 0, 0, 0}},
    {"P/a/Pa", {2, 0, 0, 1, 0}},   {"P/a/Pa", {1, 1, 0, 0, 0}},  {"P/Pa/a", {2, 0, 1, 0, 0}},
    {"P/Pa/a", {1, 1, 0, 0, 0}},   {"P/P/P", {3, 0, 1, 1, 0}},   {"P/P/P", {1, 1, 0, 0, 0}},
    {"a/a/a", {1, 0, 0, 0, 0}},    {"Pa/a/Pa", {2, 0, 0, 1, 0}}, {"Pa/a/Pa", {2, 1, 0, 0, 0}},
    {"Pa/Pa/a", {2, 0, 1, 0, 0}},  {"Pa/Pa/a", {2, 1, 0, 0, 0}}, {"Pa/Pa/Pa", {3, 0, 1, 1, 0}},
    {"Pa/Pa/Pa", {2, 1, 0, 0, 0}},
}};

/// In the kinds (iii) and (iv): on the image, v', u_2, (u_3, p_3, f_3) and f_3.
inline constexpr std::array<Way, 23> ways_in_one{{
    {"P/a/a", {1, 0, 0, 1, 0}},    {"P/a/a", {1, 0, 1, 0, 0}},    {"P/a/a", {1, 1, 0, 0, 0}},
    {"P/-/P", {1, 0, 0, 1, 1}},    {"P/-/P", {1, 1, 0, 0, 0}},    {"P/P/-", {1, 0, 0, 0, 0}},
    {"P/a/Pa", {2, 0, 0, 2, 1}},   {"P/a/Pa", {2, 0, 1, 1, 1}},   {"P/a/Pa", {1, 1, 0, 0, 0}},
    {"P/Pa/a", {2, 0, 0, 1, 0}},   {"P/Pa/a", {2, 1, 0, 0, 0}},   {"P/P/P", {3, 0, 0, 2, 1}},
    {"P/P/P", {2, 1, 0, 0, 0}},    {"a/a/a", {1, 0, 0, 1, 0}},    {"a/a/a", {1, 0, 1, 0, 0}},
    {"a/a/a", {2, 2, 0, 0, 0}},    {"Pa/a/Pa", {2, 0, 0, 2, 1}},  {"Pa/a/Pa", {2, 0, 1, 1, 1}},
    {"Pa/a/Pa", {2, 1, 0, 0, 0}},  {"Pa/Pa/a", {2, 0, 0, 1, 0}},  {"Pa/Pa/a", {3, 1, 0, 0, 0}},
    {"Pa/Pa/Pa", {3, 0, 0, 2, 1}}, {"Pa/Pa/Pa", {3, 1, 0, 0, 0}},
}};

/// A stratum, by its kind in Lemma R5. Those of A_3 only arise from (iii) and (iv) by exchanging
/// the views 2 and 3.
struct Stratum {
    std::string_view name;
    OnSpaces dimensions;
    std::span<const Way> ways;
};

inline constexpr std::array<Stratum, 4> boundary_strata{{
    {"i", {7, 1, 2, 2, 0}, ways_in_both},
    {"ii", {6, 2, 1, 1, 0}, ways_in_both},
    {"iii", {7, 1, 1, 3, 2}, ways_in_one},
    {"iv", {7, 2, 1, 2, 1}, ways_in_one},
}};

/// Whether each of the features can take one of these ways, so that the conditions on each space
/// add up to at most its dimension.
inline bool can_meet(std::span<const Way> ways, std::span<const std::string_view> features,
                     const OnSpaces& dimensions) {
    if (features.empty()) return true;
    for (const Way& way : ways) {
        if (way.feature != features.front()) continue;
        OnSpaces rest = dimensions;
        bool fits = true;
        for (std::size_t i = 0; i < rest.size(); ++i) {
            fits = fits && way.conditions[i] <= rest[i];
            rest[i] -= way.conditions[i];
        }
        if (fits && can_meet(ways, features.subspan(1), rest)) return true;
    }
    return false;
}

/// The strata in which generic data of these features may have common points.
inline std::vector<std::string_view> strata_in_the_way(std::span<const std::string_view> features) {
    std::vector<std::string_view> found;
    for (const Stratum& stratum : boundary_strata)
        if (can_meet(stratum.ways, features, stratum.dimensions)) found.push_back(stratum.name);
    return found;
}

} // namespace proofs
