// What `plprove solve` prints.
#pragma once

#include "prover/solver/images.h"
#include "prover/solver/solve.h"

#include <optional>
#include <string>

namespace plprove {

/// What became of --certify.
struct CertificateNote {
    std::string path;
    int solutions = 0; ///< that the file shows
    bool exact = true; ///< whether its images are those given
    double moved = 0;  ///< if not: the largest angle to one, in radians
};

struct SolveReport {
    GivenImages images;
    double moved = 0; ///< pixels, see ConsistentImages
    std::optional<std::size_t> number;
    Answer answer;
    std::optional<CertificateNote> certificate;
    std::vector<std::string> warnings;
};

/// As a table: the real solutions, each with its cameras.
std::string text_report(const SolveReport& report);

/// All of it (docs/answer.schema.json).
std::string json_report(const SolveReport& report);

} // namespace plprove
