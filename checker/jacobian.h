// The Jacobian J of the joint camera map at the point that a pool describes (FORMAT.md, sections 2
// and 3). A feature's rows of J involve its own unknowns and the 11 of the cameras only. So each
// feature is eliminated once, which leaves `weight` rows; a problem is 11 such rows.
#pragma once

#include "checker/modular.h"
#include "checker/problem.h"
#include "checker/reader.h"

#include <gmpxx.h>

#include <span>

namespace checker {
/// Why a certificate does not hold; thrown where this is found.
struct Refused {
    template <class... Part> explicit Refused(const Part&... parts) : reason(say(parts...)) {}
    std::string reason;
};

using Vector = std::array<mpz_class, 3>;
using Rotation = std::array<Vector, 3>;                // by rows, scaled by the quaternion's norm
using Motion = std::array<mpz_class, camera_unknowns>; // of the cameras
using Rows = std::vector<std::vector<mpz_class>>;      // of J: own unknowns, then the cameras'

inline Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Rotation rotation(std::span<const std::int64_t> quaternion) {
    const mpz_class a = quaternion[0], b = quaternion[1], c = quaternion[2], d = quaternion[3];
    if (a == 0 && b == 0 && c == 0 && d == 0) throw Refused("a quaternion is zero");
    return {Vector{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
            Vector{2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
            Vector{2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}};
}

/// The rows of a feature. `vectors` are its point (on a free line) and directions, `cameras` the
/// quaternion and translation of view 2, then of view 3. Throws Refused if these violate section 2.
inline Rows jacobian_rows(const Feature& feature, std::span<const std::int64_t> vectors,
                          std::span<const std::int64_t> cameras) {
    constexpr std::array<std::int64_t, 7> camera_1{1, 0, 0, 0, 0, 0, 0};
    Rows rows;
    if (cameras[4] == 0) throw Refused("the translation of camera 2 begins with 0");
    for (std::size_t v = 0; v < 3; ++v) {
        const auto camera =
            v == 0 ? std::span<const std::int64_t>(camera_1) : cameras.subspan(7 * (v - 1), 7);
        const Rotation turn = rotation(camera);
        const auto turned = [&](std::span<const std::int64_t> x) {
            Vector y;
            for (std::size_t i = 0; i < 9; ++i) y[i / 3] += turn[i / 3][i % 3] * x[i % 3];
            return y;
        };
        // Adds l·dx = 0, with own unknowns from column 0 on, or l·de = 0; the arm is y or e.
        const auto equation = [&](const Vector& l, const Vector& arm, std::size_t first) {
            auto& row = rows.emplace_back(feature.unknowns() + camera_unknowns);
            for (std::size_t k = 0; k < (first == 0 ? feature.point_unknowns() : 2); ++k)
                row[first + k] = l[0] * turn[0][k] + l[1] * turn[1][k] + l[2] * turn[2][k];
            if (v == 0) return;
            mpz_class* entry = &row[feature.unknowns() + (v == 1 ? 0 : 5)];
            for (const mpz_class& x : cross(arm, l)) *entry++ = x;
            for (std::size_t i = v == 1; first == 0 && i < 3; ++i) *entry++ = l[i];
        };
        const Vector y = turned(vectors);
        const Vector x{y[0] + camera[4], y[1] + camera[5], y[2] + camera[6]};
        const bool sees_point = feature.point >> v & 1;
        if (sees_point && x[2] == 0) throw Refused("an image of the point has third coordinate 0");
        if (sees_point) equation({0, x[2], -x[1]}, y, 0);
        if (sees_point) equation({-x[2], 0, x[0]}, y, 0);
        for (std::size_t pin = 0; pin < feature.pins; ++pin) {
            const auto direction = vectors.subspan(3 * pin + 3, 3);
            if (direction[2] == 0) throw Refused("a direction has third coordinate 0");
            if (!(feature.pin[pin] >> v & 1)) continue;
            const Vector e = turned(direction), l = cross(x, e);
            if (l == Vector{0, 0, 0}) throw Refused("the image of a line is zero");
            if (!sees_point) equation(l, y, 0);
            equation(l, e, feature.point_unknowns() + 2 * pin);
        }
    }
    return rows;
}

/// One instance of a feature, and what its own unknowns leave when they are eliminated.
struct Block {
    std::size_t unknowns = 0;
    Rows rows{};
    std::vector<Motion> conditions{}; // coefficients: what allows it to move with the cameras
    std::vector<Row> residues{};      // these, scaled: their determinant, times all factors, is
    Residue factor{};                 // det J up to sign; a factor is 0 only if det J is
};

/// Eliminates by Bareiss's method: all entries are minors, and the divisions leave no remainder.
inline Block eliminate(std::size_t unknowns, Rows rows) {
    const auto residue = [](auto& x) { return Residue{mpz_fdiv_ui(x.get_mpz_t(), modulus)}; };
    Block block{.unknowns = unknowns, .rows = rows, .factor = {1}};
    mpz_class pivot = 1;
    for (std::size_t c = 0; c < unknowns; ++c) {
        std::size_t place = c;
        while (place < rows.size() && residue(rows[place][c]) == Residue{}) ++place;
        if (place >= rows.size()) return {}; // the own columns are dependent modulo q
        if (place != c) block.factor = -block.factor;
        std::swap(rows[c], rows[place]);
        for (std::size_t r = c + 1; r < rows.size(); ++r)
            for (std::size_t k = rows[r].size(); k-- > c;) // c last: it is the multiplier
                rows[r][k] = (rows[c][c] * rows[r][k] - rows[r][c] * rows[c][k]) / pivot;
        pivot = rows[c][c];
    }
    block.factor = block.factor * residue(pivot);
    for (std::size_t r = unknowns; r < rows.size(); ++r) {
        Motion& condition = block.conditions.emplace_back();
        Row& residues = block.residues.emplace_back();
        for (std::size_t c = 0; c < camera_unknowns; ++c) {
            condition[c] = rows[r][unknowns + c];
            residues[c] = residue(condition[c]) * residue(pivot).inverse();
        }
    }
    return block;
}

/// The minor, modulo q, of the J of a balanced problem of these features, in order, without some
/// `rows` of J and as many camera `columns`: strictly ascending, numbered from 1.
inline Residue minor(const std::vector<const Block*>& blocks, std::span<const std::int64_t> rows,
                     std::span<const std::int64_t> columns) {
    std::array<Row, 11> m{};
    std::size_t filled = 0; // rows of m
    std::int64_t row = 0;   // of J
    Residue factor{1};
    for (const Block* block : blocks) {
        Block shorter;
        const auto next = std::upper_bound(rows.begin(), rows.end(), row);
        const std::int64_t end = row + std::ssize(block->rows);
        if (next != rows.end() && *next <= end) {
            Rows kept;
            for (const auto& entries : block->rows)
                if (!std::binary_search(rows.begin(), rows.end(), ++row)) kept.push_back(entries);
            shorter = eliminate(block->unknowns, std::move(kept));
            block = &shorter;
        }
        row = end;
        // The rows that the elimination used up move past those that earlier blocks have left. If
        // these are too many, another block has fewer rows than unknowns, and the minor is 0.
        factor = factor * (filled * block->unknowns % 2 == 0 ? block->factor : -block->factor);
        if (factor == Residue{} || filled + block->residues.size() > m.size()) return {};
        for (const Row& residues : block->residues) m[filled++] = residues;
    }
    for (const std::int64_t c : columns) { // expands by rows with a single 1, in a deleted column
        const auto column = static_cast<std::size_t>(c - 1);
        if ((filled + column) % 2 == 1) factor = -factor;
        m[filled++][column] = {1};
    }
    return factor * determinant(m);
}
} // namespace checker
