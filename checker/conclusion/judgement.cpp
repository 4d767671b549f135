#include "checker/conclusion/judgement.h"

#include "checker/conclusion/group.h"
#include "checker/conclusion/known_degree.h"
#include "checker/conclusion/pages_of_theorems.h"
#include "checker/degrees/constraint_class.h"

namespace checker {
static void add_file(Judgement& judgement, const std::string& file) {
    if (std::ranges::find(judgement.files, file) == judgement.files.end())
        judgement.files.push_back(file);
}

/// What the bounds miss of an expected degree; empty if nothing.
static std::string missing(const DegreeBounds& bounds, const ExpectedDegree& expected) {
    if (bounds.at_least == 0)
        return "no file proves that its class is minimal, or bounds its degree from below; add "
               "certs/classification.plc";
    const std::string at_least = say("at least ", bounds.at_least, " solutions are certified");
    if (bounds.exact() && bounds.at_least != expected.solutions &&
        (expected.exactly || bounds.at_least < expected.solutions))
        return say("exactly ", bounds.at_least, " solutions are certified");
    if (bounds.at_least < expected.solutions) return at_least;
    if (!expected.exactly || bounds.exact()) return {};
    if (bounds.at_most) return say(at_least, ", and at most ", bounds.at_most->solutions);
    return at_least + ", and no upper bound; add certs/classification.plc, as theorems on degrees "
                      "are for classes that are proved minimal";
}

/// Judges the degree: adds the steps, returns what is missing.
static std::string judge_degree(Judgement& judgement, const KnownDegree& known, bool in_general,
                                const ExpectedDegree& expected) {
    if (known.source.empty() && in_general)
        return "no file bounds its degree from below; add a file of solutions, which plprove "
               "degree PROBLEM -o FILE writes";
    if (known.source.empty())
        return "these files do not say to which class it reduces; add its certificate, which "
               "plprove problem PROBLEM --certificate FILE writes";
    const DegreeBounds& bounds = known.bounds;
    judgement.why.push_back(known.source);
    const bool by_theorem = bounds.theorem.has_value();
    if (by_theorem)
        judgement.why.push_back(say("exactly ", bounds.theorem->solutions, ", by Theorem ",
                                    bounds.theorem->theorem, " of proofs/",
                                    page_of(bounds.theorem->theorem)));
    if (bounds.at_least > 0 && (!by_theorem || bounds.counted > 0))
        judgement.why.push_back(say("at least ", by_theorem ? bounds.counted : bounds.at_least,
                                    " solutions of its equations"));
    if (bounds.at_most && !by_theorem) judgement.why.push_back(in_words(*bounds.at_most));
    const std::string gap = missing(bounds, expected);
    if (!gap.empty()) return gap;
    for (const std::string& file : known.files.lower)
        add_file(judgement, file);
    if (expected.exactly)
        for (const std::string& file : known.files.upper)
            add_file(judgement, file);
    return {};
}

/// What a proof misses of an expected verdict, or of any if none is named; empty if nothing.
static std::string missing(const Proved& proved, const std::string& expected) {
    if (proved.verdict.empty())
        return "no file says whether it is; add its certificate, which plprove problem PROBLEM "
               "--certificate FILE writes";
    const bool holds = expected.empty() || implies(proved.verdict, expected);
    return holds ? "" : "it is certified " + proved.verdict;
}

/// Judges the verdict: adds the step, returns what is missing.
static std::string judge_verdict(Judgement& judgement, const Proved& proved,
                                 const std::string& expected) {
    if (!proved.verdict.empty())
        judgement.why.push_back(say("it is ", proved.verdict, ", by ", proved.file));
    if (expected.empty()) return {};
    const std::string gap = missing(proved, expected);
    if (gap.empty()) add_file(judgement, proved.file);
    return gap;
}

/// The files whose fibres are of the problem, or of its class.
static std::vector<std::string> files_of_fibres(const Classification& classes,
                                                const Findings& findings, const Proved& proved,
                                                const Problem& problem) {
    std::vector<std::string> files;
    if (proved.number)
        files = degree_files(classes, findings,
                             constraint_class(classes.representatives[*proved.number]));
    const CountedInGeneral counted = count_in_general(findings, problem);
    if (!counted.cycle_types.empty()) files.push_back(counted.file);
    return files;
}

/// Judges the group of the solutions: adds the steps, returns what is missing.
static std::string judge_group(Judgement& judgement, const Classification& classes,
                               const Findings& findings, const Proved& proved,
                               const ExpectedProblem& expected) {
    const KnownDegree known = degree_of(classes, findings, proved, expected);
    if (known.source.empty() && !expected.in_general)
        return "these files do not say to which class it reduces; add certs/classification.plc, "
               "or its certificate";
    const std::string group = group_of(known.bounds);
    if (group.empty())
        return "no theorem and no fibres certify its group; add the file that plprove group "
               "PROBLEM -o FILE writes";
    judgement.why.push_back(say("its group is ", group, ", ", source_of_group(known.bounds)));
    if (!implies_group(group, expected.group)) return "the group is certified to be " + group;
    if (!known.bounds.group_theorem.empty()) return {};
    for (const std::string& file : files_of_fibres(classes, findings, proved, expected.problem))
        add_file(judgement, file);
    return {};
}

Judgement judge(const Classification& classes, const Findings& findings,
                const ExpectedProblem& expected) {
    Judgement judgement;
    const Proved proved = prove(classes, findings, verdicts_in_general(findings), expected);
    std::string gap = judge_verdict(judgement, proved, expected.verdict);
    if (gap.empty() && expected.degree) {
        if (!proved.file.empty()) add_file(judgement, proved.file);
        gap = judge_degree(judgement, degree_of(classes, findings, proved, expected),
                           expected.in_general, *expected.degree);
    }
    if (gap.empty() && !expected.group.empty()) {
        if (!proved.file.empty()) add_file(judgement, proved.file);
        gap = judge_group(judgement, classes, findings, proved, expected);
    }
    judgement.verified = gap.empty();
    judgement.statement = in_words(expected);
    if (!gap.empty()) judgement.statement += ": " + gap;
    return judgement;
}

Judgement judge(const Classification& classes, const Findings& findings, WholeClassification) {
    const std::size_t all = classes.representatives.size();
    std::size_t certified = 0, minimal = 0;
    for (const auto& verdict : findings.verdicts) {
        if (!verdict) continue;
        ++certified;
        if (verdict->minimal()) ++minimal;
    }
    Judgement judgement{.verified = certified == all};
    if (!judgement.verified) {
        judgement.statement =
            say("the whole table: ", all - certified, " of ", all,
                " label classes have no certificate here; add certs/classification.plc");
        return judgement;
    }
    judgement.statement =
        say("the whole table: all ", all, " label classes are certified, ", minimal, " minimal");
    for (std::size_t i = 0; i < findings.files.size(); ++i) {
        const FileContent& file = findings.files[i].content;
        const bool has_verdicts = std::holds_alternative<ClassificationFile>(file) ||
                                  std::holds_alternative<ProblemFile>(file);
        if (has_verdicts && findings.counts(i)) add_file(judgement, findings.files[i].name);
    }
    judgement.why.push_back("each label class has a record that holds; its counts need no more");
    return judgement;
}

Judgement judge(const Findings& findings, const WholeFamily& expected) {
    Judgement judgement;
    const ReplayedFile* file = file_of_family(findings, expected.name);
    if (!file) {
        judgement.statement =
            say("the family ", expected.name, ": no file has all its problems; add its archive, ",
                expected.name, ".plc");
        return judgement;
    }
    const auto& verdicts = std::get<ProblemsFile>(file->content).verdicts;
    const auto minimal = std::ranges::count_if(verdicts, &ProblemVerdict::minimal);
    judgement.verified = true;
    judgement.statement = say("the family ", expected.name, ": all ", verdicts.size(),
                              " problems are certified, ", minimal, " minimal");
    judgement.files = {file->name};
    judgement.why.push_back("each problem of the family has a record that holds");
    return judgement;
}

Judgement judge(const Classification& classes, const Findings& findings,
                const WholeList& expected) {
    const ByProblem<ProvedInGeneral> in_general = verdicts_in_general(findings);
    Judgement judgement;
    std::vector<std::string> gaps;
    std::size_t minimal = 0;
    for (const auto& [line, problem] : expected.entries) {
        const Proved proved = prove(classes, findings, in_general, problem);
        const std::string gap = missing(proved, expected.verdict);
        if (!gap.empty())
            gaps.push_back(say("line ", line, ", ", problem.notation, ": ", gap));
        else
            add_file(judgement, proved.file);
        if (proved.verdict == "minimal") ++minimal;
    }
    const std::size_t all = expected.entries.size();
    judgement.verified = gaps.empty();
    judgement.statement = in_words(expected) + ": ";
    if (!gaps.empty()) {
        judgement.statement +=
            say(gaps.size(), " of ", all, " problems lack such a certificate; the first is in ",
                gaps.front());
        judgement.why = gaps;
        return judgement;
    }
    judgement.statement += say("all ", all, " problems are certified, ", minimal, " minimal");
    judgement.why.push_back("each problem of the list has a record that holds");
    return judgement;
}
} // namespace checker
