// proofs/special_lines.md (Theorem M), modulo the prime 2^61 - 1: the maps Lambda_1, Lambda_2 of
// ten points of P^3, and lines on which both have rank 1 at most.
#pragma once

#include "proofs/computations/scroll_quadrics.h"

#include <array>
#include <vector>

namespace proofs {

/// A point of K = C^2 + K': first the coordinates x_1, x_2 of e_1 and e_2, then those of K'.
using PointOfK = std::array<Residue, 6>;

/// Symmetric bilinear maps K' x K' -> K': the value (i, j) at two basis vectors.
using BilinearMap = std::array<std::array<Vector, 4>, 4>;

inline Vector value(const BilinearMap& map, const Vector& a, const Vector& b) {
    Vector sum(4);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t n = 0; n < 4; ++n)
                sum[n] = sum[n] + a[i] * b[j] * map[i][j][n];
    return sum;
}

/// The point of K'.
inline Vector projected(const PointOfK& x) {
    return {x.begin() + 2, x.end()};
}

inline Matrix squares(const std::vector<PointOfK>& points) {
    Matrix rows;
    for (const PointOfK& x : points)
        rows.push_back(monomials(projected(x)));
    return rows;
}

/// Rows y(i, j), i <= j: the symmetric tensor of the basis vectors i, j is the sum of y_x x'^2.
/// The squares have to be a basis.
inline Matrix coordinates_of_products(const std::vector<PointOfK>& points) {
    const Matrix rows = squares(points);
    const Residue one{1}, half = Residue{2}.inverse();
    Matrix system(10, Vector(20));
    for (std::size_t n = 0; n < 10; ++n)
        for (std::size_t m = 0; m < 10; ++m)
            system[m][n] = rows[n][m];
    std::size_t m = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i; j < 4; ++j, ++m)
            system[m][10 + m] = -(i == j ? one : half);
    Matrix result = kernel_of(system, 20); // (y, unit vector)
    for (Vector& row : result)
        row.resize(10);
    return result;
}

/// Lambda_1 and Lambda_2, with x'^2 -> x_i x' for the ten points, whose squares have to be a basis.
inline std::array<BilinearMap, 2> maps_of_points(const std::vector<PointOfK>& points) {
    const Matrix y = coordinates_of_products(points);
    std::array<BilinearMap, 2> maps;
    for (std::size_t h = 0; h < 2; ++h)
        for (std::size_t i = 0, m = 0; i < 4; ++i)
            for (std::size_t j = i; j < 4; ++j, ++m) {
                Vector sum(4);
                for (std::size_t x = 0; x < 10; ++x)
                    for (std::size_t n = 0; n < 4; ++n)
                        sum[n] = sum[n] + y[m][x] * points[x][h] * points[x][2 + n];
                maps[h][i][j] = maps[h][j][i] = sum;
            }
    return maps;
}

/// The ten points, in coordinates of K in which point number n is (0, 0, 1, 0, 0, 0); those of K' /
/// x' are random.
inline std::vector<PointOfK> centered_at(const std::vector<PointOfK>& points, std::size_t n,
                                         Numbers& random) {
    const PointOfK center = points[n];
    std::size_t c = 2;
    while (center[c] == Residue{})
        ++c;
    const Residue scale = center[c].inverse();
    std::array<PointOfK, 3> forms; // on K, 0 at x
    for (PointOfK& form : forms) {
        Residue sum;
        for (std::size_t j = 2; j < 6; ++j)
            if (j != c) {
                form[j] = random();
                sum = sum + form[j] * center[j];
            }
        form[c] = -sum * scale;
    }
    std::vector<PointOfK> result;
    for (const PointOfK& x : points) {
        const Residue first = x[c] * scale;
        PointOfK y{x[0] - first * center[0], x[1] - first * center[1], first};
        for (std::size_t m = 0; m < 3; ++m)
            for (std::size_t j = 2; j < 6; ++j)
                y[3 + m] = y[3 + m] + forms[m][j] * x[j];
        result.push_back(y);
    }
    return result;
}

inline Residue determinant_of(const Vector& a, const Vector& b, const Vector& c) {
    return checker::determinant(Matrix{a, b, c});
}

/// At y in K' / x', for one map with Lambda(x', x') = 0: the form q, its derivatives by the first
/// two coordinates, and the form g(v) = det(y, By, Bv) at the first two basis vectors.
struct Star {
    Residue q;
    Pair derivative, g;
};

inline Vector tail(const Vector& v) {
    return {v.begin() + 1, v.end()};
}

inline Star star(const BilinearMap& map, const Vector& y) {
    const Vector x = unit(4, 0);
    Vector lifted{Residue{}};
    lifted.insert(lifted.end(), y.begin(), y.end());
    const Vector By = tail(value(map, x, lifted)), R = tail(value(map, lifted, lifted));
    Star result{determinant_of(y, By, R), {}, {}};
    for (std::size_t n = 0; n < 2; ++n) {
        const Vector v = unit(4, n + 1), Bv = tail(value(map, x, v));
        result.derivative[n] = determinant_of(tail(v), By, R) + determinant_of(y, Bv, R) +
                               Residue{2} * determinant_of(y, By, tail(value(map, lifted, v)));
        result.g[n] = determinant_of(y, By, Bv);
    }
    return result;
}

/// The forms J and h of Lemma M28.
enum class Third { jacobian, normal };

/// Lemma M29: the codimension of the multiples of degree d of q_1, q_2 and one more form among all
/// forms of this degree. It is found by values at random points, so it is at most what is returned.
inline std::size_t codimension(const std::array<BilinearMap, 2>& maps, Third third, std::size_t d,
                               Numbers& random) {
    const std::size_t dimension = (d + 1) * (d + 2) / 2;
    Matrix values;
    for (std::size_t n = 0; n < dimension; ++n) {
        const Vector y{random(), random(), random()};
        const Star first = star(maps[0], y), second = star(maps[1], y);
        const bool jacobian = third == Third::jacobian;
        const Residue last =
            jacobian ? area(first.derivative, second.derivative) : area(first.g, second.g);
        values.emplace_back();
        for (const Residue m : ternary_monomials(y, d - 4)) {
            values.back().push_back(m * first.q);
            values.back().push_back(m * second.q);
        }
        for (const Residue m : ternary_monomials(y, d - (jacobian ? 6 : 4)))
            values.back().push_back(m * last);
    }
    return dimension - rank(values);
}

/// The matrix of D(M) of Lemma M30, for the line T of two basis vectors and the complement of the
/// others; m has the numbers of M.
inline Matrix derivative(const BilinearMap& map, const std::array<std::size_t, 2>& line,
                         const std::array<std::size_t, 2>& others,
                         const std::array<Residue, 4>& m) {
    std::array<Vector, 2> moved{Vector(4), Vector(4)};
    for (std::size_t a = 0; a < 2; ++a)
        for (std::size_t n = 0; n < 2; ++n)
            moved[a][others[n]] = m[2 * a + n];
    Matrix rows(2);
    for (const auto& [a, b] : {std::array<std::size_t, 2>{0, 0}, {0, 1}, {1, 1}}) {
        const Vector f = unit(4, line[a]), g = unit(4, line[b]);
        const Vector left = value(map, f, moved[b]), right = value(map, moved[a], g);
        const Vector old = value(map, f, g);
        for (std::size_t n = 0; n < 2; ++n)
            rows[n].push_back(left[others[n]] + right[others[n]] - m[n] * old[line[0]] -
                              m[2 + n] * old[line[1]]);
    }
    return rows;
}

/// Lemma M30: the rank of all products of linear forms and minors of both derivatives. It is found
/// by values, so it is at least what is returned. There are 20 cubic forms.
inline std::size_t rank_of_cubics(const std::array<BilinearMap, 2>& maps,
                                  const std::array<std::size_t, 2>& line,
                                  const std::array<std::size_t, 2>& others, Numbers& random) {
    Matrix values;
    for (std::size_t n = 0; n < 20; ++n) {
        const std::array<Residue, 4> m{random(), random(), random(), random()};
        values.emplace_back();
        for (const BilinearMap& map : maps) {
            const Matrix rows = derivative(map, line, others, m);
            for (const auto& [a, b] : {std::array<std::size_t, 2>{0, 1}, {0, 2}, {1, 2}})
                for (const Residue x : m)
                    values.back().push_back(x *
                                            (rows[0][a] * rows[1][b] - rows[0][b] * rows[1][a]));
        }
    }
    return rank(values);
}

/// The matrix of Lambda on Sym^2 of the line of two vectors, modulo the line, on which the two
/// forms vanish.
inline Matrix on_line(const BilinearMap& map, const Matrix& line, const Matrix& forms) {
    Matrix rows;
    for (const Vector& form : forms) {
        rows.emplace_back();
        for (const auto& [a, b] : {std::array<std::size_t, 2>{0, 0}, {0, 1}, {1, 1}}) {
            const Vector image = value(map, line[a], line[b]);
            Residue sum;
            for (std::size_t n = 0; n < 4; ++n)
                sum = sum + form[n] * image[n];
            rows.back().push_back(sum);
        }
    }
    return rows;
}

/// The ten points: the e_j of two, three, three pins in this order, but the first two; and the t_v.
inline std::vector<PointOfK> ten_points(const Matrix& images) {
    const auto places = points_of_pins({2, 3, 3});
    Matrix all;
    for (std::size_t j = 2; j < 8; ++j)
        all.push_back(unit(8, j));
    all.insert(all.end(), images.begin(), images.end());
    std::vector<PointOfK> points;
    for (const Vector& t : all) {
        const Vector x = modulo_forms(t, places); // by e_1, e_2, e_3, e_4, e_6, e_7
        points.push_back({x[0], x[1], x[2], x[3], x[4], x[5]});
    }
    return points;
}

/// The matrix of xi: K' -> W of a scene with these pins.
inline Matrix projection_of_scene(const std::vector<Pin>& pins) {
    const Matrix u = kernel_of(rows_of_H(pins), 8); // u_j is column j
    const Vector form =
        kernel_of({{u[0][0], u[1][0], u[2][0]}, {u[0][1], u[1][1], u[2][1]}}, 3).at(0);
    Matrix rows(2);
    for (const std::size_t j : std::array<std::size_t, 4>{2, 3, 5, 6}) {
        Residue factor;
        for (std::size_t i = 0; i < 3; ++i)
            factor = factor + form[i] * u[i][j];
        for (std::size_t n = 0; n < 2; ++n)
            rows[n].push_back(factor * pins[j].w[n]);
    }
    return rows;
}

} // namespace proofs
