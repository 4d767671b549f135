// Random problems in general, and points with random coordinates: the same for the same seed.
#pragma once

#include "prover/minimal/jacobian.h"

#include <algorithm>
#include <random>

namespace plprove {

class RandomArrangements {
public:
    explicit RandomArrangements(unsigned seed) : random_(seed) {}

    int below(int bound) { return static_cast<int>(random_() % static_cast<unsigned>(bound)); }

    /// Up to 6 views and 10 features, both camera models, any visibility that the rules allow.
    Problem problem() {
        Problem problem;
        problem.cameras = below(2) == 0 ? &calibrated_cameras : &projective_cameras;
        problem.views = 2 + below(5);
        const int points = below(9);
        for (int point = 0; point < points; ++point)
            add_point(problem);
        const int free_lines = points == 0 ? 1 + below(3) : below(3);
        for (int i = 0; i < free_lines; ++i)
            problem.lines.push_back({{}, some_views(problem.views)});
        close_visibility(problem);
        return problem;
    }

    Instance instance(const Problem& problem) {
        Instance instance;
        for (int view = 1; view < problem.views; ++view)
            instance.cameras.push_back(coordinates(problem.cameras->numbers));
        std::ranges::copy(problem.cameras->start_of_second, instance.cameras.front().begin());
        instance.scene = coordinates(scene_coordinates(problem));
        return instance;
    }

private:
    ViewSet some_views(int views) {
        ViewSet seen = 0;
        for (int view = 0; view < views; ++view)
            if (below(4) > 0) seen |= ViewSet{1} << view;
        return seen;
    }

    void add_point(Problem& problem) {
        const int point = static_cast<int>(problem.points.size());
        problem.points.push_back(some_views(problem.views));
        if (point >= 2 && below(2) == 0) put_on_line_through_two(problem, point);
        for (int pins = below(3); pins > 0; --pins)
            problem.lines.push_back({{point}, some_views(problem.views)});
    }

    /// On the line through two earlier points, which may have more.
    void put_on_line_through_two(Problem& problem, int point) {
        const int a = below(point);
        const int b = (a + 1 + below(point - 1)) % point;
        for (Line& line : problem.lines)
            if (contains(line, a) && contains(line, b)) {
                line.points.push_back(point);
                return;
            }
        problem.lines.push_back(
            {{std::min(a, b), std::max(a, b), point}, some_views(problem.views)});
    }

    /// A view sees a line with two seen points, and a point with two seen lines.
    static void close_visibility(Problem& problem) {
        for (int round = 0; round < 100; ++round)
            for (int view = 0; view < problem.views; ++view) {
                const ViewSet bit = ViewSet{1} << view;
                for (Line& line : problem.lines)
                    if (seen_points(problem, line, view).size() >= 2) line.seen |= bit;
                for (std::size_t i = 0; i < problem.points.size(); ++i) {
                    const auto through = lines_through(problem, static_cast<int>(i));
                    const auto seen = std::ranges::count_if(through, [&](int number) {
                        return contains(problem.lines[static_cast<std::size_t>(number)].seen, view);
                    });
                    if (seen >= 2) problem.points[i] |= bit;
                }
            }
    }

    std::vector<std::int64_t> coordinates(int count) {
        std::vector<std::int64_t> result;
        for (int i = 0; i < count; ++i)
            result.push_back(below(1999999) - 999999);
        return result;
    }

    std::mt19937 random_;
};

} // namespace plprove
