#include "prover/many_views/distinct.h"

#include "prover/monodromy/solution_set.h"

namespace plprove::many_views {

namespace {

/// Where Newton's method leads; the approximation itself where that is far away.
Point refined(const System& system, const Images<Moving>& still, const Point& approximation) {
    constexpr int steps = 3;
    constexpr double far = 1e-5;
    Point point = approximation;
    Evaluation evaluation;
    for (int step = 0; step < steps; ++step)
        point -= system.newton_step(still, point, evaluation);
    const bool stayed = (point - approximation).norm() < far * (1 + approximation.norm());
    return stayed ? point : approximation; // also where the point is not finite
}

} // namespace

std::vector<Point> distinct_solutions(const System& system, const Images<Complex>& images,
                                      const std::vector<Point>& approximations) {
    const Images<Moving> still = on_the_way(images, images, 0);
    constexpr double near = 1e-7; // where Newton's method has refined
    SolutionSet<Point> seen(near);
    std::vector<Point> distinct;
    for (const Point& approximation : approximations) {
        const Point point = refined(system, still, approximation);
        if (seen.find(point)) continue;
        seen.add(point);
        distinct.push_back(approximation);
    }
    return distinct;
}

} // namespace plprove::many_views
