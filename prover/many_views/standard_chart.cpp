#include "prover/many_views/standard_chart.h"

#include "prover/monodromy/solution_set.h"

namespace plprove::many_views {

bool is_real(const Point& point) {
    constexpr double small_imaginary_part = 1e-8; // relative
    return has_near_coordinates(point, Point(point.conjugate()), 2 * small_imaginary_part);
}

Point in_standard_chart(const System& system, const Point& point) {
    const CameraModel& model = *system.problem().cameras;
    const CameraChart& chart = system.chart();
    Point result(point.size());
    Complex depths = 1;
    const Point coordinates = point.tail(chart.dimension());
    result.segment(system.depths(), chart.shared()) = coordinates.head(chart.shared());
    for (std::size_t view = 1; view < static_cast<std::size_t>(chart.views()); ++view) {
        Eigen::VectorXcd numbers = chart.numbers(view, coordinates);
        model.normalise(numbers.data(), view == 1, depths);
        result.segment(system.depths() + chart.offset(view), chart.coordinates(view)) =
            numbers(model.coordinates(view == 1));
    }
    result.head(system.depths()) = point.head(system.depths()) * depths;
    return result;
}

std::optional<Point> refined(const System& system, const Images<Moving>& images, Point point,
                             Evaluation& room) {
    constexpr int most_steps = 8;
    constexpr double small_step = 1e-10, last_step = 1e-7;
    double relative = 1;
    for (int step = 0; step < most_steps && relative > small_step; ++step) {
        const Point change = system.newton_step(images, point, room);
        point -= change;
        relative = (change.array().abs() / (1 + point.array().abs())).maxCoeff();
    }
    if (!point.allFinite() || !(relative < last_step)) return std::nullopt;
    return point;
}

} // namespace plprove::many_views
