// The monodromy groups of minimal problems that are on file, embedded in the program at build time:
// in three calibrated views (certs/groups.csv), and of families (certs/family-groups.csv).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace plprove {

struct GroupOnFile {
    std::string_view name;   ///< as MonodromyGroup::name()
    std::string_view order;  ///< as MonodromyGroup::order()
    int width = 0;           ///< as MonodromyGroup::width()
    std::string_view status; ///< `certified` or `evidence`
};

/// A line of the first file.
struct ClassGroup {
    std::size_t constraint_class = 0; ///< the number of its first member
    GroupOnFile group;
};

/// A line of the second.
struct FamilyGroup {
    std::string_view problem; ///< in notation
    GroupOnFile group;
};

/// All that are known, ascending.
std::span<const ClassGroup> groups_on_file();

/// The same of families, as in certs/family-degrees.csv. Those in three calibrated views are among
/// the classes.
std::span<const FamilyGroup> family_groups_on_file();

/// The group of the solutions of the problems in a constraint class; nothing where it is not known.
std::optional<GroupOnFile> group_on_file(std::size_t constraint_class);

/// The same of a problem of a family, in notation.
std::optional<GroupOnFile> family_group_on_file(std::string_view problem);

} // namespace plprove
