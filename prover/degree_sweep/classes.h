// The systems of camera equations whose degrees there are to compute: the constraint classes of
// minimal problems, each named by the number of its first label class.
#pragma once

#include "prover/catalogue/filter.h"

#include <cstddef>
#include <span>
#include <vector>

namespace plprove {

/// Those that have a minimal label class which passes one of the filters, ascending. Throws
/// BadInput if there is none.
std::vector<std::size_t> constraint_classes_of(std::span<const ClassFilter> filters);

} // namespace plprove
