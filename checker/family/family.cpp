#include "checker/family/family.h"

#include "checker/family/degree_bound.h"
#include "checker/minimal/part.h"

namespace checker {
using Verdict = ProblemVerdict;

static bool any(const Verdict&) {
    return true;
}

static bool is_minimal(const Verdict& verdict) {
    return verdict.minimal;
}

static int views_of(const Verdict& verdict) {
    return std::popcount(verdict.problem.views);
}

template <int views> static bool is_minimal_in(const Verdict& verdict) {
    return verdict.minimal && views_of(verdict) == views;
}

static bool has_few_points(const Verdict& verdict) {
    return verdict.problem.points.size() < 7;
}

static bool few_points_minimal(const Verdict& verdict) {
    return has_few_points(verdict) && verdict.minimal;
}

static bool few_points_not_minimal(const Verdict& verdict) {
    return has_few_points(verdict) && !verdict.minimal;
}

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

static bool not_minimal_in_general_position(const Verdict& verdict) {
    return few_points_not_minimal(verdict) && !four_on_a_line(verdict.problem) &&
           !six_in_a_plane(verdict.problem);
}

template <int views> static bool seven_points_minimal_in(const Verdict& verdict) {
    return is_minimal_in<views>(verdict) && verdict.problem.points.size() == 7;
}

/// Problems with seven points that are minimal in any number of views count in two.
static bool minimal_once(const Verdict& verdict) {
    return verdict.minimal && (has_few_points(verdict) || views_of(verdict) == 2);
}

static bool one_solution(const Verdict& verdict) {
    return minimal_once(verdict) && degree_bound(verdict.problem) == 1U;
}

static constexpr std::array numbers_of_plmp{
    FamilyNumber{"balanced", any},
    FamilyNumber{"minimal", is_minimal},
    FamilyNumber{"minimal, in 2 views", is_minimal_in<2>},
    FamilyNumber{"minimal, in 3 views", is_minimal_in<3>},
    FamilyNumber{"minimal, in 4 views", is_minimal_in<4>},
    FamilyNumber{"minimal, in 5 views", is_minimal_in<5>},
    FamilyNumber{"minimal, in 6 views", is_minimal_in<6>},
};

static constexpr std::array numbers_of_projective{
    FamilyNumber{"balanced, fewer than seven points", has_few_points},
    FamilyNumber{"minimal, fewer than seven points", few_points_minimal},
    FamilyNumber{"not minimal, fewer than seven points", few_points_not_minimal},
    FamilyNumber{"- no four on a line, no six in a plane", not_minimal_in_general_position},
    FamilyNumber{"minimal, seven points in two views", seven_points_minimal_in<2>},
    FamilyNumber{"minimal, seven points in three views", seven_points_minimal_in<3>},
    FamilyNumber{"minimal", minimal_once},
    FamilyNumber{"- with one solution", one_solution},
};

static bool all_sizes(std::size_t, int) {
    return true;
}

static bool few_points_or_views(std::size_t points, int views) {
    return points < 7 || views <= 3;
}

static constexpr std::array table{
    Family{"plmp", &calibrated_cameras, all_sizes, numbers_of_plmp},
    Family{"projective", &projective_cameras, few_points_or_views, numbers_of_projective},
};

std::span<const Family> families() {
    return table;
}

const Family* find_family(std::string_view name) {
    const auto* const found = std::ranges::find(table, name, &Family::name);
    return found != table.end() ? found : nullptr;
}

std::string names_of_families() {
    std::string names;
    for (const Family& family : table)
        names += (names.empty() ? "" : ", ") + std::string(family.name);
    return names;
}
} // namespace checker
