// What a sweep computes the degrees of: constraint classes of problems in three calibrated views,
// or the minimal problems of a family (certs/FORMAT.md, section 13). Each has a number.
#pragma once

#include "prover/problem/problem.h"

#include <cstddef>
#include <string>
#include <vector>

namespace plprove {

struct SweepItem {
    std::size_t number = 0; ///< of the class; or the place in the list of the family, from 1 on
    int degree = 0;         ///< how many solutions it has, at least, as is on file; 0: unknown
    std::string problem{};  ///< of a family, in notation
};

struct SweepSubject {
    std::string family;           ///< the name; empty for constraint classes
    std::vector<SweepItem> items; ///< by ascending numbers

    /// The item with this number; null if there is none.
    const SweepItem* find(std::size_t number) const;

    /// The same. Throws std::out_of_range.
    const SweepItem& at(std::size_t number) const;

    /// How messages call one item, and several.
    std::string one() const { return family.empty() ? "class" : "problem"; }
    std::string several() const { return family.empty() ? "classes" : "problems"; }
};

/// All constraint classes of minimal problems in three calibrated views.
SweepSubject all_constraint_classes();

/// The minimal problems with complete visibility of these cameras.
SweepSubject minimal_problems_of(const CameraModel& cameras);

} // namespace plprove
