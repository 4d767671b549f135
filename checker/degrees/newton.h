// Newton's method in doubles, from the starting values in a file towards a solution. It proves
// nothing: where it leads is tried in ball arithmetic.
#pragma once

#include "checker/degrees/evaluation.h"
#include "checker/degrees/krawczyk.h"

#include <cmath>
#include <complex>

namespace checker {
using Complex = std::complex<double>;

/// Linear equations: rows of coefficients, with the right side last.
using LinearEquations = std::array<std::array<Complex, camera_unknowns + 1>, camera_unknowns>;

/// Solves linear equations by elimination; garbage if it cannot.
inline CameraCoordinates<Complex> solve(LinearEquations m) {
    for (std::size_t c = 0; c < m.size(); ++c) {
        const auto size = [&](const auto& row) { return std::norm(row[c]); };
        const auto rest = m.begin() + std::ptrdiff_t(c);
        std::swap(m[c], *std::ranges::max_element(rest, m.end(), {}, size));
        for (std::size_t r = 0; r < m.size(); ++r) {
            if (r == c) continue;
            const Complex factor = m[r][c] / m[c][c];
            for (std::size_t k = c; k < m[r].size(); ++k)
                m[r][k] -= factor * m[c][k];
        }
    }
    CameraCoordinates<Complex> solution;
    for (std::size_t i = 0; i < m.size(); ++i)
        solution[i] = m[i].back() / m[i][i];
    return solution;
}

/// Newton's equations for the next change, at a point.
inline LinearEquations newton_equations(const CameraSystem& system,
                                        const CameraCoordinates<Complex>& z) {
    LinearEquations equations;
    BackProjections<Complex> space;
    back_project(system, z, space);
    for (std::size_t e = 0; e < equations.size(); ++e) {
        CameraCoordinates<Complex> row;
        equations[e].back() = evaluate(system, system.equations[e], space, row);
        std::copy(row.begin(), row.end(), equations[e].begin());
    }
    return equations;
}

/// Where at most eight Newton steps lead from the starting values.
inline CameraCoordinates<Complex> refine_by_newton(const CameraSystem& system,
                                                   const ApproximateSolution& start) {
    CameraCoordinates<Complex> z;
    const double unit = std::ldexp(1.0, -start.bits);
    for (std::size_t i = 0; i < z.size(); ++i) {
        const auto& [real, imaginary] = start.coordinates[i];
        z[i] = unit * Complex(double(real), double(imaginary));
    }
    double relative = 1; // size of the last step
    for (int step = 0; step < 8 && relative > 1e-10; ++step) {
        const CameraCoordinates<Complex> change = solve(newton_equations(system, z));
        relative = 0;
        for (std::size_t i = 0; i < z.size(); ++i) {
            z[i] -= start.real ? change[i].real() : change[i];
            relative = std::max(relative, std::abs(change[i]) / (1 + std::abs(z[i])));
        }
    }
    return z;
}
} // namespace checker
