// Blocks of J. The rows of a feature involve its own unknowns and the 11 of the cameras only. So
// each feature is eliminated once, which leaves `weight` rows; a problem is 11 such rows.
#pragma once

#include "checker/algebra/modular.h"
#include "checker/classification/jacobian.h"

namespace checker {
using CameraMotion = std::array<mpz_class, camera_unknowns>;
using ResidueRow = std::array<Residue, camera_unknowns>;

/// One instance of a feature, and what is left when its own unknowns are eliminated.
struct Block {
    std::size_t unknowns = 0;
    IntegerRows rows{}; // of J
    /// Coefficients of the motions of the cameras with which the feature can move along.
    std::vector<CameraMotion> conditions{};
    /// The same modulo q, scaled: the determinant of those of a problem, times the factors of its
    /// blocks, is det J up to sign. A factor is 0 only if det J is.
    std::vector<ResidueRow> residues{};
    Residue factor{};
};

/// Makes the entries below the pivot, `rows[column][column]`, zero. All entries are minors of the
/// matrix, divided by the pivot before without a remainder (Bareiss).
inline void clear_below(IntegerRows& rows, std::size_t column, const mpz_class& pivot_before) {
    const mpz_class& pivot = rows[column][column];
    for (std::size_t r = column + 1; r < rows.size(); ++r) {
        const mpz_class multiplier = rows[r][column];
        for (std::size_t k = column; k < rows[r].size(); ++k)
            rows[r][k] = (pivot * rows[r][k] - multiplier * rows[column][k]) / pivot_before;
    }
}

/// Eliminates so many own unknowns. The block has factor 0 if their columns are dependent modulo q.
inline Block eliminate(std::size_t unknowns, IntegerRows rows) {
    Block block{.unknowns = unknowns, .rows = rows, .factor = {1}};
    mpz_class pivot = 1;
    for (std::size_t c = 0; c < unknowns; ++c) {
        std::size_t place = c;
        while (place < rows.size() && residue(rows[place][c]) == Residue{})
            ++place;
        if (place >= rows.size()) return {};
        if (place != c) block.factor = -block.factor;
        std::swap(rows[c], rows[place]);
        clear_below(rows, c, pivot);
        pivot = rows[c][c];
    }
    block.factor = block.factor * residue(pivot);
    const Residue scale = residue(pivot).inverse();
    for (std::size_t r = unknowns; r < rows.size(); ++r) {
        CameraMotion& condition = block.conditions.emplace_back();
        ResidueRow& residues = block.residues.emplace_back();
        for (std::size_t c = 0; c < camera_unknowns; ++c) {
            condition[c] = rows[r][unknowns + c];
            residues[c] = residue(condition[c]) * scale;
        }
    }
    return block;
}

/// Without those of its rows that are listed by their numbers in J; its first row has the number
/// `first`. The list ascends.
inline Block without_rows(const Block& block, const Numbers& deleted, int first) {
    IntegerRows kept;
    int number = first;
    for (const IntegerRow& row : block.rows) {
        if (!std::binary_search(deleted.begin(), deleted.end(), number)) kept.push_back(row);
        ++number;
    }
    return eliminate(block.unknowns, std::move(kept));
}

/// Whether the list, which ascends, has a number from `first` to `last`.
inline bool has_any(const Numbers& list, int first, int last) {
    const auto place = std::lower_bound(list.begin(), list.end(), first);
    return place != list.end() && *place <= last;
}

/// The minor, modulo q, of the J of a balanced problem of these blocks, in order, without some rows
/// of J and as many camera columns. Both lists ascend strictly, from 1.
inline Residue minor_of(const std::vector<const Block*>& blocks, const Numbers& deleted_rows,
                        const Numbers& deleted_columns) {
    std::array<ResidueRow, camera_unknowns> matrix{};
    std::size_t filled = 0; // rows of the matrix
    int row = 1;            // of J, the first of the block
    Residue factor{1};
    for (const Block* block : blocks) {
        const int next = row + static_cast<int>(block->rows.size());
        Block shorter;
        if (has_any(deleted_rows, row, next - 1)) {
            shorter = without_rows(*block, deleted_rows, row);
            block = &shorter;
        }
        row = next;
        // The rows that the elimination used up move past those that earlier blocks have left. If
        // these are too many, another block has fewer rows than unknowns, and the minor is 0.
        const bool odd = filled * block->unknowns % 2 != 0;
        factor = factor * (odd ? -block->factor : block->factor);
        if (factor == Residue{}) return {};
        if (filled + block->residues.size() > matrix.size()) return {};
        for (const ResidueRow& residues : block->residues)
            matrix[filled++] = residues;
    }
    // For each deleted column, a row whose only entry is a 1 in it: the minor is the determinant's
    // expansion by these rows.
    for (const int number : deleted_columns) {
        const auto column = static_cast<std::size_t>(number - 1);
        if ((filled + column) % 2 == 1) factor = -factor;
        matrix[filled++][column] = {1};
    }
    return factor * determinant(matrix);
}
} // namespace checker
