#include "checker/jacobian.h"

#include <algorithm>

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

} // namespace

Rows jacobian_rows(const Feature& feature, const std::vector<Numbers>& vectors,
                   const std::array<Numbers, 2>& cameras) {
    if (cameras[0][4] == 0) throw Refused{"the translation of camera 2 begins with 0"};
    Rows rows;
    for (std::size_t v = 0; v < 3; ++v) {
        const Numbers camera = v == 0 ? Numbers{1, 0, 0, 0, 0, 0, 0} : cameras[v - 1];
        const Rotation turn = rotation(camera);
        // Adds l·dx = 0, with own unknowns from column 0 on, or l·de = 0; the arm is y or e.
        const auto equation = [&](const Vector& l, const Vector& arm, std::size_t first) {
            auto& row = rows.emplace_back(feature.unknowns() + camera_unknowns);
            for (std::size_t k = 0; k < (first == 0 ? feature.point_unknowns() : 2); ++k)
                row[first + k] = l[0] * turn[0][k] + l[1] * turn[1][k] + l[2] * turn[2][k];
            if (v == 0) return;
            mpz_class* entry = &row[feature.unknowns() + (v == 1 ? 0 : 5)];
            for (const mpz_class& x : cross(arm, l))
                *entry++ = x;
            for (std::size_t i = v == 1; first == 0 && i < 3; ++i)
                *entry++ = l[i];
        };
        const Vector y = rotated(turn, vectors[0]);
        const Vector x{y[0] + camera[4], y[1] + camera[5], y[2] + camera[6]};
        const bool sees_point = feature.point >> v & 1;
        if (sees_point && x[2] == 0) throw Refused{"an image of the point has third coordinate 0"};
        if (sees_point) equation({0, x[2], -x[1]}, y, 0);
        if (sees_point) equation({-x[2], 0, x[0]}, y, 0);
        for (std::size_t pin = 0; pin < feature.pins; ++pin) {
            if (vectors[pin + 1][2] == 0) throw Refused{"a direction has third coordinate 0"};
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

Block eliminate(std::size_t unknowns, Rows rows) {
    Block block{.unknowns = unknowns, .rows = rows, .factor = {1}};
    mpz_class pivot = 1; // Bareiss's method: entries are minors, and divisions leave no remainder
    for (std::size_t c = 0; c < unknowns; ++c) {
        std::size_t place = c;
        while (place < rows.size() && residue(rows[place][c]) == Residue{})
            ++place;
        if (place >= rows.size()) return {}; // the own columns are dependent modulo q
        if (place != c) block.factor = -block.factor;
        std::swap(rows[c], rows[place]);
        for (std::size_t r = c + 1; r < rows.size(); ++r)
            for (std::size_t k = rows[r].size(); k-- > c;) // c last: it is the multiplier
                rows[r][k] = (rows[c][c] * rows[r][k] - rows[r][c] * rows[c][k]) / pivot;
        pivot = rows[c][c];
    }
    const Residue scale = residue(pivot).inverse();
    block.factor = block.factor * residue(pivot);
    for (std::size_t r = unknowns; r < rows.size(); ++r) {
        auto& condition = block.conditions.emplace_back();
        auto& residues = block.residues.emplace_back();
        for (std::size_t c = 0; c < camera_unknowns; ++c) {
            condition[c] = rows[r][unknowns + c];
            residues[c] = scale * residue(condition[c]);
        }
    }
    return block;
}

Residue minor(const std::vector<const Block*>& blocks, std::span<const std::int64_t> rows,
              std::span<const std::int64_t> columns) {
    std::array<std::array<Residue, 11>, 11> rest{};
    std::size_t filled = 0; // rows of `rest`
    std::int64_t row = 0;   // of J
    Residue factor{1};
    for (const Block* block : blocks) {
        Block shorter;
        const auto deleted = std::lower_bound(rows.begin(), rows.end(), row + 1);
        const std::int64_t end = row + std::ssize(block->rows);
        if (deleted != rows.end() && *deleted <= end) {
            Rows kept;
            for (const auto& r : block->rows)
                if (!std::binary_search(rows.begin(), rows.end(), ++row)) kept.push_back(r);
            shorter = eliminate(block->unknowns, std::move(kept));
            block = &shorter;
        }
        row = end;
        if (block->factor == Residue{}) return {};
        factor = factor * block->factor;
        // The rows that this block uses up move past those that earlier blocks have left.
        if (filled * block->unknowns % 2 == 1) factor = -factor;
        for (const auto& residues : block->residues) {
            std::size_t c = 0;
            for (std::int64_t column = 1; column <= 11; ++column)
                if (!std::binary_search(columns.begin(), columns.end(), column))
                    rest[filled][c++] = residues[column - 1];
            ++filled;
        }
    }
    return factor * determinant(rest, filled);
}

} // namespace checker
