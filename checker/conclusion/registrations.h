// Upper bounds of the degrees of extensions of the five-point problem (FORMAT.md, section 10),
// which the models of registrations prove.
#pragma once

#include "checker/conclusion/findings.h"

namespace checker {
/// Of the relative pose, and of the types of the classes that are `minimal`: bounds of the models
/// whose files count.
RegistrationBounds registration_bounds(const Findings& findings, const Classification& classes,
                                       const std::vector<bool>& minimal);

/// The files that count and bound the solutions of a type, or of the relative pose.
std::vector<std::size_t> files_on(const Findings& findings, const Registration& type);
} // namespace checker
