#include "prover/problem/problem.h"

#include <algorithm>
#include <map>

namespace plprove {

namespace {

/// The letters of lines with two points or more, in the order in which they are used.
constexpr std::string_view shared_letters = "LMNOQRSTUVWXYZABCDEFGHIJK";

/// The letters of the lines that need one; 0 for others. In the order in which they are used, point
/// by point.
std::vector<char> letters_of_lines(const Problem& problem) {
    std::vector<char> letters(problem.lines.size(), 0);
    std::size_t used = 0;
    for (int point = 0; point < static_cast<int>(problem.points.size()); ++point)
        for (const int number : lines_through(problem, point)) {
            char& letter = letters[static_cast<std::size_t>(number)];
            const bool shared = problem.lines[static_cast<std::size_t>(number)].points.size() > 1;
            if (!shared || letter != 0) continue;
            if (used == shared_letters.size())
                throw NotationError("there are letters for 25 lines with two points or more: leave "
                                    "some of these lines out");
            letter = shared_letters[used++];
        }
    return letters;
}

/// The feature without lines, in `views` views.
Feature feature_without_lines(bool has_point, int views, ViewSet seen) {
    Feature feature{has_point, 0, std::vector<Sight>(static_cast<std::size_t>(views))};
    for (int view = 0; view < views; ++view)
        feature.sights[static_cast<std::size_t>(view)].point = contains(seen, view);
    return feature;
}

void refuse_too_many(const Problem& problem) {
    if (problem.points.size() > most_points || problem.lines.size() > most_lines)
        throw NotationError("a problem has at most 100 points and 100 lines: leave some out");
}

std::string point_name(int point) {
    return "point " + std::to_string(point + 1);
}

void refuse_common_points(const Line& one, const Line& other) {
    std::vector<int> common;
    std::ranges::set_intersection(one.points, other.points, std::back_inserter(common));
    if (common.size() < 2) return;
    throw NotationError(point_name(common[0]) + " and " + point_name(common[1]) +
                        " lie on two lines, but two lines share at most one point: give both "
                        "lines one letter");
}

void refuse_unseen_line(const Problem& problem, const Line& line) {
    for (int view = 0; view < problem.views; ++view) {
        const std::vector<int> seen = seen_points(problem, line, view);
        if (seen.size() < 2 || contains(line.seen, view)) continue;
        throw NotationError("view " + std::to_string(view + 1) + " sees " + point_name(seen[0]) +
                            " and " + point_name(seen[1]) +
                            ", so it sees the line through them: write its letter in view " +
                            std::to_string(view + 1));
    }
}

void refuse_unseen_point(const Problem& problem, int point) {
    for (int view = 0; view < problem.views; ++view) {
        if (contains(problem.points[static_cast<std::size_t>(point)], view)) continue;
        int seen_lines = 0;
        for (const int number : lines_through(problem, point))
            seen_lines +=
                contains(problem.lines[static_cast<std::size_t>(number)].seen, view) ? 1 : 0;
        if (seen_lines < 2) continue;
        throw NotationError("view " + std::to_string(view + 1) + " sees two lines of " +
                            point_name(point) + ", so it sees the point: write 'P' there");
    }
}

/// Of `points`, how many are less than `bound`.
int count_below(const std::vector<int>& points, int bound) {
    return static_cast<int>(std::ranges::count_if(points, [&](int x) { return x < bound; }));
}

/// A point that may be constructed last of those not `done`: at most one of its lines has two
/// others of them. The last such point, so that a valid order stays as it is.
std::optional<int> last_point(const Problem& problem, const std::vector<bool>& done) {
    for (int point = static_cast<int>(problem.points.size()) - 1; point >= 0; --point) {
        if (done[static_cast<std::size_t>(point)]) continue;
        int carriers = 0;
        for (const int number : lines_through(problem, point)) {
            const std::vector<int>& on_line =
                problem.lines[static_cast<std::size_t>(number)].points;
            const auto left = std::ranges::count_if(
                on_line, [&](int x) { return !done[static_cast<std::size_t>(x)]; });
            carriers += left >= 3 ? 1 : 0;
        }
        if (carriers <= 1) return point;
    }
    return std::nullopt;
}

/// The problem whose point i is point order[i] of `problem`.
Problem reordered(const Problem& problem, const std::vector<int>& order) {
    Problem result = problem;
    std::vector<int> place(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
        result.points[i] = problem.points[static_cast<std::size_t>(order[i])];
    }
    for (Line& line : result.lines) {
        for (int& point : line.points)
            point = place[static_cast<std::size_t>(point)];
        std::ranges::sort(line.points);
    }
    return result;
}

} // namespace

Problem problem_of(const Features& features, const CameraModel& cameras) {
    Problem problem{&cameras, features.front().views(), {}, {}};
    std::map<char, std::size_t> numbers; // of shared lines
    for (const Feature& feature : features) {
        const int point = static_cast<int>(problem.points.size());
        if (feature.has_point) {
            problem.points.push_back(0);
            for (int view = 0; view < problem.views; ++view)
                if (feature.sees_point(view)) problem.points.back() |= ViewSet{1} << view;
        }
        for (int line = 0; line < feature.lines; ++line) {
            std::size_t number = problem.lines.size();
            if (static_cast<std::size_t>(line) < feature.shared.size())
                number = numbers.emplace(letter_of(feature, line), number).first->second;
            if (number == problem.lines.size())
                problem.lines.push_back({{}, views_of(feature, line)});
            if (feature.has_point) problem.lines[number].points.push_back(point);
        }
        refuse_too_many(problem);
    }
    return problem;
}

Features features_of(const Problem& problem) {
    const std::vector<char> letters = letters_of_lines(problem);
    const auto line = [&](int number) { return problem.lines[static_cast<std::size_t>(number)]; };
    const auto letter = [&](int number) { return letters[static_cast<std::size_t>(number)]; };
    Features features;
    for (int point = 0; point < static_cast<int>(problem.points.size()); ++point) {
        Feature& feature = features.emplace_back(feature_without_lines(
            true, problem.views, problem.points[static_cast<std::size_t>(point)]));
        std::vector<int> through = lines_through(problem, point);
        // Shared lines by their letters, then pins in their order.
        std::ranges::stable_sort(
            through, {}, [&](int number) { return letter(number) == 0 ? 'z' : letter(number); });
        for (const int number : through) {
            if (letter(number) != 0) feature.shared += letter(number);
            show_line(feature, feature.lines++, line(number).seen);
        }
        if (feature.lines - std::ssize(feature.shared) > max_pins)
            throw NotationError("there are letters for 26 lines through one point that meet no "
                                "other: leave some of these lines out");
    }
    for (const Line& free : problem.lines) {
        if (!free.points.empty()) continue;
        features.push_back(feature_without_lines(false, problem.views, 0));
        features.back().lines = 1;
        show_line(features.back(), 0, free.seen);
    }
    return features;
}

std::optional<Features> features_without_implied_lines(const Problem& problem) {
    Problem rest = problem;
    std::erase_if(rest.lines, [&](const Line& line) {
        return line.points.size() == 2 && std::ranges::all_of(line.points, [&](int point) {
                   return (line.seen & ~problem.points[static_cast<std::size_t>(point)]) == 0;
               });
    });
    const bool shared =
        std::ranges::any_of(rest.lines, [](const Line& line) { return line.points.size() > 1; });
    return shared ? std::nullopt : std::optional(features_of(rest));
}

std::optional<Features> local_features(const Problem& problem) {
    if (problem.cameras != &calibrated_cameras || problem.views > 3) return std::nullopt;
    return features_without_implied_lines(problem);
}

void refuse_invalid(const Problem& problem) {
    refuse_too_many(problem);
    for (std::size_t i = 0; i < problem.lines.size(); ++i)
        for (std::size_t j = i + 1; j < problem.lines.size(); ++j)
            refuse_common_points(problem.lines[i], problem.lines[j]);
    for (const Line& line : problem.lines)
        refuse_unseen_line(problem, line);
    for (int point = 0; point < static_cast<int>(problem.points.size()); ++point)
        refuse_unseen_point(problem, point);
    if (!in_order_of_construction(problem))
        throw NotationError("the points cannot be chosen one after the other, each on at most one "
                            "line through two earlier points: leave out a point that the others "
                            "determine");
}

bool contains(const Line& line, int point) {
    return std::ranges::binary_search(line.points, point);
}

std::vector<int> lines_through(const Problem& problem, int point) {
    std::vector<int> numbers;
    for (std::size_t i = 0; i < problem.lines.size(); ++i)
        if (contains(problem.lines[i], point)) numbers.push_back(static_cast<int>(i));
    return numbers;
}

std::vector<int> seen_points(const Problem& problem, const Line& line, int view) {
    std::vector<int> points;
    for (const int point : line.points)
        if (contains(problem.points[static_cast<std::size_t>(point)], view))
            points.push_back(point);
    return points;
}

std::optional<int> carrier(const Problem& problem, int point) {
    for (const int number : lines_through(problem, point))
        if (count_below(problem.lines[static_cast<std::size_t>(number)].points, point) >= 2)
            return number;
    return std::nullopt;
}

int own_points(const Line& line) {
    return 2 - std::min(2, static_cast<int>(line.points.size()));
}

std::optional<Problem> in_order_of_construction(const Problem& problem) {
    std::vector<bool> done(problem.points.size(), false);
    std::vector<int> order;
    while (order.size() < problem.points.size()) {
        const std::optional<int> last = last_point(problem, done);
        if (!last) return std::nullopt;
        done[static_cast<std::size_t>(*last)] = true;
        order.push_back(*last);
    }
    std::ranges::reverse(order);
    return reordered(problem, order);
}

int dimension_in_space(const Problem& problem) {
    int dimension = 0;
    for (int point = 0; point < static_cast<int>(problem.points.size()); ++point)
        dimension += carrier(problem, point) ? 1 : 3;
    for (const Line& line : problem.lines)
        dimension += 2 * own_points(line);
    return dimension;
}

int dimension_in_view(const Problem& problem, int view) {
    int dimension = 0;
    for (const ViewSet seen : problem.points)
        dimension += contains(seen, view) ? 2 : 0;
    for (const Line& line : problem.lines) {
        if (!contains(line.seen, view)) continue;
        // With three seen points or more, each beyond the second loses one parameter.
        dimension += 2 - static_cast<int>(seen_points(problem, line, view).size());
    }
    return dimension;
}

int dimension_in_views(const Problem& problem) {
    int dimension = 0;
    for (int view = 0; view < problem.views; ++view)
        dimension += dimension_in_view(problem, view);
    return dimension;
}

bool is_balanced(const Problem& problem) {
    return dimension_in_space(problem) + problem.cameras->dimension(problem.views) ==
           dimension_in_views(problem);
}

} // namespace plprove
