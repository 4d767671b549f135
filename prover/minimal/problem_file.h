// The file that certifies the verdict on one problem by itself: how it reduces, and the claim that
// decides, at coordinates of its own (certs/FORMAT.md, section 7).
#pragma once

#include "prover/minimal/decision.h"
#include "prover/minimal/placement.h"
#include "prover/minimal/problem_record.h"

namespace plprove {

struct ProblemFile {
    Decision decision;
    Cameras cameras; ///< none for a dimension count
    std::vector<PlacedFeature>
        features; ///< of the problem as given; of the lifted one where it is obstructed
    Claim claim = Unbalanced{};
};

/// Certifies the verdict, at coordinates as small as a short search finds. Throws
/// std::runtime_error where no point of the search has the rank that the verdict claims.
ProblemFile certify_problem(const Features& problem);

/// The text of the file. Throws FormatLimit if the format does not allow it.
std::string write(const ProblemFile& file);

} // namespace plprove
