// The label class of a problem, and the lines that change no degree.
#pragma once

#include "checker/problem/classes.h"
#include "checker/problem/problem.h"

namespace checker {
/// The problem without its implied lines (FORMAT.md, section 10): each has two points, and each
/// view that sees it sees both, so it has no parameters in space and in images.
Problem without_implied_lines(const Problem& problem);

/// The label class to which the problem belongs as it stands, by the signature that stands for it;
/// none if it is not balanced, or has other features than the 27.
std::optional<Signature> label_class(const Problem& problem);

/// Its number.
std::optional<std::size_t> class_of(const Classification& classes, const Problem& problem);
} // namespace checker
