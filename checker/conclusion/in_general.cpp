#include "checker/conclusion/in_general.h"

#include "checker/general/degree_bound.h"
#include "checker/general/isomorphism.h"
#include "checker/general/notation.h"

namespace checker {
general::Problem parse_general_problem(std::string_view notation) {
    std::string line;
    for (const char c : notation) {
        if (c == ' ' || c == '\t' || c == '\n') continue;
        if (c == '+') line += " + ";
        if (c != '+') line += c;
        if (c == ':') line += ' ';
    }
    line += '\n';
    Reader reader(line);
    return general::read_notation(reader).problem;
}

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

static bool same(const general::Problem& a, const general::Problem& b) {
    return general::invariant(a) == general::invariant(b) && general::isomorphic(a, b);
}

std::optional<ProvedInGeneral> prove_in_general(const Findings& findings,
                                                const general::Problem& problem) {
    for (const ReplayedFile* file : files_of<general::ProblemsFile>(findings))
        for (const auto& [notation, other, minimal] :
             std::get<general::ProblemsFile>(file->content).verdicts)
            if (same(problem, other)) return ProvedInGeneral{minimal, file->name};
    const CountedInGeneral counted = count_in_general(findings, problem);
    if (counted.solutions > 0) return ProvedInGeneral{true, counted.file};
    return std::nullopt;
}

CountedInGeneral count_in_general(const Findings& findings, const general::Problem& problem) {
    CountedInGeneral most;
    for (const ReplayedFile* file : files_of<general::SolutionsFile>(findings))
        for (const auto& [notation, other, solutions] :
             std::get<general::SolutionsFile>(file->content).counts)
            if (solutions > most.solutions && same(problem, other)) most = {solutions, file->name};
    return most;
}

/// Solutions of problems, by what a renaming keeps of them.
using CountsByInvariant = std::map<general::Invariant, std::vector<general::SolutionCount>>;

static std::size_t most_solutions(const CountsByInvariant& counts,
                                  const general::Problem& problem) {
    std::size_t most = 0;
    const auto alike = counts.find(general::invariant(problem));
    if (alike == counts.end()) return most;
    for (const general::SolutionCount& count : alike->second)
        if (count.solutions > most && general::isomorphic(problem, count.problem))
            most = count.solutions;
    return most;
}

DegreesInGeneral degrees_of(const Findings& findings, const general::ProblemsFile& problems) {
    CountsByInvariant counts;
    for (const ReplayedFile* file : files_of<general::SolutionsFile>(findings))
        for (const auto& count : std::get<general::SolutionsFile>(file->content).counts)
            counts[general::invariant(count.problem)].push_back(count);
    DegreesInGeneral degrees;
    for (const general::Verdict& verdict : problems.verdicts) {
        if (!verdict.minimal) continue;
        const std::size_t solutions = most_solutions(counts, verdict.problem);
        if (solutions > 0) ++degrees.at_least[solutions];
        // A minimal problem has a solution, whatever the files count.
        const auto bound = general::degree_bound(verdict.problem);
        if (bound == std::max(solutions, std::size_t{1})) ++degrees.exact;
    }
    return degrees;
}

const ReplayedFile* file_of_family(const Findings& findings, std::string_view family) {
    for (const ReplayedFile* file : files_of<general::ProblemsFile>(findings)) {
        const auto& content = std::get<general::ProblemsFile>(file->content);
        if (content.family == family && content.missing == 0) return file;
    }
    return nullptr;
}
} // namespace checker
