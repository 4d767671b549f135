#include "prover/minimal/block.h"

#include <algorithm>
#include <numeric>

namespace plprove {

namespace {

/// A block under construction, which knows where the unknowns of the feature and of a camera are.
class BlockBuilder {
public:
    explicit BlockBuilder(const Feature& feature) : has_point_(feature.has_point) {
        block_.own = dimension_in_space(feature);
        block_.cameras = camera_unknowns(feature.views());
    }

    /// line . d(P_v X) = 0, where y = R_v X and `rotation` is R_v.
    void point_row(int view, const Vector3& line, const Matrix3& rotation, const Vector3& y) {
        begin_row();
        // Of the point on a free line only the first two coordinates move.
        for (int i = 0; i < (has_point_ ? 3 : 2); ++i)
            entry(i) = dot_column(line, rotation, i);
        add_rotation(view, cross(y, line));
        if (view == 0) return;
        // The first coordinate of t_2 is kept.
        for (int i = view == 1 ? 1 : 0; i < 3; ++i)
            entry(translation_column(view) + i) = line[static_cast<std::size_t>(i)];
    }

    /// line . d(R_v D) = 0, where e = R_v D and D is the direction of line number `index`.
    void direction_row(int view, const Vector3& line, const Matrix3& rotation, const Vector3& e,
                       int index) {
        begin_row();
        const int start = (has_point_ ? 3 : 2) + 2 * index;
        for (int i = 0; i < 2; ++i)
            entry(start + i) = dot_column(line, rotation, i);
        add_rotation(view, cross(e, line));
    }

    FeatureBlock take() { return std::move(block_); }

private:
    void begin_row() {
        ++block_.rows;
        block_.entries.resize(
            static_cast<std::size_t>(block_.rows * (block_.own + block_.cameras)));
    }

    std::int64_t& entry(int column) {
        return block_.entries[static_cast<std::size_t>(
            (block_.rows - 1) * (block_.own + block_.cameras) + column)];
    }

    // Columns of camera v = 1, 2, ... (from 0): omega from here on, then the translation. That of
    // camera 1 lacks its first coordinate.
    int rotation_column(int view) const { return block_.own + (view == 1 ? 0 : 6 * view - 7); }
    int translation_column(int view) const {
        return rotation_column(view) + 3 - (view == 1 ? 1 : 0);
    }

    void add_rotation(int view, const Vector3& coefficients) {
        if (view == 0) return;
        for (int i = 0; i < 3; ++i)
            entry(rotation_column(view) + i) = coefficients[static_cast<std::size_t>(i)];
    }

    static std::int64_t dot_column(const Vector3& line, const Matrix3& m, int column) {
        const auto c = static_cast<std::size_t>(column);
        return line[0] * m[0][c] + line[1] * m[1][c] + line[2] * m[2][c];
    }

    bool has_point_;
    FeatureBlock block_;
};

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
    const Feature& feature = placed.feature;
    BlockBuilder builder(feature);
    for (int view = 0; view < feature.views(); ++view) {
        const Camera camera = view == 0 ? Camera{} : cameras[static_cast<std::size_t>(view - 1)];
        const Matrix3 rotation = rotation_matrix(camera.quaternion);
        const Vector3 y = rotation * placed.point;
        const Vector3 x = y + camera.translation;
        if (feature.sees_point(view)) {
            builder.point_row(view, {0, x[2], -x[1]}, rotation, y);
            builder.point_row(view, {-x[2], 0, x[0]}, rotation, y);
        }
        for (int line = 0; line < feature.lines; ++line) {
            if (!feature.sees_line(view, line)) continue;
            const Vector3 e = rotation * placed.directions[static_cast<std::size_t>(line)];
            const Vector3 image = cross(x, e);
            if (!feature.sees_point(view)) builder.point_row(view, image, rotation, y);
            builder.direction_row(view, image, rotation, e, line);
        }
    }
    return builder.take();
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
