// What plcheck said of the certificates that a sweep collected. Nothing is called certified
// without.
#pragma once

#include "prover/degree_sweep/class_result.h"

#include <map>

namespace plprove {

class Checked {
public:
    /// Reads a report, as `plcheck --json degrees.plc ...` prints it, on files in `folder`. Throws
    /// std::runtime_error if it is none, or if a file is not the one that was checked.
    Checked(const std::filesystem::path& report, const std::filesystem::path& folder);

    /// Whether plcheck accepted this very certificate.
    bool accepts(const ClassResult& result) const;

    /// The degree of a label class, if plcheck certified that it is exact.
    std::optional<int> exact(std::size_t number) const;

private:
    std::map<std::size_t, std::string> digests_; ///< of the records that were accepted
    std::map<std::size_t, int> exact_;
};

} // namespace plprove
