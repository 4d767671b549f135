// When two problems are the same: they may differ in the order of their features and in the names
// of pins (FORMAT.md, section 1). The order of the views matters.
#pragma once

#include "checker/problem/classes.h"
#include "checker/problem/notation.h"

#include <compare>
#include <map>
#include <optional>

namespace checker {
/// A feature without names: which views see its point, and which see each pin, in order.
struct CanonicalFeature {
    bool free_line = false;
    Views point = 0;
    std::vector<Views> pins{};
    auto operator<=>(const CanonicalFeature&) const = default;
};

/// How often each feature occurs in a problem. Equal ones are the same problem.
struct CanonicalProblem {
    unsigned views = 0; // 2 or 3
    std::map<CanonicalFeature, unsigned> features{};
    bool operator==(const CanonicalProblem&) const = default;
};

CanonicalProblem canonical(unsigned views, const Features& list);

/// The number of the label class to which the problem belongs as it stands; none if it is not
/// balanced, or has other features than the 27.
std::optional<std::size_t> class_of(const Classification& classes, const CanonicalProblem& problem);
} // namespace checker
