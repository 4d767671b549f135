#include "prover/problem/complete_visibility.h"

#include "prover/problem/notation.h"
#include "prover/problem/skeleton.h"

#include <algorithm>

namespace plprove {

namespace {

Problem problem_of(const Skeleton& any_order, int free_lines, const CameraModel& model, int views) {
    const Skeleton skeleton = in_order_of_lines(any_order);
    const ViewSet all = all_views(views);
    Problem problem{&model, views, {}, {}};
    for (int point = 0; point < skeleton.points(); ++point) {
        problem.points.push_back(all);
        const int pins = skeleton.pins[static_cast<std::size_t>(point)];
        problem.lines.insert(problem.lines.end(), static_cast<std::size_t>(pins), {{point}, all});
    }
    for (const std::vector<int>& line : skeleton.lines)
        problem.lines.push_back({line, all});
    problem.lines.insert(problem.lines.end(), static_cast<std::size_t>(free_lines), {{}, all});
    return parse_problem(notation(problem));
}

/// What the images of points and lines constrain beyond the scene, and what a free line and a pin
/// add to that.
struct Balance {
    int missing;
    int free_line;
    int pin;
};

Balance balance(const Skeleton& skeleton, const CameraModel& model, int views) {
    const int dependent = dependent_points(skeleton);
    const int free = skeleton.points() - dependent;
    const int points = (2 * views - 3) * free + (views - 1) * dependent;
    return {model.dimension(views) - points, 2 * views - 4, views - 2};
}

/// The balanced problems with this skeleton, and any free lines and pins.
void add_balanced(const Skeleton& skeleton, const CameraModel& model, int views,
                  std::vector<Problem>& problems) {
    const Balance needed = balance(skeleton, model, views);
    if (views == 2) {
        if (needed.missing == 0) problems.push_back(problem_of(skeleton, 0, model, views));
        return;
    }
    for (int free_lines = 0; free_lines * needed.free_line <= needed.missing; ++free_lines) {
        const int rest = needed.missing - free_lines * needed.free_line;
        if (rest % needed.pin != 0) continue;
        for (const Skeleton& pinned : with_pins(skeleton, rest / needed.pin))
            problems.push_back(problem_of(pinned, free_lines, model, views));
    }
}

} // namespace

std::string_view family_name(const CameraModel& cameras) {
    return &cameras == &calibrated_cameras ? "plmp" : cameras.name;
}

const CameraModel* family_named(std::string_view name) {
    for (const CameraModel* cameras : camera_models())
        if (family_name(*cameras) == name) return cameras;
    return nullptr;
}

/// The bounds are those of proofs/families.md, Theorem 10.
std::vector<Problem> family_problems(const CameraModel& cameras) {
    const int of_two = cameras.dimension(2);
    const bool two_views = of_two <= projective_cameras.dimension(2);
    const int of_skeletons = std::max(two_views ? of_two : 0, (cameras.unknowns + of_two - 2) / 2);
    const std::vector<std::vector<Skeleton>> by_points = skeletons(of_skeletons);
    std::vector<Problem> problems;
    for (int views = two_views ? 2 : 3; views <= std::min(of_two + 2, most_views); ++views)
        for (const std::vector<Skeleton>& same_size : by_points)
            for (const Skeleton& skeleton : same_size)
                if (skeleton.points() < of_two || views <= 3)
                    add_balanced(skeleton, cameras, views, problems);
    return problems;
}

PlmpNumbers counts(const Problem& problem) {
    PlmpNumbers result;
    int most_on_a_line = std::min(2, static_cast<int>(problem.points.size()));
    int most_at_a_point = 0;
    for (int point = 0; point < static_cast<int>(problem.points.size()); ++point) {
        ++(carrier(problem, point) ? result.dependent_points : result.free_points);
        int pins = 0;
        for (const int number : lines_through(problem, point))
            pins += problem.lines[static_cast<std::size_t>(number)].points.size() == 1 ? 1 : 0;
        most_at_a_point = std::max(most_at_a_point, pins);
    }
    for (const Line& line : problem.lines) {
        result.free_lines += line.points.empty() ? 1 : 0;
        result.adjacent_lines += line.points.size() == 1 ? 1 : 0;
        most_on_a_line = std::max(most_on_a_line, static_cast<int>(line.points.size()));
    }
    result.alpha = problem.views == 2 ? most_on_a_line : most_at_a_point;
    return result;
}

std::string name(const Problem& problem) {
    const PlmpNumbers numbers = counts(problem);
    return std::to_string(numbers.free_points) + std::to_string(numbers.dependent_points) +
           std::to_string(numbers.free_lines) + std::to_string(numbers.adjacent_lines) + '_' +
           std::to_string(numbers.alpha);
}

} // namespace plprove
