// What `plprove problem` says: the decision about a problem, for people and for machines.
#pragma once

#include "prover/catalogue/degrees.h"
#include "prover/classification/hints.h"

#include <string>
#include <vector>

namespace plprove {

/// A change that makes a problem minimal, with the degrees on file of what comes out.
struct HintWithDegrees {
    Hint hint;
    std::vector<DegreeRecord> degrees;
};

/// What is known of a problem. `degrees` is what is on file for its constraint class, the most
/// telling first.
struct ProblemReport {
    Decision decision;
    std::vector<DegreeRecord> degrees;
    std::vector<HintWithDegrees> hints;
};

/// Decides, and looks up what is on file.
ProblemReport report_on(const Problem& problem);

/// The decision in words, one fact a paragraph.
std::string text_report(const ProblemReport& report);

/// The same as a JSON object.
std::string json_report(const ProblemReport& report);

} // namespace plprove
