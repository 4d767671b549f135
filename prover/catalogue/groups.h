// The monodromy groups of minimal problems in three calibrated views that fibres certify
// (certs/groups.csv), embedded in the program at build time.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace plprove {

struct ClassGroup {
    std::size_t constraint_class = 0; ///< the number of its first member
    std::string_view group;           ///< of the solutions: `S312` for all permutations of 312
};

/// All that are known, ascending.
std::span<const ClassGroup> groups_on_file();

/// The group of the solutions of the problems in a constraint class; nothing where it is not known.
std::optional<std::string_view> group_on_file(std::size_t constraint_class);

} // namespace plprove
