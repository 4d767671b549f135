#include "checker/jacobian.h"

namespace checker {
namespace {

using Vector = std::array<mpz_class, 3>;
using Rotation = std::array<Vector, 3>; // by rows, scaled by the norm of the quaternion

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector rotated(const Rotation& rotation, const Numbers& x) {
    Vector y;
    for (std::size_t i = 0; i < 9; ++i)
        y[i / 3] += rotation[i / 3][i % 3] * x[i % 3];
    return y;
}

Rotation rotation(const Numbers& camera) {
    const mpz_class a = camera[0], b = camera[1], c = camera[2], d = camera[3];
    if (a == 0 && b == 0 && c == 0 && d == 0) throw Refused{"a quaternion is zero"};
    return {Vector{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
            Vector{2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
            Vector{2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}};
}

Residue residue(const mpz_class& x) {
    return {mpz_fdiv_ui(x.get_mpz_t(), modulus)};
}

/// The block without the given rows, where the first row has the number `first`.
Block without(const Block& block, std::span<const std::int64_t> deleted, std::int64_t first) {
    Matrix<mpz_class> rows{block.rows.rows - deleted.size(), block.rows.columns};
    for (std::size_t r = 0, filled = 0; r < block.rows.rows; ++r, ++first)
        if (!std::binary_search(deleted.begin(), deleted.end(), first))
            std::copy_n(block.rows[r], rows.columns, rows[filled++]);
    return eliminate(block.unknowns, rows);
}

} // namespace

Matrix<mpz_class> jacobian_rows(const Feature& feature, const std::vector<Numbers>& vectors,
                                const std::array<Numbers, 2>& cameras) {
    if (cameras[0][4] == 0) throw Refused{"the translation of camera 2 begins with 0"};
    Matrix<mpz_class> rows{feature.equations, feature.unknowns() + camera_unknowns};
    mpz_class* row = rows[0];
    for (std::size_t v = 0; v < 3; ++v) {
        const Numbers camera = v == 0 ? Numbers{1, 0, 0, 0, 0, 0, 0} : cameras[v - 1];
        const Rotation turn = rotation(camera);
        // Writes l·dx = 0, whose own unknowns begin in column 0, or l·de = 0; R turns y or e, the
        // arm.
        const auto equation = [&](const Vector& l, const Vector& arm, std::size_t first) {
            for (std::size_t k = 0; k < (first == 0 ? feature.point_unknowns() : 2); ++k)
                for (std::size_t i = 0; i < 3; ++i)
                    row[first + k] += l[i] * turn[i][k];
            mpz_class* column = row + feature.unknowns() + (v == 2 ? 5 : 0);
            for (std::size_t i = 0; v > 0 && i < 3; ++i)
                *column++ = cross(arm, l)[i];
            for (std::size_t i = v == 1; v > 0 && first == 0 && i < 3; ++i)
                *column++ = l[i];
            row += rows.columns;
        };
        const Vector y = rotated(turn, vectors[0]);
        const Vector x{y[0] + camera[4], y[1] + camera[5], y[2] + camera[6]};
        const bool sees_point = feature.point >> v & 1;
        if (sees_point && x[2] == 0)
            throw Refused{"the third coordinate of an image of the point is 0"};
        if (sees_point) equation({0, x[2], -x[1]}, y, 0);
        if (sees_point) equation({-x[2], 0, x[0]}, y, 0);
        for (std::size_t pin = 0; pin < feature.pins; ++pin) {
            if (vectors[pin + 1][2] == 0) throw Refused{"the third coordinate of a direction is 0"};
            if (!(feature.pin[pin] >> v & 1)) continue;
            const Vector e = rotated(turn, vectors[pin + 1]);
            const Vector l = cross(x, e);
            if (l == Vector{0, 0, 0}) throw Refused{"the image of a line is zero"};
            if (!sees_point) equation(l, y, 0);
            equation(l, e, feature.point_unknowns() + 2 * pin);
        }
    }
    return rows;
}

Block eliminate(std::size_t unknowns, const Matrix<mpz_class>& rows) {
    Block block{.unknowns = unknowns, .rows = rows};
    Matrix<mpz_class> m =
        rows; // by Bareiss's method: entries are minors, divisions leave no remainder
    mpz_class pivot = 1;
    Residue sign{1};
    for (std::size_t c = 0; c < unknowns; ++c) {
        std::size_t place = c;
        while (place < m.rows && residue(m[place][c]) == Residue{})
            ++place;
        if (place >= m.rows) return block; // the feature's own columns are dependent modulo q
        if (place != c) sign = -sign;
        std::swap_ranges(m[c], m[c] + m.columns, m[place]);
        for (std::size_t r = c + 1; r < m.rows; ++r)
            for (std::size_t k = m.columns; k-- > c;) // c last: it is the multiplier
                m[r][k] = (m[c][c] * m[r][k] - m[r][c] * m[c][k]) / pivot;
        pivot = m[c][c];
    }
    block.factor = sign * residue(pivot);
    block.conditions = {m.rows - unknowns, camera_unknowns};
    block.residues = {m.rows - unknowns, camera_unknowns};
    const Residue scale = residue(pivot).inverse();
    for (std::size_t i = 0; i < block.conditions.entries.size(); ++i) {
        block.conditions.entries[i] =
            m[unknowns + i / camera_unknowns][unknowns + i % camera_unknowns];
        block.residues.entries[i] = scale * residue(block.conditions.entries[i]);
    }
    return block;
}

Residue minor(const std::vector<const Block*>& blocks, std::span<const std::int64_t> rows,
              std::span<const std::int64_t> columns) {
    std::vector<std::size_t> kept; // the camera columns of the minor, from 0
    for (std::int64_t c = 0; c < 11; ++c)
        if (!std::binary_search(columns.begin(), columns.end(), c + 1)) kept.push_back(c);
    Matrix<Residue> rest{kept.size(), kept.size()};
    Residue factor{1};
    std::size_t filled = 0; // rows of `rest` in use
    std::int64_t first = 1; // the number of the next row of J
    for (const Block* block : blocks) {
        const std::int64_t end = first + block->rows.rows;
        const auto deleted =
            rows.first(std::lower_bound(rows.begin(), rows.end(), end) - rows.begin());
        const Block shorter = deleted.empty() ? Block{} : without(*block, deleted, first);
        if (!deleted.empty()) block = &shorter;
        if (block->factor == Residue{}) return {};
        factor = factor * block->factor;
        // The rows that this block uses up move past those that earlier blocks have left.
        if (filled * block->unknowns % 2 == 1) factor = -factor;
        for (std::size_t r = 0; r < block->residues.rows; ++r, ++filled)
            for (std::size_t c = 0; c < kept.size(); ++c)
                rest[filled][c] = block->residues[r][kept[c]];
        rows = rows.subspan(deleted.size());
        first = end;
    }
    return factor * determinant(std::move(rest));
}

bool allows(const Block& block, const Motion& motion) {
    for (std::size_t r = 0; r < block.conditions.rows; ++r) {
        mpz_class sum = 0;
        for (std::size_t c = 0; c < camera_unknowns; ++c)
            sum += block.conditions[r][c] * motion[c];
        if (sum != 0) return false;
    }
    return true;
}

} // namespace checker
