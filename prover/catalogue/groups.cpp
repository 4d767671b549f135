#include "prover/catalogue/groups.h"

#include <algorithm>

namespace plprove {

std::optional<ClassGroup> group_on_file(std::size_t constraint_class) {
    const auto groups = groups_on_file();
    const auto found =
        std::ranges::lower_bound(groups, constraint_class, {}, &ClassGroup::constraint_class);
    if (found == groups.end() || found->constraint_class != constraint_class) return std::nullopt;
    return *found;
}

} // namespace plprove
