// Certificates of single problems as values: a nonzero minor where the problem is minimal; a kernel
// basis, a nonzero minor of the exact rank and the obstruction where it is not (certs/FORMAT.md,
// sections 3 to 5).
#pragma once

#include "prover/minimal/block.h"
#include "prover/minimal/obstruction.h"

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace plprove {

struct MinimalCertificate {
    Residue minor = 0; ///< det J modulo q
};

struct DeficientCertificate {
    Obstruction obstruction;
    std::vector<int> deleted_rows;                ///< of J, from 1
    std::vector<int> deleted_columns;             ///< of the 11 camera columns, from 1
    Residue minor = 0;                            ///< of J without these, modulo q
    std::vector<std::vector<std::string>> kernel; ///< decimal; camera parts of the motions, a basis
};

using Certificate = std::variant<MinimalCertificate, DeficientCertificate>;

/// Of a camera-minimal problem that leaves some of the scene open: the joint camera map is
/// dominant.
struct CameraMinimalCertificate {
    std::vector<int> deleted_columns; ///< of J, from 1; none of the camera columns
    Residue minor = 0;                ///< of J without these, all rows, modulo q
};

/// A problem posed at a point: what obstructs it once it is reduced and lifted, and the blocks and
/// camera parts of its features, in order.
struct PosedProblem {
    Obstruction obstruction;
    std::vector<const FeatureBlock*> blocks;
    std::vector<const CameraPart*> parts;
};

/// The certificate of a balanced problem at this point, or nothing where the point is special: the
/// rank there is less than at a generic one.
std::optional<Certificate> certify(const PosedProblem& posed);

/// The certificate that J has full row rank at this point with all camera columns among the pivots,
/// or nothing where it has not.
std::optional<CameraMinimalCertificate>
certify_dominant(std::span<const FeatureBlock* const> blocks);

} // namespace plprove
