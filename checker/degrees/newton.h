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
using LinearEquations = std::vector<std::vector<Complex>>;

/// Solves linear equations by elimination; garbage if it cannot.
inline std::vector<Complex> solve(LinearEquations m) {
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
    std::vector<Complex> solution(m.size());
    for (std::size_t i = 0; i < m.size(); ++i)
        solution[i] = m[i].back() / m[i][i];
    return solution;
}

/// Newton's equations for the next change, at a point.
template <class Equations>
LinearEquations newton_equations(Equations& equations, const std::vector<Complex>& z) {
    LinearEquations result;
    equations.move_to(z);
    for (std::size_t e = 0; e < z.size(); ++e) {
        std::vector<Complex>& row = result.emplace_back(z.size());
        row.push_back(equations.equation(e, row));
    }
    return result;
}

/// Where at most eight Newton steps lead from the starting values.
template <template <class> class At, class System>
std::vector<Complex> refine_by_newton(const System& system, const ApproximateSolution& start) {
    At<Complex> equations(system);
    std::vector<Complex> z(start.coordinates.size());
    const double unit = std::ldexp(1.0, -start.bits);
    for (std::size_t i = 0; i < z.size(); ++i) {
        const auto& [real, imaginary] = start.coordinates[i];
        z[i] = unit * Complex(double(real), double(imaginary));
    }
    double relative = 1; // size of the last step
    for (int step = 0; step < 8 && relative > 1e-10; ++step) {
        const std::vector<Complex> change = solve(newton_equations(equations, z));
        relative = 0;
        for (std::size_t i = 0; i < z.size(); ++i) {
            z[i] -= start.real ? change[i].real() : change[i];
            relative = std::max(relative, std::abs(change[i]) / (1 + std::abs(z[i])));
        }
    }
    return z;
}
} // namespace checker
