// What plcheck said of the certificates that a sweep collected. Nothing is called certified
// without.
#pragma once

#include "prover/degree_sweep/class_result.h"

#include <map>

namespace plprove {

class Checked {
public:
    /// Reads a report, as `plcheck --json ... degrees.plc` prints it, on files of certificates in
    /// `folder`. Lower bounds are taken from any report on files that could be parsed: they rest on
    /// one record each. Exact degrees rest on more, and are taken only where plcheck refused
    /// nothing at all; then the other files of the report, which have the upper bounds, must still
    /// be where it names them. Throws std::runtime_error if it is no such report, or if a file is
    /// not the one that was checked.
    Checked(const std::filesystem::path& report, const std::filesystem::path& folder);

    /// Whether plcheck refused something that is in the report.
    bool refused_something() const { return refused_something_; }

    /// Whether plcheck accepted this very certificate.
    bool accepts(const ClassResult& result) const;

    /// The degree of the class, if plcheck certified from this very certificate that it is exact.
    std::optional<int> exact(const ClassResult& result) const;

private:
    bool refused_something_ = false;
    std::map<std::size_t, std::string> digests_; ///< of the records that were accepted
    std::map<std::size_t, int> exact_;
};

} // namespace plprove
