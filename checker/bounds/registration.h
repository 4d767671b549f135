// What is left of a problem when the relative pose of two views is known: to register the third
// camera (FORMAT.md, section 10).
#pragma once

#include "checker/bounds/bounds_file.h"
#include "checker/minimal/obstruction.h"

#include <optional>

namespace checker {
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
