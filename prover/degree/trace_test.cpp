#include "prover/degree/trace_test.h"

#include <algorithm>
#include <set>

namespace plprove {

namespace {

/// One for each kind of equation and choice of views: images that move in one view only may leave a
/// part of the problem as it is.
std::vector<TracePencil> pencils(const CameraSystem& system, const std::vector<Complex3>& constants,
                                 const Images& images, Random& random) {
    std::vector<TracePencil> result;
    std::set<std::pair<EquationKind, std::array<int, 3>>> covered;
    for (std::size_t f = 0; f < system.free.size(); ++f) {
        const int index = system.free[f].single_equation;
        if (index < 0) continue;
        const CameraEquation& equation = system.equations[static_cast<std::size_t>(index)];
        std::array<int, 3> views{-1, -1, -1};
        for (std::size_t k = 0; k < 3; ++k)
            if (equation.vectors[k] >= 0)
                views[k] = system.vectors[static_cast<std::size_t>(equation.vectors[k])].view;
        if (!covered.emplace(equation.kind, views).second) continue;
        Images line = images, direction = images, across = images;
        direction[f] = random.complex3();
        across[f] = random.complex3();
        for (std::size_t k = 0; k < 3; ++k)
            line[f][k] += direction[f][k];
        result.push_back({index, moving_images(system, constants, images, line),
                          moving_images(system, constants, direction, direction),
                          moving_images(system, constants, across, across)});
    }
    return result;
}

} // namespace

std::optional<double> trace_residual(const CameraSystem& system, const CameraChart& chart,
                                     const std::vector<Complex3>& constants, const Images& images,
                                     std::span<const CameraPoint> solutions, Random& random) {
    const std::vector<TracePencil> moving = pencils(system, constants, images, random);
    if (moving.empty()) return std::nullopt;
    std::vector<TraceTerm> terms(solutions.size() * moving.size());
    fastest_trace()(tracked_system(system, chart), moving.data(), moving.size(), solutions.size(),
                    solutions.data(), terms.data());
    std::optional<double> residual;
    for (std::size_t p = 0; p < moving.size(); ++p) {
        Complex sum;
        double sizes = 0, others = 0;
        for (std::size_t i = p; i < terms.size(); i += moving.size()) {
            sum += terms[i].quadratic;
            sizes += std::abs(terms[i].quadratic);
            others += std::abs(terms[i].linear) + std::abs(terms[i].constant);
        }
        // If phi is linear for each solution, its quadratic coefficient is nothing but rounding,
        // and says nothing.
        constexpr double rounding = 1e-11;
        if (sizes < rounding * others) continue;
        residual = std::max(residual.value_or(0), std::abs(sum) / sizes);
    }
    return residual;
}

} // namespace plprove
