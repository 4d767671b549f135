// The models of registrations (FORMAT.md, section 10): each type is the model of one text.
#pragma once

#include "checker/registration/registration.h"

#include <string>

namespace checker {
/// The name of the model of a type, which says the type.
std::string name_of(const Registration& type);

/// The text of the model. The type has a weight of six conditions, or is the relative pose.
std::string model_of(const Registration& type);
} // namespace checker
