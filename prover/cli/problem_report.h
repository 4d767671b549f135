// What `plprove problem` says: the decision about a problem, for people and for machines.
#pragma once

#include "prover/catalogue/degrees.h"
#include "prover/classification/decision.h"

#include <string>
#include <vector>

namespace plprove {

/// The decision in words, one fact a paragraph. `degrees` is what is on file for its constraint
/// class, the most telling first.
std::string text_report(const Decision& decision, const std::vector<DegreeRecord>& degrees);

/// The same as a JSON object.
std::string json_report(const Decision& decision, const std::vector<DegreeRecord>& degrees);

} // namespace plprove
