// What is left of a problem when the relative pose of two views is known: to register the third
// camera (FORMAT.md, section 10).
#pragma once

#include "checker/minimal/obstruction.h"

#include <compare>
#include <map>
#include <optional>

namespace checker {
/// How many constraints of each kind there are on the third camera.
struct Registration {
    std::array<unsigned, 8> stars{}; // by the number of their pins
    unsigned lines = 0;
    unsigned incidences = 0;
    std::array<unsigned, 12> groups{}; // of rays, by size
    auto operator<=>(const Registration&) const = default;
};

/// The relative pose of two views that share five points: one camera, and five rays of the other.
inline constexpr Registration relative_pose{.groups = {0, 0, 0, 0, 0, 1}};

/// How many solutions a generic problem of a type has at most.
using RegistrationBounds = std::map<Registration, std::size_t>;

/// The type of the registration that is left when the relative pose of a pair of views is known.
Registration registration(const Signature& signature, Views pair);

/// An upper bound of a degree, by the type of a registration.
struct RegistrationBound {
    std::size_t bound = 0;
    Registration type{};
};

/// The smallest bound of a minimal problem in which two views share five points, by these bounds of
/// relative poses and registrations; none if they have no such types.
std::optional<RegistrationBound> bound_by_registration(const Signature& signature,
                                                       const RegistrationBounds& bounds);
} // namespace checker
