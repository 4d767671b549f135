// The quadrics of sections 2 and 3 of proofs/collinear_points_more_views.md, modulo the prime
// 2^61 - 1: through the points of K that images give, and the map A of a scene.
#pragma once

#include "proofs/computations/collinear_scene.h"
#include "proofs/computations/polynomials.h"
#include "proofs/computations/residue_matrices.h"

#include <vector>

namespace proofs {

using Vector = std::vector<Residue>;
using Matrix = std::vector<Vector>;

/// The points of the pins, by number of the pin.
inline std::vector<std::size_t> points_of_pins(const PinCounts& counts) {
    std::vector<std::size_t> points;
    for (std::size_t point = 0; point < counts.size(); ++point)
        points.insert(points.end(), counts[point], point);
    return points;
}

/// t in C^k modulo phi(L): subtracts what makes two coordinates 0, of pins at different points.
inline Vector modulo_forms(const Vector& t, const std::vector<std::size_t>& points) {
    const std::size_t a = t.size() - 1; // the last pin is at X_3, and some pin is not
    std::size_t b = a;
    while (points[b] == points[a])
        --b;
    const Pair f = form(points[a]), g = form(points[b]);
    const Residue scale = (f[0] * g[1] - f[1] * g[0]).inverse();
    Vector result;
    for (std::size_t j = 0; j < t.size(); ++j) {
        if (j == a || j == b) continue;
        const Pair h = form(points[j]);
        const Residue mu = (h[0] * g[1] - h[1] * g[0]) * scale;
        const Residue nu = (f[0] * h[1] - f[1] * h[0]) * scale;
        result.push_back(t[j] - mu * t[a] - nu * t[b]);
    }
    return result;
}

inline Vector unit(std::size_t size, std::size_t place) {
    Vector vector(size);
    vector[place] = Residue{1};
    return vector;
}

/// All monomials of a degree in three variables, at a point.
inline Vector ternary_monomials(const Vector& y, std::size_t degree) {
    Vector all;
    Residue a{1};
    for (std::size_t i = 0; i <= degree; ++i, a = a * y[0]) {
        Residue b = a;
        for (std::size_t j = 0; i + j <= degree; ++j, b = b * y[1]) {
            Residue c = b;
            for (std::size_t n = i + j; n < degree; ++n)
                c = c * y[2];
            all.push_back(c);
        }
    }
    return all;
}

/// The monomials of degree 2 at a point.
inline Vector monomials(const Vector& x) {
    Vector values;
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = i; j < x.size(); ++j)
            values.push_back(x[i] * x[j]);
    return values;
}

/// A basis of all quadratic forms in n variables that vanish at these points.
inline Matrix quadrics(const Matrix& points, std::size_t n) {
    Matrix conditions;
    for (const Vector& point : points)
        conditions.push_back(monomials(point));
    return kernel_of(conditions, n * (n + 1) / 2);
}

/// The symmetric matrix of twice a form.
inline Matrix symmetric(const Vector& form, std::size_t n) {
    Matrix matrix(n, Vector(n));
    std::size_t next = 0;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i; j < n; ++j, ++next) {
            matrix[i][j] = matrix[i][j] + form[next];
            matrix[j][i] = matrix[j][i] + form[next];
        }
    return matrix;
}

/// The rows s and (phi(a) omega(w)) of H, for bases of a and omega: five vectors in C^k.
inline Matrix rows_of_H(const std::vector<Pin>& pins) {
    Matrix rows(5);
    for (const Pin& pin : pins) {
        rows[0].push_back(pin.s);
        for (std::size_t n = 0; n < 4; ++n)
            rows[n + 1].push_back(form(pin.point)[n / 2] * pin.w[n % 2]);
    }
    return rows;
}

/// The map A on C^k, a row for each coordinate of U x W: t goes to the sum of t_j u_j x w_j. The
/// coordinates of U = C^k / H are forms that vanish on H.
inline Matrix map_of_scene(const std::vector<Pin>& pins) {
    Matrix rows;
    for (const Vector& coordinate : kernel_of(rows_of_H(pins), pins.size()))
        for (std::size_t n = 0; n < 2; ++n) {
            rows.emplace_back();
            for (std::size_t j = 0; j < pins.size(); ++j)
                rows.back().push_back(coordinate[j] * pins[j].w[n]);
        }
    return rows;
}

inline std::size_t rank(const Matrix& matrix) {
    return matrix[0].size() - kernel_of(matrix, matrix[0].size()).size();
}

} // namespace proofs
