#include "prover/problem/skeleton.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>
#include <tuple>

namespace plprove {

namespace {

using Code = std::vector<std::vector<int>>;

/// What an isomorphism keeps of a point: its pins, and the sizes of its lines.
std::vector<int> invariant(const Skeleton& skeleton, int point) {
    std::vector<int> result{skeleton.pins[static_cast<std::size_t>(point)]};
    for (const std::vector<int>& line : skeleton.lines)
        if (std::ranges::binary_search(line, point))
            result.push_back(static_cast<int>(line.size()));
    std::sort(result.begin() + 1, result.end());
    return result;
}

/// The lines through a point, by their numbers.
std::vector<int> lines_of(const Skeleton& skeleton, int point) {
    std::vector<int> numbers;
    for (std::size_t i = 0; i < skeleton.lines.size(); ++i)
        if (std::ranges::binary_search(skeleton.lines[i], point))
            numbers.push_back(static_cast<int>(i));
    return numbers;
}

/// Whether the point may come last among the points that are left: at most one of its lines has
/// two others of them.
bool may_come_last(const Skeleton& skeleton, int point, const std::vector<int>& left) {
    int carriers = 0;
    for (const int number : lines_of(skeleton, point)) {
        const std::vector<int>& line = skeleton.lines[static_cast<std::size_t>(number)];
        const auto on_line = std::ranges::count_if(
            left, [&](int other) { return std::ranges::binary_search(line, other); });
        carriers += on_line >= 3 ? 1 : 0;
    }
    return carriers <= 1;
}

/// The skeleton with point order[i] renamed i.
Code renamed(const Skeleton& skeleton, const std::vector<int>& order) {
    std::vector<int> place(order.size());
    Code code(1);
    for (std::size_t i = 0; i < order.size(); ++i) {
        place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
        code[0].push_back(skeleton.pins[static_cast<std::size_t>(order[i])]);
    }
    for (std::vector<int> line : skeleton.lines) {
        for (int& point : line)
            point = place[static_cast<std::size_t>(point)];
        std::ranges::sort(line);
        code.push_back(line);
    }
    std::sort(code.begin() + 1, code.end());
    return code;
}

/// The smallest code over all orders of the points in which their invariants ascend. Two skeletons
/// have the same if and only if they are isomorphic.
Code canonical_code(const Skeleton& skeleton) {
    std::vector<int> order(skeleton.pins.size());
    std::iota(order.begin(), order.end(), 0);
    const auto before = [&](int a, int b) {
        return invariant(skeleton, a) < invariant(skeleton, b);
    };
    std::ranges::stable_sort(order, before);
    Code best = renamed(skeleton, order);
    // Groups of points with equal invariants; all products of permutations of the groups.
    std::vector<std::pair<std::size_t, std::size_t>> groups;
    for (std::size_t i = 0; i < order.size(); ++i)
        if (i == 0 || before(order[i - 1], order[i]))
            groups.emplace_back(i, i + 1);
        else
            groups.back().second = i + 1;
    const auto next_order = [&] {
        return std::ranges::any_of(groups, [&](const auto& group) {
            const auto at = [&](std::size_t i) {
                return order.begin() + static_cast<std::ptrdiff_t>(i);
            };
            return std::next_permutation(at(group.first), at(group.second));
        });
    };
    while (next_order())
        best = std::min(best, renamed(skeleton, order));
    return best;
}

/// The skeletons with one point more: a free one, or one on a line through two points.
std::vector<Skeleton> with_one_more_point(const Skeleton& skeleton) {
    const int point = skeleton.points();
    Skeleton free = skeleton;
    free.pins.push_back(0);
    std::vector<Skeleton> result{free};
    for (std::size_t i = 0; i < skeleton.lines.size(); ++i) {
        result.push_back(free);
        result.back().lines[i].push_back(point);
    }
    for (int a = 0; a < point; ++a)
        for (int b = a + 1; b < point; ++b) {
            const bool joined = std::ranges::any_of(skeleton.lines, [&](const auto& line) {
                return std::ranges::binary_search(line, a) && std::ranges::binary_search(line, b);
            });
            if (joined) continue;
            result.push_back(free);
            result.back().lines.push_back({a, b, point});
        }
    return result;
}

/// One of each isomorphism class.
std::vector<Skeleton> up_to_isomorphism(const std::vector<Skeleton>& skeletons) {
    std::set<Code> known;
    std::vector<Skeleton> result;
    for (const Skeleton& skeleton : skeletons)
        if (known.insert(canonical_code(skeleton)).second) result.push_back(skeleton);
    return result;
}

} // namespace

int dependent_points(const Skeleton& skeleton) {
    int count = 0;
    for (const std::vector<int>& line : skeleton.lines)
        count += static_cast<int>(line.size()) - 2;
    return count;
}

std::vector<std::vector<Skeleton>> skeletons(int most_points) {
    std::vector<std::vector<Skeleton>> result{{Skeleton{}}};
    for (int points = 1; points <= most_points; ++points) {
        std::vector<Skeleton> larger;
        for (const Skeleton& skeleton : result.back()) {
            const std::vector<Skeleton> next = with_one_more_point(skeleton);
            larger.insert(larger.end(), next.begin(), next.end());
        }
        result.push_back(up_to_isomorphism(larger));
    }
    return result;
}

Skeleton in_order_of_lines(const Skeleton& skeleton) {
    std::vector<int> left(skeleton.pins.size());
    std::iota(left.begin(), left.end(), 0);
    std::vector<int> order;
    std::vector<int> lines_of_next;
    const auto rank = [&](int point) {
        const std::vector<int> lines = lines_of(skeleton, point);
        const int pins = skeleton.pins[static_cast<std::size_t>(point)];
        return std::tuple(lines.size(), lines != lines_of_next, -pins, -point);
    };
    while (!left.empty()) {
        std::vector<int> candidates;
        for (const int point : left)
            if (may_come_last(skeleton, point, left)) candidates.push_back(point);
        const int last = *std::ranges::min_element(candidates, {}, rank);
        lines_of_next = lines_of(skeleton, last);
        order.insert(order.begin(), last);
        std::erase(left, last);
    }
    const Code code = renamed(skeleton, order);
    return {code[0], {code.begin() + 1, code.end()}};
}

std::vector<Skeleton> with_pins(const Skeleton& skeleton, int pins) {
    std::vector<Skeleton> all;
    Skeleton current = skeleton;
    const std::function<void(std::size_t, int)> distribute = [&](std::size_t point, int left) {
        if (point == current.pins.size()) {
            if (left == 0) all.push_back(current);
            return;
        }
        for (int here = 0; here <= left; ++here) {
            current.pins[point] = here;
            distribute(point + 1, left - here);
        }
    };
    distribute(0, pins);
    return up_to_isomorphism(all);
}

} // namespace plprove
