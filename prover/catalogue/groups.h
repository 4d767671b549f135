// The monodromy groups of minimal problems in three calibrated views (certs/groups.csv), embedded
// in the program at build time: certified ones, of which fibres are committed, and others by
// evidence.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace plprove {

struct ClassGroup {
    std::size_t constraint_class = 0; ///< the number of its first member
    std::string_view name;            ///< as MonodromyGroup::name()
    std::string_view order;           ///< as MonodromyGroup::order()
    int width = 0;                    ///< as MonodromyGroup::width()
    std::string_view status;          ///< `certified` or `evidence`
};

/// All that are known, ascending.
std::span<const ClassGroup> groups_on_file();

/// The group of the solutions of the problems in a constraint class; nothing where it is not known.
std::optional<ClassGroup> group_on_file(std::size_t constraint_class);

} // namespace plprove
