// The self-contained certificate of the verdict on one problem: how it reduces, and the rank that
// decides, at coordinates of its own (certs/FORMAT.md, "problem" files).
#pragma once

#include "prover/minimal/certificate.h"
#include "prover/minimal/decision.h"

#include <variant>

namespace plprove {

/// What proves the verdict. Dimension counts need no more than the reduction.
using Evidence = std::variant<std::monostate, MinimalCertificate, CameraMinimalCertificate,
                              DeficientCertificate>;

struct ProblemCertificate {
    Decision decision;
    Cameras cameras; ///< none for a dimension count
    std::vector<PlacedFeature>
        features; ///< of the problem as given; of the lifted one where it is obstructed
    Evidence evidence;
};

/// Certifies the verdict, at coordinates as small as a short search finds. Throws
/// std::runtime_error where no point of the search has the rank that the verdict claims.
ProblemCertificate certify_problem(const Features& problem);

/// The text of the certificate. Throws FormatLimit if the format does not allow it.
std::string write(const ProblemCertificate& certificate);

} // namespace plprove
