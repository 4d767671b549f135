#include "prover/minimal/minor.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace plprove {

namespace {

std::string decimal(const fmpz* value) {
    std::string text(fmpz_sizeinbase(value, 10) + 2, '\0');
    fmpz_get_str(text.data(), 10, value);
    text.resize(text.find('\0'));
    return text;
}

/// The exact camera rows of the features, one below the other.
IntegerMatrix stack(std::span<const CameraPart* const> parts) {
    int rows = 0;
    for (const CameraPart* part : parts)
        rows += part->exact.rows();
    IntegerMatrix result(rows, parts.front()->exact.columns());
    int row = 0;
    for (const CameraPart* part : parts)
        for (int i = 0; i < part->exact.rows(); ++i, ++row)
            for (int j = 0; j < result.columns(); ++j)
                fmpz_set(result.at(row, j), part->exact.at(i, j));
    return result;
}

/// A reduced row echelon form with a common denominator: the matrix itself over the rationals,
/// `rank` rows.
struct EchelonForm {
    IntegerMatrix matrix;
    Integer denominator;
    std::vector<int> pivots;
    std::vector<int> free_columns;
};

EchelonForm echelon_form(const IntegerMatrix& matrix) {
    EchelonForm form{IntegerMatrix(matrix.rows(), matrix.columns()), {}, {}, {}};
    const auto rank = fmpz_mat_rref(form.matrix.get(), form.denominator.get(), matrix.get());
    for (int column = 0; column < matrix.columns(); ++column) {
        const auto row = static_cast<int>(form.pivots.size());
        const bool pivot = row < rank && !fmpz_is_zero(form.matrix.at(row, column));
        (pivot ? form.pivots : form.free_columns).push_back(column);
    }
    return form;
}

/// The kernel vector that is nonzero at free column `column` only among the free ones: primitive,
/// positive there.
std::vector<std::string> kernel_vector(const EchelonForm& form, int column) {
    IntegerMatrix vector(1, form.matrix.columns());
    fmpz_set(vector.at(0, column), form.denominator.get());
    for (std::size_t row = 0; row < form.pivots.size(); ++row)
        fmpz_neg(vector.at(0, form.pivots[row]), form.matrix.at(static_cast<int>(row), column));
    Integer content;
    fmpz_mat_content(content.get(), vector.get());
    if (fmpz_sgn(form.denominator.get()) < 0) fmpz_neg(content.get(), content.get());
    fmpz_mat_scalar_divexact_fmpz(vector.get(), vector.get(), content.get());
    std::vector<std::string> entries;
    for (int j = 0; j < vector.columns(); ++j)
        entries.push_back(decimal(vector.at(0, j)));
    return entries;
}

/// The rows of a matrix of full column rank that are not needed for it; `kept` receives the others.
/// Both ascend.
std::vector<int> superfluous_rows(const ResidueMatrix& matrix, std::vector<int>& kept) {
    ResidueMatrix transposed(matrix.columns(), matrix.rows());
    nmod_mat_transpose(transposed.get(), matrix.get());
    const auto rank = nmod_mat_rref(transposed.get());
    std::vector<int> superfluous;
    for (int row = 0; row < matrix.rows(); ++row) {
        const auto next = static_cast<int>(kept.size());
        const bool pivot = next < rank && transposed.at(next, row) != 0;
        (pivot ? kept : superfluous).push_back(row);
    }
    return superfluous;
}

ResidueMatrix without_camera_columns(const ResidueMatrix& matrix, std::span<const int> deleted) {
    const int first_camera_column = matrix.columns() - camera_dimension;
    ResidueMatrix result(matrix.rows(), matrix.columns() - static_cast<int>(deleted.size()));
    for (int j = 0, target = 0; j < matrix.columns(); ++j) {
        if (std::ranges::find(deleted, j - first_camera_column) != deleted.end()) continue;
        for (int i = 0; i < matrix.rows(); ++i)
            result.at(i, target) = matrix.at(i, j);
        ++target;
    }
    return result;
}

Residue minor_of_rows(const ResidueMatrix& matrix, std::span<const int> rows) {
    ResidueMatrix square(static_cast<int>(rows.size()), matrix.columns());
    for (int i = 0; i < square.rows(); ++i)
        for (int j = 0; j < square.columns(); ++j)
            square.at(i, j) = matrix.at(rows[static_cast<std::size_t>(i)], j);
    return nmod_mat_det(square.get());
}

std::vector<int> counted_from_one(std::vector<int> indices) {
    for (int& index : indices)
        ++index;
    return indices;
}

std::optional<Minor> find_deficient_minor(const PosedProblem& posed) {
    const EchelonForm form = echelon_form(stack(posed.parts));
    const auto deficiency = static_cast<std::size_t>(posed.obstruction.deficiency());
    if (form.free_columns.size() < deficiency)
        throw std::logic_error(
            "an obstructed problem has too large a rank: please report this problem");
    if (form.free_columns.size() > deficiency) return std::nullopt;

    Minor minor{.obstruction = posed.obstruction};
    for (const int column : form.free_columns)
        minor.kernel.push_back(kernel_vector(form, column));
    const ResidueMatrix remaining =
        without_camera_columns(jacobian(posed.blocks), form.free_columns);
    std::vector<int> kept;
    minor.deleted_rows = counted_from_one(superfluous_rows(remaining, kept));
    minor.deleted_columns = counted_from_one(form.free_columns);
    if (minor.deleted_rows.size() != deficiency) return std::nullopt;
    minor.value = minor_of_rows(remaining, kept);
    return minor;
}

/// The first columns of the feature's own unknowns that span the space of all of them, modulo q.
std::vector<int> independent_own_columns(const FeatureBlock& block) {
    ResidueMatrix echelon(block.rows, block.own);
    for (int i = 0; i < block.rows; ++i)
        for (int j = 0; j < block.own; ++j)
            echelon.at(i, j) = residue(block.at(i, j));
    const auto rank = nmod_mat_rref(echelon.get());
    std::vector<int> independent;
    for (int column = 0; column < block.own; ++column) {
        const auto row = static_cast<int>(independent.size());
        if (row < rank && echelon.at(row, column) != 0) independent.push_back(column);
    }
    return independent;
}

/// The block with these of its own columns only.
FeatureBlock with_own_columns(const FeatureBlock& block, std::span<const int> columns) {
    FeatureBlock result{block.rows, static_cast<int>(columns.size()), block.cameras, {}};
    for (int i = 0; i < block.rows; ++i) {
        for (const int column : columns)
            result.entries.push_back(block.at(i, column));
        for (int j = 0; j < block.cameras; ++j)
            result.entries.push_back(block.at(i, block.own + j));
    }
    return result;
}

} // namespace

std::string name(const Minor& minor) {
    if (minor.obstruction.deficiency() > 0) return "deficient";
    return minor.deleted_columns.empty() ? "minimal" : "camera-minimal";
}

std::optional<Minor> find_dominant_minor(std::span<const FeatureBlock* const> blocks) {
    // Feature by feature, as J is large where many features leave much of the scene open.
    Minor minor;
    std::vector<CameraPart> parts;
    int rows_left = 0;
    int first_column = 1;
    for (const FeatureBlock* block : blocks) {
        const std::vector<int> kept = independent_own_columns(*block);
        for (int column = 0; column < block->own; ++column)
            if (!std::ranges::binary_search(kept, column))
                minor.deleted_columns.push_back(first_column + column);
        first_column += block->own;
        auto part = eliminate(with_own_columns(*block, kept));
        if (!part) return std::nullopt;
        rows_left += part->modulo.rows();
        parts.push_back(std::move(*part));
    }
    if (rows_left != blocks.front()->cameras) return std::nullopt;
    minor.value = determinant(pointers(parts));
    if (minor.value == 0) return std::nullopt;
    return minor;
}

std::optional<Minor> find_minor(const PosedProblem& posed) {
    if (posed.obstruction.deficiency() > 0) return find_deficient_minor(posed);
    const Residue determinant_of_j = determinant(posed.parts);
    if (determinant_of_j == 0) return std::nullopt;
    return Minor{.value = determinant_of_j};
}

} // namespace plprove
