#include "checker/conclusion/in_general.h"

#include "checker/conclusion/group.h"
#include "checker/conclusion/label_class.h"
#include "checker/conclusion/pages_of_theorems.h"
#include "checker/degrees/constraint_class.h"
#include "checker/family/degree_bound.h"
#include "checker/general_bounds/hilbert.h"
#include "checker/general_bounds/proved_degrees.h"
#include "checker/general_bounds/shared_points.h"
#include "checker/general_bounds/three_views.h"
#include "checker/general_bounds/upright_views.h"
#include "checker/general_degrees/multiples.h"
#include "checker/problem/notation.h"

namespace checker {
/// The files of a kind that count.
template <class Kind> static std::vector<const ReplayedFile*> files_of(const Findings& findings) {
    std::vector<const ReplayedFile*> files;
    for (std::size_t i = 0; i < findings.files.size(); ++i) {
        const ReplayedFile& file = findings.files[i];
        if (std::holds_alternative<Kind>(file.content) && findings.counts(i))
            files.push_back(&file);
    }
    return files;
}

ByProblem<ProvedInGeneral> verdicts_in_general(const Findings& findings) {
    ByProblem<ProvedInGeneral> verdicts;
    const auto add = [&](const Problem& problem, bool minimal, const std::string& file) {
        ProvedInGeneral& first = verdicts[problem];
        if (first.file.empty()) first = {minimal, file};
    };
    for (const ReplayedFile* file : files_of<ProblemsFile>(findings))
        for (const ProblemVerdict& verdict : std::get<ProblemsFile>(file->content).verdicts)
            add(verdict.problem, verdict.minimal, file->name);
    for (const ReplayedFile* file : files_of<SolutionsFile>(findings))
        for (const SolutionCount& count : std::get<SolutionsFile>(file->content).counts)
            if (count.solutions > 0) add(count.problem, true, file->name);
    return verdicts;
}

ByProblem<CountedInGeneral> counts_in_general(const Findings& findings) {
    ByProblem<CountedInGeneral> counts;
    for (const ReplayedFile* file : files_of<SolutionsFile>(findings))
        for (const auto& [notation, problem, solutions, cycle_types] :
             std::get<SolutionsFile>(file->content).counts) {
            CountedInGeneral& most = counts[without_implied_lines(problem)];
            if (solutions > most.counted ||
                (solutions == most.counted && cycle_types.size() > most.cycle_types.size()))
                most = {at_least(problem, solutions), solutions, file->name, notation, cycle_types};
        }
    return counts;
}

CountedInGeneral count_in_general(const Findings& findings, const Problem& problem) {
    const auto counts = counts_in_general(findings);
    const CountedInGeneral* most = counts.find(without_implied_lines(problem));
    return most ? *most : CountedInGeneral{};
}

ByProblem<BoundedInGeneral> bounds_in_general(const Findings& findings) {
    ByProblem<BoundedInGeneral> bounds;
    for (const ReplayedFile* file : files_of<AtMostFile>(findings))
        for (const auto& [notation, problem, at_most] :
             std::get<AtMostFile>(file->content).bounds) {
            BoundedInGeneral& least = bounds[without_implied_lines(problem)];
            if (least.notation.empty() || at_most < least.at_most)
                least = {at_most, {}, file->name, notation};
        }
    return bounds;
}

UpperBound upper_bound(const BoundedInGeneral& bound) {
    if (bound.file.empty()) return {bound.at_most, ByTheorem{bound.theorem}};
    return {bound.at_most, ByForms{}};
}

/// All upper bounds of a run, by files and by theorems, on minimal problems.
class Bounds {
public:
    explicit Bounds(const Findings& findings) : by_files_(bounds_in_general(findings)) {}

    /// The least; none if none is about the problem.
    std::optional<BoundedInGeneral> least(const Problem& written) {
        // Theorems and files know the problem without its implied lines.
        const Problem problem = without_implied_lines(written);
        std::optional<BoundedInGeneral> least = by_theorem(problem);
        const BoundedInGeneral* by_file = by_files_.find(problem);
        if (by_file && (!least || by_file->at_most < least->at_most)) least = *by_file;
        return least;
    }

private:
    std::optional<BoundedInGeneral> by_theorem(const Problem& problem);
    std::optional<BoundedInGeneral> by_class(const Problem& problem);

    ByProblem<BoundedInGeneral> by_files_;
    exactly::Degrees of_classes_{};
};

/// By theorems on all problems in three views that are calibrated, or nearly so.
std::optional<BoundedInGeneral> Bounds::by_class(const Problem& problem) {
    const std::optional<Problem> part = calibrated_part(problem);
    const std::optional<Signature> signature = label_class(part ? *part : problem);
    if (!signature) return std::nullopt;
    const auto degree = of_classes_.of(constraint_class(*signature));
    if (!degree) return std::nullopt;
    if (!part) return BoundedInGeneral{degree->solutions, degree->theorem, {}, {}, true};
    return BoundedInGeneral{.at_most = degree->solutions * 3 / 2,
                            .theorem = theorem_of_shared_points,
                            .attained = true,
                            .reason = "its degree is 3/2 times that of " + notation(*signature)};
}

std::optional<BoundedInGeneral> Bounds::by_theorem(const Problem& problem) {
    if (auto degree = by_class(problem)) return degree;
    std::optional<BoundedInGeneral> least;
    const auto consider = [&](std::optional<std::size_t> at_most, std::string_view theorem) {
        if (at_most && (!least || *at_most < least->at_most)) least = {*at_most, theorem, {}, {}};
    };
    consider(degree_bound(problem), theorem_of_points_and_lines);
    consider(degree_in_three_views(problem), theorem_of_cameras);
    consider(degree_by_invariants(problem), theorem_of_arrangements);
    if (const auto proved = proved_degree(problem)) consider(proved->at_most, proved->theorem);
    return least;
}

std::optional<BoundedInGeneral> bound_in_general(const Findings& findings, const Problem& problem) {
    if (const auto degree = degree_in_upright_views(without_implied_lines(problem)))
        return BoundedInGeneral{.at_most = *degree,
                                .theorem = theorem_of_upright_views,
                                .attained = true,
                                .reason = "its solutions are counted by their valuations"};
    return Bounds(findings).least(problem);
}

bool is_five_point_problem(const Problem& problem) {
    return problem.cameras == &calibrated_cameras && problem.view_count() == 2 &&
           problem.points.size() == 5 && without_implied_lines(problem).lines.empty();
}

Contradictions contradictions_in_general(const Findings& findings) {
    Bounds bounds(findings);
    Contradictions found;
    for (std::size_t i = 0; i < findings.files.size(); ++i) {
        const auto* file = std::get_if<SolutionsFile>(&findings.files[i].content);
        if (!file || !findings.counts(i)) continue;
        for (const SolutionCount& count : file->counts) {
            if (count.solutions == 0) continue; // nothing says that the problem is minimal
            const auto bound = bounds.least(count.problem);
            const std::size_t solutions = at_least(count.problem, count.solutions);
            if (!bound || solutions <= bound->at_most) continue;
            const auto reason = contradiction(solutions, upper_bound(*bound));
            found.emplace(i, say(count.notation, " has ", *reason));
            for (std::size_t j = 0; j < findings.files.size() && !bound->file.empty(); ++j)
                if (findings.files[j].name == bound->file)
                    found.emplace(j, say(count.notation, " has ", *reason));
        }
    }
    return found;
}

DegreesInGeneral degrees_of(const Findings& findings, const ProblemsFile& problems) {
    const auto counts = counts_in_general(findings);
    Bounds bounds(findings);
    DegreesInGeneral degrees;
    for (const ProblemVerdict& verdict : problems.verdicts) {
        if (!verdict.minimal) continue;
        const CountedInGeneral* counted = counts.find(without_implied_lines(verdict.problem));
        const std::size_t solutions = counted ? counted->solutions : 0;
        if (solutions > 0) ++degrees.at_least[solutions];
        // A minimal problem has a solution, whatever the files count.
        const auto bound = bounds.least(verdict.problem);
        const bool exact =
            bound && (bound->attained || bound->at_most == std::max(solutions, std::size_t{1}));
        if (!exact) continue;
        ++degrees.exact;
        if (bound->file.empty()) ++degrees.exact_by_theorem;
        std::string group;
        if (is_five_point_problem(verdict.problem))
            group = group_of_five_points;
        else if (counted)
            group = group_shown_by(counted->cycle_types, solutions, Orbits::one);
        if (!group.empty()) degrees.groups.emplace(verdict.notation, group);
    }
    return degrees;
}

const ReplayedFile* file_of_family(const Findings& findings, std::string_view family) {
    for (const ReplayedFile* file : files_of<ProblemsFile>(findings)) {
        const auto& content = std::get<ProblemsFile>(file->content);
        if (content.family == family && content.missing == 0) return file;
    }
    return nullptr;
}
} // namespace checker
