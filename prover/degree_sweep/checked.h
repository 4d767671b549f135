// What plcheck said of the certificates that a sweep collected. Nothing is called certified
// without.
#pragma once

#include "prover/degree_sweep/class_result.h"

#include <map>

namespace plprove {

class Checked {
public:
    /// Reads a report, as `plcheck --json degrees.plc` prints it, on files of certificates in
    /// `folder`. plcheck may have refused other records: each one stands for itself. Throws
    /// std::runtime_error if it is no such report, or if a file is not the one that was checked.
    Checked(const std::filesystem::path& report, const std::filesystem::path& folder);

    /// Whether plcheck refused something that is in the report.
    bool refused_something() const { return refused_something_; }

    /// Whether plcheck accepted this very certificate.
    bool accepts(const ClassResult& result) const;

private:
    bool refused_something_ = false;
    std::map<std::size_t, std::string> digests_; ///< of the records that were accepted
};

} // namespace plprove
