#include "checker/family/rows.h"

#include "checker/family/degree_bound.h"
#include "checker/reasons/part.h"

#include <array>

namespace checker {
static bool four_on_a_line(const Problem& problem) {
    const auto has_four = [](const Line& line) { return line.points.size() >= 4; };
    return std::ranges::any_of(problem.lines, has_four);
}

/// Whether all points, six of them, lie in the span of some three.
static bool six_in_a_plane(const Problem& problem) {
    const std::size_t count = problem.points.size();
    if (count != 6) return false;
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t j = 0; j < k; ++j)
            for (std::size_t i = 0; i < j; ++i) {
                const Span span = span_of(problem, {i, j, k}, {});
                if (std::ranges::count(span.points, true) == 6) return true;
            }
    return false;
}

static int views_of(const ProblemVerdict& verdict) {
    return std::popcount(verdict.problem.views);
}

/// Counts the verdicts that satisfy the condition.
template <class Condition>
static std::size_t count(const ProblemsFile& file, const Condition& condition) {
    return static_cast<std::size_t>(std::ranges::count_if(file.verdicts, condition));
}

static std::vector<FamilyRow> rows_by_views(const ProblemsFile& file) {
    std::vector<FamilyRow> rows{{"balanced", file.verdicts.size()},
                                {"minimal", count(file, &ProblemVerdict::minimal)}};
    int most = 0;
    for (const ProblemVerdict& verdict : file.verdicts)
        if (verdict.minimal) most = std::max(most, views_of(verdict));
    for (int views = 2; views <= most; ++views) {
        const auto counts = [&](const ProblemVerdict& v) {
            return v.minimal && views_of(v) == views;
        };
        rows.push_back({say("minimal, in ", views, " views"), count(file, counts)});
    }
    return rows;
}

static std::vector<FamilyRow> projective_rows(const ProblemsFile& file) {
    const auto points = [](const ProblemVerdict& v) { return v.problem.points.size(); };
    const auto few = [&](const ProblemVerdict& v) { return points(v) < 7; };
    const auto few_minimal = [&](const ProblemVerdict& v) { return few(v) && v.minimal; };
    const auto few_not_minimal = [&](const ProblemVerdict& v) { return few(v) && !v.minimal; };
    const auto candidate = [&](const ProblemVerdict& v) {
        return few_not_minimal(v) && !four_on_a_line(v.problem) && !six_in_a_plane(v.problem);
    };
    const auto seven_in_two = [&](const ProblemVerdict& v) {
        return v.minimal && points(v) == 7 && views_of(v) == 2;
    };
    const auto seven_in_three = [&](const ProblemVerdict& v) {
        return v.minimal && points(v) == 7 && views_of(v) == 3;
    };
    const auto counted_once = [&](const ProblemVerdict& v) {
        return v.minimal && (few(v) || views_of(v) == 2);
    };
    const auto one_solution = [&](const ProblemVerdict& v) {
        return counted_once(v) && degree_bound(v.problem) == 1U;
    };
    return {{"balanced, fewer than seven points", count(file, few)},
            {"minimal, fewer than seven points", count(file, few_minimal)},
            {"not minimal, fewer than seven points", count(file, few_not_minimal)},
            {"- no four on a line, no six in a plane", count(file, candidate)},
            {"minimal, seven points in two views", count(file, seven_in_two)},
            {"minimal, seven points in three views", count(file, seven_in_three)},
            {"minimal", count(file, counted_once)},
            {"- with one solution", count(file, one_solution)}};
}

std::vector<FamilyRow> rows_of(const ProblemsFile& file) {
    if (file.family.empty() || file.missing > 0) return {};
    return file.family == projective_cameras.name ? projective_rows(file) : rows_by_views(file);
}
} // namespace checker
