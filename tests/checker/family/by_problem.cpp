// Problems are found and counted whatever the names of their points and lines, in few steps; where
// these do not decide, nothing is taken for the same, and nothing counts twice.
#include "checker/family/by_problem.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <numeric>
#include <random>
#include <variant>

using namespace checker;

namespace {

/// Which points are on each line.
using Lines = std::vector<Indices>;

/// The problem in two views that see everything.
Problem problem_of(std::size_t points, const Lines& lines) {
    Problem problem{.views = 0b11, .points = std::vector<Point>(points, {.seen_by = 0b11})};
    for (Indices line : lines) {
        std::ranges::sort(line);
        for (const std::size_t point : line)
            problem.points[point].lines.push_back(problem.lines.size());
        problem.lines.push_back({.seen_by = 0b11, .points = line});
    }
    return problem;
}

/// Cycles of these lengths, of points. A line passes through each two neighbours.
Problem cycles(const std::vector<std::size_t>& lengths) {
    Lines lines;
    std::size_t first = 0;
    for (const std::size_t length : lengths) {
        for (std::size_t i = 0; i < length; ++i)
            lines.push_back({first + i, first + (i + 1) % length});
        first += length;
    }
    return problem_of(first, lines);
}

/// The 64 points and 24 lines of a Latin square of order 8: its rows, columns and letters.
Problem net(const auto& letter) {
    Lines lines(24);
    for (std::size_t i = 0; i < 8; ++i)
        for (std::size_t j = 0; j < 8; ++j)
            for (const std::size_t line : {i, 8 + j, 16 + letter(i, j)})
                lines[line].push_back(8 * i + j);
    return problem_of(64, lines);
}

Problem cyclic_net() {
    return net([](std::size_t i, std::size_t j) { return (i + j) % 8; });
}

Problem elementary_net() {
    return net([](std::size_t i, std::size_t j) { return i ^ j; });
}

/// The same problem by other names.
Problem renamed(const Problem& problem, std::mt19937& random) {
    Indices names(problem.points.size());
    std::iota(names.begin(), names.end(), std::size_t{0});
    std::ranges::shuffle(names, random);
    Lines lines;
    for (const Line& line : problem.lines) {
        Indices& points = lines.emplace_back();
        for (const std::size_t point : line.points)
            points.push_back(names[point]);
    }
    std::ranges::shuffle(lines, random);
    return problem_of(names.size(), lines);
}

std::optional<bool> same(const Problem& a, const Problem& b, std::size_t steps = 20'000) {
    return isomorphic(a, b, steps);
}

/// By a second method: all renamings of the points are tried.
bool same_by_trying(const Problem& a, const Problem& b) {
    const auto lines_of = [](const Problem& problem, const Indices& names) {
        Lines lines;
        for (const Line& line : problem.lines) {
            Indices& points = lines.emplace_back();
            for (const std::size_t point : line.points)
                points.push_back(names[point]);
            std::ranges::sort(points);
        }
        std::ranges::sort(lines);
        return lines;
    };
    Indices names(a.points.size());
    std::iota(names.begin(), names.end(), std::size_t{0});
    const Lines due = lines_of(b, names);
    do
        if (lines_of(a, names) == due) return true;
    while (std::ranges::next_permutation(names).found);
    return false;
}

/// Six points, and lines with one, two or three of them. Two lines share at most one point.
Problem random_problem(std::mt19937& random) {
    Lines lines;
    for (int tries = 0; tries < 9; ++tries) {
        Indices line;
        for (std::size_t size = 1 + random() % 3; line.size() < size;) {
            const std::size_t point = random() % 6;
            if (std::ranges::count(line, point) == 0) line.push_back(point);
        }
        const auto crosses = [&](const Indices& other) {
            return std::ranges::count_if(line, [&](std::size_t point) {
                       return std::ranges::count(other, point) > 0;
                   }) > 1;
        };
        if (std::ranges::none_of(lines, crosses)) lines.push_back(line);
    }
    return problem_of(6, lines);
}

} // namespace

TEST_CASE("small problems are the same if some renaming of points takes one to the other") {
    std::mt19937 random(1);
    std::map<Invariant, std::vector<Problem>> problems;
    std::size_t equal = 0, other = 0;
    for (int i = 0; i < 1500; ++i) {
        const Problem problem = random_problem(random);
        for (const Problem& before : problems[invariant(problem)]) {
            const bool due = same_by_trying(problem, before);
            CHECK(same(problem, before) == due);
            ++(due ? equal : other);
        }
        problems[invariant(problem)].push_back(problem);
    }
    CHECK(equal > 100);
    CHECK(other > 100);
}

TEST_CASE("problems of many points are told apart in few steps") {
    CHECK(invariant(cycles({12, 12})) == invariant(cycles({24})));
    CHECK(same(cycles({12, 12}), cycles({24})) == false);
    CHECK(same(cycles({3, 3, 3, 3, 3, 3, 4, 4}), cycles({3, 3, 3, 3, 3, 3, 3, 5})) == false);
    // Ten points hang on each line of the cycles.
    const auto with_more = [](Problem problem) {
        for (std::size_t line = 0; line < 6; ++line)
            for (int i = 0; i < 10; ++i) {
                problem.lines[line].points.push_back(problem.points.size());
                problem.points.push_back({.seen_by = 0b11, .lines = {line}});
            }
        return problem;
    };
    CHECK(same(with_more(cycles({3, 3})), with_more(cycles({6}))) == false);
}

TEST_CASE("a problem of many points is the same by other names") {
    std::mt19937 random(2);
    for (const Problem& problem :
         {cycles({12, 12}), cycles({3, 3, 3, 3, 3, 3, 4, 4}), cycles({24}), problem_of(100, {})})
        for (int i = 0; i < 5; ++i)
            CHECK(same(problem, renamed(problem, random)) == true);
}

TEST_CASE("who sees what, and the cameras, belong to a problem") {
    const Problem one = cycles({5});
    Problem hidden_point = one, hidden_line = one, projective = one;
    hidden_point.points[0].seen_by = 0b01;
    hidden_line.lines[0].seen_by = 0b01;
    projective.cameras = &projective_cameras;
    ByProblem<int> all;
    for (const Problem& problem : {one, hidden_point, hidden_line, projective})
        all[problem] = 1;
    CHECK(all.count() == 4);
}

TEST_CASE("each problem has one value, and counts once") {
    std::mt19937 random(3);
    ByProblem<int> all;
    const std::vector problems{cycles({12, 12}), cycles({24}), cycles({6, 18})};
    for (int i = 0; i < 30; ++i)
        ++all[renamed(problems[static_cast<std::size_t>(i) % 3], random)];
    CHECK(all.count() == 3);
    for (const Problem& problem : problems) {
        const int* value = all.find(problem);
        REQUIRE(value);
        CHECK(*value == 10);
    }
    CHECK(!all.find(cycles({8, 16})));
}

TEST_CASE("where the steps do not decide, a problem is not found, and does not count again") {
    CHECK(same(cyclic_net(), elementary_net(), 1000) == std::nullopt);
    std::size_t steps = 100;
    CHECK(isomorphic(cycles({12, 12}), cycles({24}), steps) == std::nullopt);
    CHECK(steps == 0);
    ByProblem<int> all;
    all[cyclic_net()] = 1;
    CHECK(!all.find(elementary_net()));
    all[elementary_net()] = 2; // it may be the first
    CHECK(all.count() == 1);
    CHECK(*all.find(cyclic_net()) == 1);
}
