#include "checker/minimal/block.h"

namespace checker {
/// Puts a row into row c whose entry in column c is not 0. Whether there is one; flips the sign if
/// rows trade places.
template <class T, class IsZero>
static bool find_pivot(Rows<T>& rows, std::size_t c, Residue& sign, const IsZero& is_zero) {
    std::size_t place = c;
    while (place < rows.size() && is_zero(rows[place][c]))
        ++place;
    if (place >= rows.size()) return false;
    if (place != c) sign = -sign;
    std::swap(rows[c], rows[place]);
    return true;
}

/// What is left below these rows, from this column on.
template <class T> static Rows<T> rest_of(const Rows<T>& rows, std::size_t first) {
    Rows<T> rest;
    for (std::size_t r = first; r < rows.size(); ++r)
        rest.emplace_back(rows[r].begin() + std::ptrdiff_t(first), rows[r].end());
    return rest;
}

Block eliminate(std::size_t unknowns, Rows<Residue> rows) {
    Block block{.unknowns = unknowns, .factor = {1}};
    for (std::size_t c = 0; c < unknowns; ++c) {
        const auto is_zero = [](Residue x) { return x == Residue{}; };
        if (!find_pivot(rows, c, block.factor, is_zero)) return {.unknowns = unknowns};
        const Residue pivot = rows[c][c];
        const Residue inverse = pivot.inverse();
        block.factor = block.factor * pivot;
        for (std::size_t r = c + 1; r < rows.size(); ++r) {
            if (rows[r][c] == Residue{}) continue;
            const Residue multiple = -rows[r][c] * inverse;
            for (std::size_t k = c; k < rows[r].size(); ++k)
                rows[r][k] = rows[r][k] + multiple * rows[c][k];
        }
    }
    block.left = rest_of(rows, unknowns);
    return block;
}

/// Makes the entries below the pivot, `rows[column][column]`, zero. All entries are minors of the
/// matrix, divided by the pivot before without a remainder (Bareiss).
static void clear_below(Rows<mpz_class>& rows, std::size_t column, const mpz_class& pivot_before) {
    const mpz_class& pivot = rows[column][column];
    for (std::size_t r = column + 1; r < rows.size(); ++r) {
        const mpz_class multiplier = rows[r][column];
        for (std::size_t k = column; k < rows[r].size(); ++k)
            rows[r][k] = (pivot * rows[r][k] - multiplier * rows[column][k]) / pivot_before;
    }
}

Rows<mpz_class> conditions_on_cameras(std::size_t unknowns, Rows<mpz_class> rows) {
    mpz_class pivot = 1;
    Residue sign{1};
    for (std::size_t c = 0; c < unknowns; ++c) {
        const auto is_zero = [](const mpz_class& x) { return residue(x) == Residue{}; };
        if (!find_pivot(rows, c, sign, is_zero)) return {};
        clear_below(rows, c, pivot);
        pivot = rows[c][c];
    }
    return rest_of(rows, unknowns);
}

Rows<Residue> modulo_q(const Rows<mpz_class>& rows) {
    Rows<Residue> result;
    for (const std::vector<mpz_class>& row : rows) {
        std::vector<Residue>& residues = result.emplace_back();
        for (const mpz_class& entry : row)
            residues.push_back(residue(entry));
    }
    return result;
}

/// The determinant of what the blocks leave, and of a row for each deleted column whose only entry
/// is a 1 in it: the minor is the expansion by these rows.
Residue minor_of(const std::vector<const Block*>& blocks, std::size_t camera_columns,
                 const Numbers& deleted_columns) {
    SquareMatrix matrix(camera_columns);
    std::size_t filled = 0; // rows of the matrix
    Residue factor{1};
    for (const Block* block : blocks) {
        // The rows that the elimination used up move past those that earlier blocks have left. If
        // these are too many, another block has fewer rows than unknowns, and the minor is 0.
        const bool odd = filled * block->unknowns % 2 != 0;
        factor = factor * (odd ? -block->factor : block->factor);
        if (factor == Residue{}) return {};
        if (filled + block->left.size() > camera_columns) return {};
        for (const std::vector<Residue>& row : block->left)
            std::ranges::copy(row, matrix[filled++].begin());
    }
    if (filled + deleted_columns.size() != camera_columns) return {};
    for (const int number : deleted_columns) {
        const auto column = static_cast<std::size_t>(number - 1);
        if ((filled + column) % 2 == 1) factor = -factor;
        matrix[filled++][column] = {1};
    }
    return factor * determinant(std::move(matrix));
}

/// Rows of different components of the scene have only columns of the cameras in common. So
/// elimination is that of each component, though J is one block here.
Residue jacobian_determinant(const Problem& problem, const Placement& placement) {
    Jacobian<Residue> j = jacobian<Residue>(problem, placement);
    const Block block = eliminate(j.own, std::move(j.rows));
    return minor_of({&block}, static_cast<std::size_t>(camera_columns(problem)));
}

Component component_of(std::size_t unknowns, Rows<mpz_class> rows) {
    Block block = eliminate(unknowns, modulo_q(rows));
    Rows<mpz_class> conditions = conditions_on_cameras(unknowns, rows);
    return {std::move(rows), std::move(conditions), std::move(block)};
}
} // namespace checker
