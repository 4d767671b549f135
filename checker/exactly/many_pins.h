// A point that all views see, with four or five pins: what Theorem K of proofs/three_views/ adds to
// its class where the pins put fewer conditions on the cameras than elsewhere.
#pragma once

#include "checker/exactly/common_centres.h"
#include "checker/problem/classes.h"

namespace checker::exactly {
/// The feature with four or five pins that the theorem speaks of.
bool is_star(const Feature& feature);

/// Whether the theorem speaks of a balanced signature in which no other point has more than one
/// pin. With five pins, it asks that no two views share more than a few other points; then the
/// degree is an integral over the second blow-up, else over the third one.
bool theorem_k_applies(const Signature& signature);

/// The class of the point at a chart. With five pins, only the constant has a meaning.
LinearClass class_of_star(const Chart& chart, const Feature& star);
} // namespace checker::exactly
