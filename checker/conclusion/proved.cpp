#include "checker/conclusion/proved.h"

#include "checker/conclusion/label_class.h"

namespace checker {
/// The class's record in a classification file; none if it has none.
static const ClassVerdict* record_of(const ClassificationFile& file, std::size_t number) {
    const auto place = std::ranges::lower_bound(file.verdicts, number, {}, &ClassVerdict::number);
    return place != file.verdicts.end() && place->number == number ? &*place : nullptr;
}

/// By a problem file about the problem, else by the record of its class in a classification.
static Proved prove_by_class(const Classification& classes, const Findings& findings,
                             const Problem& problem) {
    Proved proved{.number = class_of(classes, problem)};
    const Invariant key = invariant(problem); // says all of a problem without shared lines
    for (std::size_t i = 0; i < findings.files.size(); ++i) {
        const ReplayedFile& file = findings.files[i];
        if (!findings.counts(i)) continue;
        const auto* own = std::get_if<ProblemFile>(&file.content);
        if (own && !own->verdict.empty() && invariant(own->meaning) == key) {
            proved = {own->verdict, file.name, std::nullopt};
            if (own->of_class) proved.number = own->of_class->number;
            return proved;
        }
        const auto* all = std::get_if<ClassificationFile>(&file.content);
        const ClassVerdict* record =
            all && proved.number ? record_of(*all, *proved.number) : nullptr;
        if (!record || !proved.verdict.empty()) continue;
        proved.verdict = record->obstruction.minimal() ? "minimal" : "obstructed";
        proved.file = file.name;
    }
    return proved;
}

Proved prove(const Classification& classes, const Findings& findings,
             const ByProblem<ProvedInGeneral>& in_general, const ExpectedProblem& expected) {
    Proved proved = prove_by_class(classes, findings, expected.problem);
    if (!proved.verdict.empty()) return proved;
    const ProvedInGeneral* found = in_general.find(expected.problem);
    if (!found) return proved;
    proved.verdict = found->minimal ? "minimal" : "not-minimal";
    proved.file = found->file;
    if (found->minimal && !proved.number)
        proved.number = class_of(classes, without_implied_lines(expected.problem));
    return proved;
}

bool implies(const std::string& verdict, const std::string& expected) {
    if (verdict.empty()) return false;
    if (expected == "not-minimal") return verdict != "minimal";
    if (expected == "camera-minimal" && verdict == "minimal") return true;
    return verdict == expected || verdict.starts_with(expected + ' ');
}
} // namespace checker
