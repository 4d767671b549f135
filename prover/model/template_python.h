// A template as a program in Python (docs/models.md).
#pragma once

#include "prover/model/elimination_template.h"

namespace plprove::model {

/// A module that needs NumPy alone: from data to all solutions.
std::string python_module(const Study& study, const EliminationTemplate& table);

} // namespace plprove::model
