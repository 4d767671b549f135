// Deciding a problem: minimal, camera-minimal only, or neither, and why; for any PL1P in two or
// three views.
//
// The problem is reduced (Theorems 2 and 7) and its dangling pins are fixed (Theorem 6). Neither
// changes whether it is camera-minimal. What remains consists of the 27 features and is
// camera-minimal exactly when its weights add up to the dimension of the cameras and no obstruction
// holds. A camera-minimal problem is minimal exactly when it is balanced as given (Lemma 2).
#pragma once

#include "prover/minimal/families.h"
#include "prover/problem/reduction.h"

#include <optional>
#include <string>
#include <vector>

namespace plprove {

enum class Verdict { minimal, camera_minimal, obstructed, under_constrained, over_constrained };

/// The word for the verdict in certificates and output, such as `camera-minimal`.
std::string_view name(Verdict verdict);

/// Where a problem, reduced and lifted, stands among the classes of the three-view classification.
struct ClassNumbers {
    std::size_t label = 0;      ///< the authors' number
    std::size_t swap = 0;       ///< of the first member of the swap&label class
    std::size_t constraint = 0; ///< of the first member of the constraint class
};

struct Decision {
    Features problem;
    Reduction reduction;
    Features lifted;   ///< reduced, with dangling pins fixed
    Features terminal; ///< reduced, with all pins dangling that can be
    int space_dimension = 0;
    int image_dimension = 0;
    int camera_dimension = 0;
    int constraints = 0; ///< the weights of `lifted`, added up
    Obstruction obstruction;
    Verdict verdict{};
    std::optional<ClassNumbers>
        classes;                      ///< where `lifted` is a balanced problem of the 27 features
    std::optional<Families> families; ///< likewise

    bool balanced() const { return space_dimension + camera_dimension == image_dimension; }
};

Decision decide(const Features& problem);

/// Why, in a few sentences: dimension counts, or which views and points carry the obstruction.
std::vector<std::string> reasons(const Decision& decision);

} // namespace plprove
