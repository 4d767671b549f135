// What plcheck said of the certificates that a sweep collected. Nothing is called certified
// without.
#pragma once

#include "prover/degree_sweep/sweep_result.h"

#include <map>

namespace plprove {

/// A record that plcheck accepted.
struct AcceptedRecord {
    std::string digest;
    int solutions = 0; ///< that it certifies
};

class Checked {
public:
    /// Reads a report, as `plcheck --json degrees.plc` prints it, or `plcheck --json focal.plc` of
    /// a family, on files of certificates in `folder`. plcheck may have refused other records: each
    /// one stands for itself. Throws std::runtime_error if it is no such report, or if a file is
    /// not the one that was checked.
    Checked(const std::filesystem::path& report, const std::filesystem::path& folder);

    /// Whether plcheck refused something that is in the report.
    bool refused_something() const { return refused_something_; }

    /// How many solutions plcheck certified from this very certificate; 0 if it did not accept it.
    int certified(const SweepResult& result) const;

private:
    bool refused_something_ = false;
    std::map<std::string, AcceptedRecord> accepted_; ///< by the number of a class, or by problem
};

} // namespace plprove
