// What `plprove degree` says: for people and for machines.
#pragma once

#include "prover/minimal/decision.h"
#include "prover/three_views/degree.h"

#include <string>

namespace plprove {

/// The degree of one problem, as computed for its constraint class.
struct DegreeReport {
    Decision decision; ///< of a minimal or camera-minimal problem with classes
    DegreeOptions options;
    DegreeRun run;
    double seconds = 0;

    /// How many solutions the certificate shows.
    int certified() const {
        if (!run.record.empty()) return run.degree;
        return run.certificate ? run.certificate->degree() : 0;
    }
};

/// One fact a paragraph.
std::string text_report(const DegreeReport& report);

/// The same as a JSON object. `certificate` is how many solutions the certificate shows: certified
/// once plcheck accepts it.
std::string json_report(const DegreeReport& report);

} // namespace plprove
