// Evaluations of equations and Jacobian alone, on the lanes of AVX2: of the engine for three views,
// and of a model.
#pragma once

#include "prover/model/solver/tracking/tracked_program.h"
#include "prover/three_views/tracking/tracker.h"

namespace plprove::bench {

/// Evaluates at a point, 11 complex numbers, as often as that. How many evaluations that were: in
/// each lane one.
std::uint64_t evaluate_engine(const TrackedSystem& system, const TrackedImages& images,
                              const double* point, int times);

/// The same of a model; the workspace is that of a tracker.
std::uint64_t evaluate_model(const model::TrackedProgram& program,
                             const model::TrackedCurve* curves, const double* point,
                             LaneNumber* workspace, int times);

} // namespace plprove::bench
