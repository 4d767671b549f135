// Certificates of verdicts on problems in general, and the files that hold them (certs/FORMAT.md,
// section 13).
#pragma once

#include "prover/minimal/minor.h"
#include "prover/reasons/reason.h"
#include "prover/minimal/undecided.h"
#include "prover/problem/complete_visibility.h"

#include <functional>
#include <span>
#include <string>
#include <variant>

namespace plprove {

/// The images have more degrees of freedom than cameras and scene, or fewer.
struct Unbalanced {};

/// What proves a verdict.
using Claim = std::variant<Minor, Unbalanced, FourCollinear, OverconstrainedPart>;

/// The problem, with its lines in the order of its notation, and what proves the verdict.
struct ProblemRecord {
    Problem problem;
    Claim claim;
};

bool is_minimal(const ProblemRecord& certificate);

/// The verdict in a word, and the reason in a sentence.
std::string verdict(const ProblemRecord& certificate);
std::string explanation(const ProblemRecord& certificate);

/// A certificate whether the problem is minimal, if one is found.
std::variant<ProblemRecord, Undecided> try_to_certify(const Problem& problem);

/// The certificate. Throws std::runtime_error if none is found.
ProblemRecord certify(const Problem& problem);

/// The file with these certificates; as an archive of the family of a kind of cameras, if one is
/// given. Throws FormatLimit if the format does not allow it.
std::string write(std::span<const ProblemRecord> certificates);
std::string write(std::span<const ProblemRecord> certificates, const CameraModel& family);

} // namespace plprove
