#include "checker/conclusion/in_general.h"

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

/// The files of problems that count.
static std::vector<const ReplayedFile*> files_of_problems(const Findings& findings) {
    std::vector<const ReplayedFile*> files;
    for (std::size_t i = 0; i < findings.files.size(); ++i) {
        const ReplayedFile& file = findings.files[i];
        const bool of_problems = std::holds_alternative<general::ProblemsFile>(file.content);
        if (of_problems && findings.counts(i)) files.push_back(&file);
    }
    return files;
}

std::optional<ProvedInGeneral> prove_in_general(const Findings& findings,
                                                const general::Problem& problem) {
    const general::Invariant own = general::invariant(problem);
    for (const ReplayedFile* file : files_of_problems(findings))
        for (const auto& [notation, other, minimal] :
             std::get<general::ProblemsFile>(file->content).verdicts)
            if (general::invariant(other) == own && general::isomorphic(problem, other))
                return ProvedInGeneral{minimal, file->name};
    return std::nullopt;
}

const ReplayedFile* file_of_family(const Findings& findings, std::string_view family) {
    for (const ReplayedFile* file : files_of_problems(findings)) {
        const auto& content = std::get<general::ProblemsFile>(file->content);
        if (content.family == family && content.missing == 0) return file;
    }
    return nullptr;
}
} // namespace checker
