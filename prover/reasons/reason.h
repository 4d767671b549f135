// Why a balanced problem is not minimal, for generic images of any kind: four collinear points, or
// a part of the problem that its images over-constrain (certs/FORMAT.md, section 13; the proofs are
// in proofs/families.md).
#pragma once

#include "prover/reasons/motion.h"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace plprove {

/// Four points on a line that two views see: their cross-ratio is the same in both images.
struct FourCollinear {
    std::array<int, 4> points{};
    std::array<int, 2> views{};
};

/// The images of the part satisfy at least `excess` conditions, as the motion keeps them.
struct OverconstrainedPart {
    Subproblem part;
    CameraMotion motion;
    int excess = 0;
};

using Reason = std::variant<FourCollinear, OverconstrainedPart>;

/// The numbers from 1 of what is counted from 0, each after a blank; " -" if there are none.
std::string numbers_from_one(const std::vector<int>& numbers);

/// How many conditions the images of the part satisfy at least; 0 or less says nothing. Nothing if
/// the motion is not as FORMAT.md requires.
std::optional<int> excess(const Problem& problem, const Subproblem& part,
                          const CameraMotion& motion);

/// A reason why the problem is not minimal; nothing if the search finds none.
std::optional<Reason> find_reason(const Problem& problem);

/// A motion by which the images of just this part satisfy a condition. The part should be small:
/// the search tries more than that of all parts.
std::optional<Reason> find_reason_in(const Problem& problem, const Subproblem& part);

} // namespace plprove
