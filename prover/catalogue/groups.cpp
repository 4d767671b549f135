#include "prover/catalogue/groups.h"

#include <algorithm>

namespace plprove {

std::optional<std::string_view> group_on_file(std::size_t constraint_class) {
    const auto groups = groups_on_file();
    const auto found = std::ranges::find(groups, constraint_class, &ClassGroup::constraint_class);
    if (found == groups.end()) return std::nullopt;
    return found->group;
}

} // namespace plprove
