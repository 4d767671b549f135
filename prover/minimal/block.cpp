#include "prover/minimal/block.h"

#include "prover/minimal/jacobian.h"

#include <algorithm>
#include <numeric>

namespace plprove {

namespace {

/// The residue of an integer modulo q.
Residue residue_of(const fmpz* value) {
    return fmpz_fdiv_ui(value, modulus);
}

/// Rows `order[first..last)` and columns [from, to) of the block.
IntegerMatrix submatrix(const FeatureBlock& block, std::span<const int> order, int from, int to) {
    IntegerMatrix result(static_cast<int>(order.size()), to - from);
    for (int i = 0; i < result.rows(); ++i)
        for (int j = from; j < to; ++j)
            fmpz_set_si(result.at(i, j - from), block.at(order[static_cast<std::size_t>(i)], j));
    return result;
}

/// An order of the rows of the block whose first `own` rows are independent modulo q in the own
/// columns, or nothing.
std::optional<std::vector<int>> pivot_order(const FeatureBlock& block) {
    ResidueMatrix own(block.rows, block.own);
    for (int i = 0; i < block.rows; ++i)
        for (int j = 0; j < block.own; ++j)
            own.at(i, j) = residue(block.at(i, j));
    std::vector<slong> permutation(static_cast<std::size_t>(block.rows));
    std::iota(permutation.begin(), permutation.end(), 0);
    if (nmod_mat_lu(permutation.data(), own.get(), 0) < block.own) return std::nullopt;
    return std::vector<int>(permutation.begin(), permutation.end());
}

bool is_odd(std::span<const int> permutation) {
    bool odd = false;
    for (std::size_t i = 0; i < permutation.size(); ++i)
        for (std::size_t j = i + 1; j < permutation.size(); ++j)
            odd ^= permutation[i] > permutation[j];
    return odd;
}

} // namespace

FeatureBlock feature_block(const PlacedFeature& placed, const Cameras& cameras) {
    Instance instance;
    for (const auto& [q, t] : cameras)
        instance.cameras.push_back({q[0], q[1], q[2], q[3], t[0], t[1], t[2]});
    instance.scene.assign(placed.point.begin(), placed.point.end());
    for (const Vector3& direction : placed.directions)
        instance.scene.insert(instance.scene.end(), direction.begin(), direction.end());
    Matrix<std::int64_t> matrix = jacobian<std::int64_t>(problem_of({placed.feature}), instance);
    const int own = dimension_in_space(placed.feature);
    return {matrix.rows, own, matrix.columns - own, std::move(matrix.entries)};
}

std::optional<CameraPart> eliminate(const FeatureBlock& block) {
    const auto order = pivot_order(block);
    if (!order) return std::nullopt;
    const std::span<const int> rows(*order);
    const std::span<const int> upper = rows.first(static_cast<std::size_t>(block.own));
    const std::span<const int> lower = rows.subspan(static_cast<std::size_t>(block.own));
    const int end = block.own + block.cameras;
    const int weight = block.rows - block.own;

    // With [A1 | B1] above [A2 | B2]: A1 X = d B1, so that d B2 - A2 X = d (B2 - A2 A1^-1 B1).
    const IntegerMatrix a1 = submatrix(block, upper, 0, block.own);
    const IntegerMatrix b1 = submatrix(block, upper, block.own, end);
    const IntegerMatrix a2 = submatrix(block, lower, 0, block.own);
    IntegerMatrix exact = submatrix(block, lower, block.own, end);
    IntegerMatrix x(block.own, block.cameras);
    IntegerMatrix product(weight, block.cameras);
    Integer denominator;
    if (fmpz_mat_solve(x.get(), denominator.get(), a1.get(), b1.get()) == 0) return std::nullopt;
    fmpz_mat_mul(product.get(), a2.get(), x.get());
    fmpz_mat_scalar_mul_fmpz(exact.get(), exact.get(), denominator.get());
    fmpz_mat_sub(exact.get(), exact.get(), product.get());

    const nmod_t q = modulus_context();
    CameraPart part;
    part.own = block.own;
    part.modulo = ResidueMatrix(weight, block.cameras);
    const Residue inverse = nmod_inv(residue_of(denominator.get()), q);
    for (int i = 0; i < weight; ++i)
        for (int j = 0; j < block.cameras; ++j)
            part.modulo.at(i, j) = nmod_mul(residue_of(exact.at(i, j)), inverse, q);
    Integer determinant_of_a1;
    fmpz_mat_det(determinant_of_a1.get(), a1.get());
    part.factor = residue_of(determinant_of_a1.get());
    if (is_odd(*order)) part.factor = nmod_neg(part.factor, q);
    part.exact = std::move(exact);
    return part;
}

Residue determinant(std::span<const CameraPart* const> parts) {
    const nmod_t q = modulus_context();
    const int size = parts.empty() ? 0 : parts.front()->modulo.columns();
    ResidueMatrix stack(size, size);
    Residue factor = 1;
    int row = 0;
    bool odd = false;
    for (const CameraPart* part : parts) {
        // Its camera rows, and all those before, pass below the eliminated rows of this feature.
        odd ^= row % 2 != 0 && part->own % 2 != 0;
        for (int i = 0; i < part->modulo.rows(); ++i, ++row)
            for (int j = 0; j < size; ++j)
                stack.at(row, j) = part->modulo.at(i, j);
        factor = nmod_mul(factor, part->factor, q);
    }
    const Residue result = nmod_mul(factor, nmod_mat_det(stack.get()), q);
    return odd ? nmod_neg(result, q) : result;
}

ResidueMatrix jacobian(std::span<const FeatureBlock* const> blocks) {
    int rows = 0;
    int own = 0;
    for (const FeatureBlock* block : blocks) {
        rows += block->rows;
        own += block->own;
    }
    ResidueMatrix result(rows, own + (blocks.empty() ? 0 : blocks.front()->cameras));
    int row = 0;
    int column = 0;
    for (const FeatureBlock* block : blocks) {
        for (int i = 0; i < block->rows; ++i, ++row) {
            for (int j = 0; j < block->own; ++j)
                result.at(row, column + j) = residue(block->at(i, j));
            for (int j = 0; j < block->cameras; ++j)
                result.at(row, own + j) = residue(block->at(i, block->own + j));
        }
        column += block->own;
    }
    return result;
}

} // namespace plprove
