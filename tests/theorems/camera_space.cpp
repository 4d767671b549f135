// Lemmas R1 and R3 of proofs/relations.md by a second method: the forms F and T vanish on Y and B
// as schemes, if the matrices of their derivatives have the codimension as rank. One random point
// of each, modulo q = 2^61 - 1, before any blow-up.
#include "checker/algebra/modular.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

using checker::Residue;

namespace {
using Vector = std::vector<Residue>;
using Quaternion = std::array<Residue, 4>;
using Matrix = std::array<std::array<Residue, 3>, 3>;

constexpr Residue zero{0}, one{1};

/// The matrix of quadratic forms of a quaternion.
Matrix rotation(const Quaternion& q) {
    const auto& [w, x, y, z] = q;
    const Residue two = one + one;
    return {{{w * w + x * x - y * y - z * z, two * (x * y - w * z), two * (x * z + w * y)},
             {two * (x * y + w * z), w * w - x * x + y * y - z * z, two * (y * z - w * x)},
             {two * (x * z - w * y), two * (y * z + w * x), w * w - x * x - y * y + z * z}}};
}

Quaternion product(const Quaternion& p, const Quaternion& q) {
    return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
            p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
            p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
            p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}

/// A quaternion of norm 0: with q = 3 modulo 4, r has the root r^((q + 1) / 4), or none.
Quaternion isotropic(std::mt19937_64& random) {
    while (true) {
        Quaternion q{Residue{random() % checker::modulus}, Residue{random() % checker::modulus},
                     Residue{random() % checker::modulus}, one};
        const Residue square = zero - q[0] * q[0] - q[1] * q[1] - q[2] * q[2];
        Residue root = square;
        for (int n = 0; n < 59; ++n) // (q + 1) / 4 = 2^59
            root = root * root;
        q[3] = root;
        if (root * root == square) return q;
    }
}

std::array<Residue, 3> first_column(const Matrix& m) {
    return {m[0][0], m[1][0], m[2][0]};
}

/// The coefficients of F, from a vector (q, t).
Vector epipolar_form(const Vector& at) {
    const Matrix r = rotation({at[0], at[1], at[2], at[3]});
    Vector form;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t k = (i + 1) % 3, l = (i + 2) % 3;
            form.push_back(at[4 + k] * r[l][j] - at[4 + l] * r[k][j]);
        }
    }
    return form;
}

/// The coefficients of T, from a vector (q_2, s_2 t_2, q_3, s_3 t_3).
Vector trifocal_form(const Vector& at) {
    const Matrix r2 = rotation({at[0], at[1], at[2], at[3]});
    const Matrix r3 = rotation({at[7], at[8], at[9], at[10]});
    Vector form;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k)
                form.push_back(r2[j][i] * at[11 + k] - at[4 + j] * r3[k][i]);
    return form;
}

std::size_t rank(std::vector<Vector> rows) {
    std::size_t rank = 0;
    for (std::size_t column = 0; column < rows[0].size() && rank < rows.size(); ++column) {
        std::size_t pivot = rank;
        while (pivot < rows.size() && rows[pivot][column] == zero)
            ++pivot;
        if (pivot == rows.size()) continue;
        std::swap(rows[rank], rows[pivot]);
        for (std::size_t row = rank + 1; row < rows.size(); ++row) {
            const Residue factor = rows[row][column];
            for (std::size_t c = 0; c < rows[row].size(); ++c)
                rows[row][c] = rows[row][c] * rows[rank][column] - factor * rows[rank][c];
        }
        ++rank;
    }
    return rank;
}

/// The rank of the matrix of derivatives of a form's coefficients, which have degree 3 at most in
/// each variable.
std::size_t rank_of_derivatives(Vector (*form)(const Vector&), const Vector& at) {
    // The derivative of a cubic p(h) at 0: (18 p(1) - 9 p(2) + 2 p(3) - 11 p(0)) / 6.
    std::vector<Vector> rows;
    for (std::size_t i = 0; i < at.size(); ++i) {
        Vector row(form(at).size(), zero);
        Vector moved = at;
        for (const std::array<Residue, 2>& weight : {std::array{zero, zero - Residue{11}},
                                                     {one, Residue{18}},
                                                     {Residue{2}, zero - Residue{9}},
                                                     {Residue{3}, Residue{2}}}) {
            moved[i] = at[i] + weight[0];
            const Vector value = form(moved);
            for (std::size_t n = 0; n < row.size(); ++n)
                row[n] = row[n] + weight[1] * value[n];
        }
        rows.push_back(row);
    }
    return rank(rows);
}

bool vanishes(const Vector& form) {
    return std::ranges::all_of(form, [](Residue value) { return value == zero; });
}
} // namespace

TEST_CASE("the epipolar form vanishes on the surface Y, of codimension 3, as a scheme") {
    std::mt19937_64 random(1);
    const Quaternion q = isotropic(random);
    const auto t = first_column(rotation(q));
    Vector at(q.begin(), q.end());
    at.insert(at.end(), t.begin(), t.end());
    CHECK(vanishes(epipolar_form(at)));
    CHECK(rank_of_derivatives(epipolar_form, at) == 3);
    at[4] = at[4] + one; // another epipole
    CHECK_FALSE(vanishes(epipolar_form(at)));
}

TEST_CASE("the trifocal tensor vanishes on a threefold, of codimension 8, as a scheme") {
    std::mt19937_64 random(2);
    const Quaternion q2 = isotropic(random);
    const Quaternion q3 = product({Residue{2}, Residue{3}, Residue{5}, Residue{7}}, q2);
    const auto t2 = first_column(rotation(q2)), t3 = first_column(rotation(q3));
    Vector at(q2.begin(), q2.end());
    at.insert(at.end(), t2.begin(), t2.end());
    at.insert(at.end(), q3.begin(), q3.end());
    at.insert(at.end(), t3.begin(), t3.end());
    CHECK(vanishes(trifocal_form(at)));
    CHECK(rank_of_derivatives(trifocal_form, at) == 8);
    at[11] = at[11] + one;
    CHECK_FALSE(vanishes(trifocal_form(at)));
}
