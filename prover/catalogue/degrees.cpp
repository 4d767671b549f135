#include "prover/catalogue/degrees.h"

#include <algorithm>

namespace plprove {

std::optional<int> degree_on_file(std::size_t constraint_class) {
    const auto degrees = degrees_on_file();
    const auto found =
        std::ranges::lower_bound(degrees, constraint_class, {}, &ClassDegree::constraint_class);
    if (found == degrees.end() || found->constraint_class != constraint_class) return std::nullopt;
    return found->degree;
}

} // namespace plprove
