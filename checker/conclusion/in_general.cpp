#include "checker/conclusion/in_general.h"

#include "checker/conclusion/pages_of_theorems.h"
#include "checker/family/degree_bound.h"
#include "checker/general_bounds/hilbert.h"
#include "checker/general_bounds/proved_degrees.h"
#include "checker/general_bounds/three_views.h"
#include "checker/problem/isomorphism.h"
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

static bool same(const Problem& a, const Problem& b) {
    return invariant(a) == invariant(b) && isomorphic(a, b);
}

std::optional<ProvedInGeneral> prove_in_general(const Findings& findings, const Problem& problem) {
    for (const ReplayedFile* file : files_of<ProblemsFile>(findings))
        for (const auto& [notation, other, minimal] :
             std::get<ProblemsFile>(file->content).verdicts)
            if (same(problem, other)) return ProvedInGeneral{minimal, file->name};
    const CountedInGeneral counted = count_in_general(findings, problem);
    if (counted.solutions > 0) return ProvedInGeneral{true, counted.file};
    return std::nullopt;
}

/// What records say of problems, by what a renaming keeps of these, and the file of each.
template <class Record>
using ByInvariant = std::map<Invariant, std::vector<std::pair<Record, std::string>>>;

/// What some kind of files says of problems, in one of its members.
template <class Kind, class Record>
static ByInvariant<Record> by_invariant(const Findings& findings,
                                        std::vector<Record> Kind::*records) {
    ByInvariant<Record> all;
    for (const ReplayedFile* file : files_of<Kind>(findings))
        for (const Record& record : std::get<Kind>(file->content).*records)
            all[invariant(record.problem)].emplace_back(record, file->name);
    return all;
}

/// Does something with each record about a problem, and its file.
template <class Record, class Use>
static void for_each(const ByInvariant<Record>& all, const Problem& problem, const Use& use) {
    const auto alike = all.find(invariant(problem));
    if (alike == all.end()) return;
    for (const auto& [record, file] : alike->second)
        if (isomorphic(problem, record.problem)) use(record, file);
}

CountedInGeneral count_in_general(const Findings& findings, const Problem& problem) {
    CountedInGeneral most;
    for_each(by_invariant(findings, &SolutionsFile::counts), problem,
             [&](const SolutionCount& count, const std::string& file) {
                 if (count.solutions > most.solutions) most = {count.solutions, file};
             });
    return most;
}

using UpperBounds = ByInvariant<SolutionBound>;

static UpperBounds upper_bounds_of(const Findings& findings) {
    return by_invariant(findings, &AtMostFile::bounds);
}

UpperBound upper_bound(const BoundedInGeneral& bound) {
    if (bound.file.empty()) return {bound.at_most, ByTheorem{bound.theorem}};
    return {bound.at_most, ByForms{}};
}

static std::optional<BoundedInGeneral> bound_by_theorem(const Problem& problem) {
    std::optional<BoundedInGeneral> least;
    const auto consider = [&](std::optional<std::size_t> at_most, std::string_view theorem) {
        if (at_most && (!least || *at_most < least->at_most)) least = {*at_most, theorem, {}};
    };
    consider(degree_bound(problem), theorem_of_points_and_lines);
    consider(degree_in_three_views(problem), theorem_of_cameras);
    consider(degree_by_invariants(problem), theorem_of_arrangements);
    if (const auto proved = proved_degree(problem)) consider(proved->at_most, proved->theorem);
    return least;
}

static std::optional<BoundedInGeneral> least_bound(const UpperBounds& bounds,
                                                   const Problem& problem) {
    std::optional<BoundedInGeneral> least = bound_by_theorem(problem);
    for_each(bounds, problem, [&](const SolutionBound& bound, const std::string& file) {
        if (!least || bound.at_most < least->at_most) least = {bound.at_most, {}, file};
    });
    return least;
}

std::optional<BoundedInGeneral> bound_in_general(const Findings& findings, const Problem& problem) {
    return least_bound(upper_bounds_of(findings), problem);
}

Contradictions contradictions_in_general(const Findings& findings) {
    const UpperBounds bounds = upper_bounds_of(findings);
    Contradictions found;
    for (std::size_t i = 0; i < findings.files.size(); ++i) {
        const auto* file = std::get_if<SolutionsFile>(&findings.files[i].content);
        if (!file || !findings.counts(i)) continue;
        for (const SolutionCount& count : file->counts) {
            const auto bound = least_bound(bounds, count.problem);
            if (!bound || count.solutions <= bound->at_most) continue;
            const auto reason = contradiction(count.solutions, upper_bound(*bound));
            found.emplace(i, say(count.notation, " has ", *reason));
            for (std::size_t j = 0; j < findings.files.size() && !bound->file.empty(); ++j)
                if (findings.files[j].name == bound->file)
                    found.emplace(j, say(count.notation, " has ", *reason));
        }
    }
    return found;
}

DegreesInGeneral degrees_of(const Findings& findings, const ProblemsFile& problems) {
    const auto counts = by_invariant(findings, &SolutionsFile::counts);
    const UpperBounds bounds = upper_bounds_of(findings);
    DegreesInGeneral degrees;
    for (const ProblemVerdict& verdict : problems.verdicts) {
        if (!verdict.minimal) continue;
        std::size_t solutions = 0;
        for_each(counts, verdict.problem, [&](const SolutionCount& count, const auto&) {
            solutions = std::max(solutions, count.solutions);
        });
        if (solutions > 0) ++degrees.at_least[solutions];
        // A minimal problem has a solution, whatever the files count.
        const auto bound = least_bound(bounds, verdict.problem);
        if (!bound || bound->at_most != std::max(solutions, std::size_t{1})) continue;
        ++degrees.exact;
        if (bound->file.empty()) ++degrees.exact_by_theorem;
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
