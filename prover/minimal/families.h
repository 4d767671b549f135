// The named families of problems in the paper and in the literature, decided from signatures.
#pragma once

#include "prover/minimal/obstruction.h"

#include <optional>
#include <string>

namespace plprove {

/// Which families a balanced signature belongs to.
struct Families {
    bool pl0p = false;                 ///< free points and free lines only (Definition 7)
    bool at_most_one_pin = false;      ///< no point with two or more pins
    bool five_point_extension = false; ///< some two views share exactly five points
    bool registration = false;         ///< ... and fix all features that either of them sees
    bool trifocal_linear =
        false; ///< one of the 66 problems linear in the trifocal tensor (Kileel 2017)
    std::optional<std::string> plmp; ///< complete visibility: its name in PLMP, such as 3002_1
};

/// By the features alone, whether the problem is minimal or not.
Families families(const Signature& signature);

/// The same, but those families that consist of minimal problems have no others.
Families families_of(const Signature& signature, bool minimal);

} // namespace plprove
