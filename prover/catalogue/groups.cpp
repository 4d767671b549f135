#include "prover/catalogue/groups.h"

#include <algorithm>

namespace plprove {

std::optional<GroupOnFile> group_on_file(std::size_t constraint_class) {
    const auto groups = groups_on_file();
    const auto found =
        std::ranges::lower_bound(groups, constraint_class, {}, &ClassGroup::constraint_class);
    if (found == groups.end() || found->constraint_class != constraint_class) return std::nullopt;
    return found->group;
}

std::optional<GroupOnFile> family_group_on_file(std::string_view problem) {
    const auto groups = family_groups_on_file();
    const auto found = std::ranges::find(groups, problem, &FamilyGroup::problem);
    if (found == groups.end()) return std::nullopt;
    return found->group;
}

} // namespace plprove
