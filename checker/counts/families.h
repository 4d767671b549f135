// Families of problems that the paper counts, decided from a signature alone (FORMAT.md, section 6;
// proofs/classification.md, section 7).
#pragma once

#include "checker/minimal/obstruction.h"

namespace checker {
/// Whether all features are free lines and points without pins.
bool is_pl0p(const Signature& signature);

/// Whether no point has more than one pin.
bool at_most_one_pin(const Signature& signature);

/// Whether every view sees every point and every line.
bool completely_visible(const Signature& signature);

/// The name in PLMP, as `3002_1`, of a problem that is completely visible: points, dependent points
/// (none), free lines, pins, and the largest number of pins at a point.
std::string plmp_name(const Signature& signature);

/// Whether the terminal problem of the signature is on Kileel's list ("Minimal problems for the
/// calibrated trifocal variety", 2017): with respect to one of the views, all its features are
/// PPP, LLL, PPL, PLP or PLL correspondences. Swaps and relabelings do not change the answer.
bool linear_in_trifocal_tensor(const Signature& signature);

/// Whether the terminal problem of the signature has a dangling pin, one that a single view sees.
/// If not, the terminal problem is the problem itself. If so, it is not balanced.
bool terminal_has_dangling_pins(const Signature& signature);

/// Whether two views share exactly five points.
bool extends_five_points(const Signature& signature);

/// Whether two views share exactly five points, see the same lines, and of each point that only one
/// of them sees, the other sees a pin. So their relative pose fixes all that they see, and it is
/// left to register the third camera.
bool is_registration(const Signature& signature);
} // namespace checker
