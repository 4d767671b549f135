// Minors of J that are not 0: where a problem is minimal, all of J; where motions of the cameras
// keep all images, what is left without as many rows and columns, and these motions; where the
// images leave some of the scene open, what is left without as many own columns (certs/FORMAT.md,
// sections 3 to 5).
#pragma once

#include "prover/minimal/block.h"
#include "prover/minimal/jacobian.h"
#include "prover/minimal/obstruction.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace plprove {

struct Minor {
    Residue value = 0; ///< modulo q
    Obstruction obstruction{};
    std::vector<int> deleted_rows{};    ///< of J, from 1
    std::vector<int> deleted_columns{}; ///< from 1: of the cameras, or own ones
    std::vector<std::vector<std::string>>
        kernel{};        ///< decimal; camera parts of the motions, a basis
    Instance instance{}; ///< where J is taken; empty if a pool says so
};

/// What the minor proves, as files say it: `minimal`, `camera-minimal` or `deficient`.
std::string name(const Minor& minor);

/// A problem posed at a point: what obstructs it once it is reduced and lifted, and the blocks and
/// camera parts of its features, in order.
struct PosedProblem {
    Obstruction obstruction;
    std::vector<const FeatureBlock*> blocks;
    std::vector<const CameraPart*> parts;
};

/// The minor of a balanced problem at this point, or nothing where the point is special: the rank
/// there is less than at a generic one.
std::optional<Minor> find_minor(const PosedProblem& posed);

/// The minor of a problem that is camera-minimal, but leaves some of the scene open: J has full row
/// rank, with all camera columns among the pivots. Nothing where it has not.
std::optional<Minor> find_dominant_minor(std::span<const FeatureBlock* const> blocks);

} // namespace plprove
