// Files of upper bounds (FORMAT.md, section 10): for types of registration problems, templates,
// whose minors bound the number of solutions.
#pragma once

#include "checker/bounds/constraints.h"
#include "checker/effort/execution.h"

#include <map>

namespace checker {
/// The smallest bound of each type: how many solutions a generic problem of the type has at most.
using RegistrationBounds = std::map<Registration, std::size_t>;

/// What a file of upper bounds proves.
struct BoundsFile {
    std::size_t templates = 0; // that hold
    RegistrationBounds bounds{};
    Refusals refusals{};
};

/// Replays a file after its first line. Throws Malformed.
BoundsFile replay_bounds(Reader& reader, const Execution& execution);

/// Adds a bound, unless there is a smaller one of the type.
inline void add_bound(RegistrationBounds& bounds, const Registration& type, std::size_t bound) {
    const auto place = bounds.emplace(type, bound).first;
    place->second = std::min(place->second, bound);
}
} // namespace checker
