// The functions of Matlab that are imported.
#pragma once

#include "prover/importers/arrays.h"
#include "prover/importers/draft.h"

#include <string>
#include <vector>

namespace plprove::importers {

bool is_matlab_function(const std::string& name);

/// The value of such a function of arrays. The draft gets names for determinants and what they are
/// of. Throws ModelError if the arguments do not fit.
Array matlab_function(const std::string& name, const std::vector<Array>& arguments, Draft& draft,
                      model::Position at);

} // namespace plprove::importers
