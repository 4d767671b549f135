// The models of registrations and their certificates, as they are committed.
#pragma once

#include "checker/conclusion/degree_bounds.h"
#include "checker/replay.h"
#include "tests/support/minimal_classes.h"

namespace registrations {
/// The files in certs/models/registrations, replayed: one for each type.
const std::vector<checker::ReplayedFile>& committed_files();

/// What they prove of the types of minimal classes, and of the relative pose.
const checker::RegistrationBounds& committed();

/// What is known of degrees if all minimal classes are certified, by these bounds.
checker::DegreeTable table_of(const checker::RegistrationBounds& upper,
                              const std::vector<checker::LowerBound>& lower = {});

/// The upper bound of a class in a table; 0 if it has none.
std::size_t bound_of(const checker::DegreeTable& table, std::size_t number);

/// The same of a class in notation.
std::size_t bound_of(const checker::DegreeTable& table, std::string_view problem);
} // namespace registrations
