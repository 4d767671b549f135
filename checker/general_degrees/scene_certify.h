// Proofs that cameras and scene explain images (proofs/families.md), by Krawczyk's operator. They
// need the library Arb.
#pragma once

#include "checker/degrees/krawczyk.h"
#include "checker/general_degrees/scene_system.h"

namespace checker {
/// A box of camera coordinates with those of one nondegenerate solution of the system, to which
/// Newton steps from the starting values lead. Throws Refused without a proof.
Box certify_cameras(const SceneSystem& system, const ApproximateSolution& start);
} // namespace checker
