// Where features may have common points at the boundary of the space M of cameras: the strata and
// the table of Lemma R7 of proofs/relations.md, whether features avoid a stratum, and how many
// common points they have where these are isolated (Proposition R14).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace proofs {

/// A number for each space of a stratum: its dimension, or how many conditions there are on it. The
/// spaces are the image of the stratum, v', and others, as in Lemma R7.
using OnSpaces = std::array<unsigned, 6>;

/// One of the ways in which data of a feature meet conditions: an entry of Lemma R7. `Pa/a/P` and
/// `Pa/P/a` stand there for `P/a/Pa` and `P/Pa/a`, which have the same constraint.
struct Way {
    std::string_view feature;
    OnSpaces conditions; // at least so many, on each space
};

/// In A_2 and A_3: on the image, v', f_2 and f_3. The other spaces are not used.
inline constexpr std::array<Way, 19> ways_in_both{{
    {"P/a/a", {1, 0, 0, 0, 0, 0}},    {"P/a/a", {1, 1, 0, 0, 0, 0}},
    {"P/-/P", {1, 0, 0, 1, 0, 0}},    {"P/-/P", {1, 1, 0, 0, 0, 0}},
    {"P/P/-", {1, 0, 1, 0, 0, 0}},    {"P/P/-", {1, 1, 0, 0, 0, 0}},
    {"P/a/Pa", {2, 0, 0, 1, 0, 0}},   {"P/a/Pa", {1, 1, 0, 0, 0, 0}},
    {"P/Pa/a", {2, 0, 1, 0, 0, 0}},   {"P/Pa/a", {1, 1, 0, 0, 0, 0}},
    {"P/P/P", {3, 0, 1, 1, 0, 0}},    {"P/P/P", {1, 1, 0, 0, 0, 0}},
    {"a/a/a", {1, 0, 0, 0, 0, 0}},    {"Pa/a/Pa", {2, 0, 0, 1, 0, 0}},
    {"Pa/a/Pa", {2, 1, 0, 0, 0, 0}},  {"Pa/Pa/a", {2, 0, 1, 0, 0, 0}},
    {"Pa/Pa/a", {2, 1, 0, 0, 0, 0}},  {"Pa/Pa/Pa", {3, 0, 1, 1, 0, 0}},
    {"Pa/Pa/Pa", {2, 1, 0, 0, 0, 0}},
}};

/// In the kinds (iii) and (iv): on the image, v', u_2, (u_3, p_3, f_3), f_3 and p_3.
inline constexpr std::array<Way, 23> ways_in_one{{
    {"P/a/a", {1, 0, 0, 1, 0, 1}},    {"P/a/a", {1, 0, 1, 0, 0, 0}},
    {"P/a/a", {1, 1, 0, 0, 0, 0}},    {"P/-/P", {1, 0, 0, 1, 1, 0}},
    {"P/-/P", {1, 1, 0, 0, 0, 0}},    {"P/P/-", {1, 0, 0, 0, 0, 0}},
    {"P/a/Pa", {2, 0, 0, 2, 1, 2}},   {"P/a/Pa", {2, 0, 1, 1, 1, 0}},
    {"P/a/Pa", {1, 1, 0, 0, 0, 0}},   {"P/Pa/a", {2, 0, 0, 1, 0, 1}},
    {"P/Pa/a", {2, 1, 0, 0, 0, 0}},   {"P/P/P", {3, 0, 0, 2, 1, 2}},
    {"P/P/P", {2, 1, 0, 0, 0, 0}},    {"a/a/a", {1, 0, 0, 1, 0, 1}},
    {"a/a/a", {2, 0, 1, 0, 0, 0}},    {"a/a/a", {2, 2, 0, 0, 0, 0}},
    {"Pa/a/Pa", {2, 0, 0, 2, 1, 2}},  {"Pa/a/Pa", {3, 0, 1, 1, 1, 0}},
    {"Pa/a/Pa", {2, 1, 0, 0, 0, 0}},  {"Pa/Pa/a", {2, 0, 0, 1, 0, 1}},
    {"Pa/Pa/a", {3, 1, 0, 0, 0, 0}},  {"Pa/Pa/Pa", {3, 0, 0, 2, 1, 2}},
    {"Pa/Pa/Pa", {3, 1, 0, 0, 0, 0}},
}};

/// A stratum, by its kind in Lemma R5. Those of A_3 only arise from (iii) and (iv) by exchanging
/// the views 2 and 3.
struct Stratum {
    std::string_view name;
    OnSpaces dimensions;
    std::span<const Way> ways;
};

inline constexpr std::array<Stratum, 4> boundary_strata{{
    {"i", {7, 1, 2, 2, 0, 0}, ways_in_both},
    {"ii", {6, 2, 1, 1, 0, 0}, ways_in_both},
    {"iii", {7, 1, 1, 3, 2, 2}, ways_in_one},
    {"iv", {7, 2, 1, 2, 1, 2}, ways_in_one},
}};

/// A choice of a way for each of some features. Data of them may have common points where the
/// conditions on each space add up to at most its dimension.
struct Meeting {
    std::vector<Way> ways;
    OnSpaces conditions{}; // of all ways together
};

/// All choices whose conditions are at most these dimensions.
inline std::vector<Meeting> meetings(const Stratum& stratum,
                                     std::span<const std::string_view> features) {
    std::vector<Meeting> found{{}};
    for (const std::string_view feature : features) {
        std::vector<Meeting> longer;
        for (const Meeting& meeting : found) {
            for (const Way& way : stratum.ways) {
                if (way.feature != feature) continue;
                Meeting next = meeting;
                next.ways.push_back(way);
                bool fits = true;
                for (std::size_t i = 0; i < way.conditions.size(); ++i) {
                    next.conditions[i] += way.conditions[i];
                    fits = fits && next.conditions[i] <= stratum.dimensions[i];
                }
                if (fits) longer.push_back(next);
            }
        }
        found = longer;
    }
    return found;
}

/// The strata in which generic data of these features may have common points.
inline std::vector<std::string_view> strata_in_the_way(std::span<const std::string_view> features) {
    std::vector<std::string_view> found;
    for (const Stratum& stratum : boundary_strata)
        if (!meetings(stratum, features).empty()) found.push_back(stratum.name);
    return found;
}

/// How many common points a choice has in the stratum (ii), if its conditions are 6: the first
/// table of Proposition R14.
inline unsigned points_in_ii(const Meeting& meeting) {
    if (meeting.conditions[1] != 2) return 0;
    const unsigned of_x_and_y = meeting.conditions[2] + meeting.conditions[3];
    if (of_x_and_y == 0) return 40;
    return of_x_and_y == 1 ? 16 : 8;
}

/// Likewise in the stratum (iv), if its conditions are 7: the second table.
inline unsigned points_in_iv(const Meeting& meeting) {
    if (meeting.conditions[1] != 2 || meeting.conditions[3] != 2) return 0;
    for (const Way& way : meeting.ways) {
        const bool has_line = way.feature == "a/a/a" || way.feature.starts_with("Pa");
        if (way.conditions[1] != 0 && has_line) return 0; // not counted
        if (way.conditions[2] != 0 && way.feature != "P/a/a") return 0;
    }
    return meeting.conditions[2] == 1 ? 8 : 16;
}

/// At least how many common points generic data have in two strata.
struct IsolatedPoints {
    unsigned in_ii = 0, in_iv = 0;
};

/// These numbers, if the common points are isolated on the blow-up in (i): the features avoid (iii)
/// and meet as many conditions as the image has dimensions in (i), (ii) and (iv). None if they do
/// not.
inline std::optional<IsolatedPoints> isolated_points(std::span<const std::string_view> features) {
    IsolatedPoints points;
    for (const Stratum& stratum : boundary_strata) {
        for (const Meeting& meeting : meetings(stratum, features)) {
            const bool isolated = meeting.conditions[0] == stratum.dimensions[0];
            if (!isolated || stratum.name == "iii") return std::nullopt;
            if (stratum.name == "ii") points.in_ii += points_in_ii(meeting);
            if (stratum.name == "iv") points.in_iv += points_in_iv(meeting);
        }
    }
    return points;
}

} // namespace proofs
