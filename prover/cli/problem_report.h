// What `plprove problem` says: the decision about a problem, for people and for machines.
#pragma once

#include "prover/catalogue/degrees.h"
#include "prover/classification/decision.h"

#include <optional>
#include <string>

namespace plprove {

/// The decision in words, one fact a paragraph. `degree` is what is on file for its constraint
/// class.
std::string text_report(const Decision& decision, const std::optional<DegreeRecord>& degree);

/// The same as a JSON object.
std::string json_report(const Decision& decision, const std::optional<DegreeRecord>& degree);

} // namespace plprove
