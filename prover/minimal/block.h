// The linearised incidence equations of placed features (certs/FORMAT.md, section 3): the
// Jacobian of the joint camera map in integer entries, block by block.
//
// A problem's Jacobian J consists of one block of rows per feature; a block involves only the
// feature's own unknowns and the camera unknowns. Eliminating the former leaves `weight` rows in
// the camera unknowns: the camera part. All minors of interest are computed from camera parts, once
// for each placed feature.
#pragma once

#include "prover/geometry/flint.h"
#include "prover/minimal/placement.h"

#include <span>

namespace plprove {

/// Addresses of the elements of `values`, to pass some blocks or camera parts in a certain order.
template <class T>
std::vector<const T*> pointers(const std::vector<T>& values) {
    std::vector<const T*> result;
    for (const T& value : values)
        result.push_back(&value);
    return result;
}

/// The rows of J that belong to one feature: `rows` x (`own` + `cameras`), exact, row by row.
struct FeatureBlock {
    int rows = 0;
    int own = 0;
    int cameras = 0;
    std::vector<std::int64_t> entries;

    std::int64_t at(int row, int column) const {
        return entries[static_cast<std::size_t>(row * (own + cameras) + column)];
    }
};

/// The block of a placed feature in the chart of FORMAT.md, section 3. Assumes that neither the
/// cameras nor the feature have a defect and that no coordinate exceeds max_coordinate.
FeatureBlock feature_block(const PlacedFeature& placed, const Cameras& cameras);

/// The block after elimination of the feature's own unknowns.
struct CameraPart {
    int own = 0; ///< eliminated unknowns
    IntegerMatrix
        exact; ///< weight x cameras, up to a factor per row: what the block demands of the cameras
    ResidueMatrix modulo; ///< weight x cameras, modulo q: the Schur complement
    Residue factor = 0; ///< signed determinant of the eliminated rows: det of a square block [A|B]
                        ///< = factor * det(modulo)
};

/// Eliminates a block, or returns nothing where its own columns are dependent modulo q.
std::optional<CameraPart> eliminate(const FeatureBlock& block);

/// det J modulo q of the features with these camera parts, in this order. Assumes that J is square.
Residue determinant(std::span<const CameraPart* const> parts);

/// J itself: the blocks in order, as certs/FORMAT.md arranges them.
ResidueMatrix jacobian(std::span<const FeatureBlock* const> blocks);

} // namespace plprove
