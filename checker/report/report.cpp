#include "checker/report/report.h"

#include "checker/conclusion/group.h"
#include "checker/conclusion/in_general.h"
#include "checker/conclusion/known_degree.h"
#include "checker/conclusion/models.h"
#include "checker/problem/notation.h"

namespace checker {
/// A kind of file.
struct Kind {
    std::string_view name{};     // as in its first line
    std::string_view argument{}; // why its records prove what they say
};

/// In the order of FileContent.
static constexpr std::array<Kind, std::variant_size_v<FileContent>> kinds{{
    {},
    {"classification",
     "each record has a minor that is not 0, or a motion: proofs/classification.md"},
    {"problem", "it reduces to a class, or has too few or many constraints: proofs/problems.md"},
    {"degrees", "each solution has a box of its own that holds one zero: proofs/degrees.md"},
    {"problems",
     "each record has a minor that is not 0, or conditions on images: proofs/families.md"},
    {"solutions", "each solution has a box of its own that holds one zero: proofs/families.md"},
    {"at-most", "forms that vanish at all solutions leave few dimensions: proofs/fixed_forms.md"},
    {"model", "solutions modulo q that lift, and multiples that leave a basis: proofs/models.md"},
    {},
}};

static const Kind& kind(const ReplayedFile& file) {
    return kinds[file.content.index()];
}

std::string_view kind_of(const ReplayedFile& file) {
    return kind(file).name;
}

static std::vector<ExactDegree> exact_degrees(const paper::KnownDegrees& known) {
    std::vector<ExactDegree> exact;
    for (std::size_t n = 0; n < known.verdicts.size(); ++n) {
        if (!is_minimal(known.verdicts, n)) continue;
        const DegreeBounds bounds = paper::bounds_of(known, n);
        if (bounds.exact())
            exact.push_back(
                {n, bounds.at_least, group_of(bounds), notation(known.classes.representatives[n])});
    }
    return exact;
}

static void add_exact_degrees(Report& report, const Classification& classes) {
    const Findings& findings = report.findings;
    const auto poses = findings.registrations.find(relative_pose);
    const std::size_t relative_poses = poses == findings.registrations.end() ? 0 : poses->second;
    const paper::KnownDegrees known{classes, findings.verdicts, findings.degrees, relative_poses};
    if (findings.degrees.empty()) return;
    report.degrees = paper::compare_degrees(known);
    report.exact = exact_degrees(known);
}

static void add_families(Report& report) {
    const Findings& findings = report.findings;
    for (std::size_t i = 0; i < findings.files.size(); ++i) {
        const auto* file = std::get_if<ProblemsFile>(&findings.files[i].content);
        if (!file || !findings.counts(i)) continue;
        paper::FamilyTable table = paper::compare_family(*file);
        if (table.claims.empty()) continue;
        const DegreesInGeneral degrees = degrees_of(findings, *file);
        table.lower_bounds = degrees.at_least;
        table.exact = degrees.exact;
        table.exact_by_theorem = degrees.exact_by_theorem;
        table.groups = degrees.groups;
        for (paper::FamilyDegree& degree : table.degrees) {
            const Problem problem = parse_problem(degree.problem);
            const auto bound = bound_in_general(findings, problem);
            set_certified(degree, count_in_general(findings, problem).solutions,
                          bound ? bound->at_most : 0);
        }
        report.families.push_back(table);
    }
}

/// Takes the verdicts from the tables: in a run with a file that is refused, no row confirms
/// anything.
static void withhold_verdicts(Report& report) {
    static constexpr std::string_view withheld = "withheld: a file is refused";
    for (paper::Claim& claim : report.claims)
        if (claim.certified != "-") claim.verdict = withheld;
    for (paper::FamilyTable& table : report.families) {
        for (paper::Claim& claim : table.claims)
            claim.verdict = withheld;
        for (paper::FamilyDegree& degree : table.degrees)
            degree.verdict = withheld;
    }
    for (paper::DegreeClaim& claim : report.degrees)
        claim.verdict = withheld;
}

/// What files prove: each problem, class and family once, however many records are about it.
struct Proofs {
    bool classification = false;
    ByProblem<std::string> problems{}; // single ones, with their verdicts
    std::vector<std::string> families{};
    std::map<std::size_t, std::size_t> solutions{}; // of label classes, at least
    std::vector<std::string> files{};
};

template <class Item> static void add_once(std::vector<Item>& list, const Item& item) {
    if (std::ranges::find(list, item) == list.end()) list.push_back(item);
}

/// Adds a family, or single problems.
static void add(Proofs& proofs, const ProblemsFile& file) {
    if (!file.family.empty()) {
        const auto minimal = std::ranges::count_if(file.verdicts, &ProblemVerdict::minimal);
        add_once(proofs.families, say("all ", file.verdicts.size(), " problems of the family ",
                                      file.family, ", ", minimal, " minimal"));
        return;
    }
    for (const auto& [notation, problem, minimal] : file.verdicts)
        proofs.problems[problem] = notation + (minimal ? " is minimal" : " is not minimal");
}

static Proofs proofs_of(const Findings& findings) {
    Proofs proofs;
    for (const auto& [name, sha256, content] : findings.files) {
        if (std::holds_alternative<ClassificationFile>(content)) proofs.classification = true;
        if (const auto* file = std::get_if<ProblemFile>(&content))
            proofs.problems[file->meaning] = file->problem + " is " + file->verdict;
        if (const auto* file = std::get_if<ProblemsFile>(&content)) add(proofs, *file);
        if (const auto* file = std::get_if<DegreeFile>(&content))
            for (const LowerBound& bound : file->bounds) {
                std::size_t& most = proofs.solutions[bound.number];
                most = std::max(most, bound.solutions);
            }
        add_once(proofs.files, name);
    }
    return proofs;
}

/// The only value, or else the last.
template <class Value> static Value last_of(const ByProblem<Value>& values) {
    Value last{};
    values.for_each([&](const auto&, const Value& value) { last = value; });
    return last;
}

/// `the groups of classes 69 (S240) and 249 (>=A328)`, all of them, or their number if there are
/// many; empty if there is none.
static std::string groups_in_words(std::span<const ExactDegree> degrees) {
    constexpr std::size_t many = 12;
    std::vector<std::string> groups;
    for (const ExactDegree& exact : degrees)
        if (!exact.group.empty()) groups.push_back(say(exact.number, " (", exact.group, ')'));
    if (groups.size() > many) return say("the groups of ", groups.size(), " label classes");
    std::string text;
    for (std::size_t i = 0; i < groups.size(); ++i)
        text += (i == 0 ? "" : i + 1 == groups.size() ? " and " : ", ") + groups[i];
    if (groups.empty()) return text;
    return (groups.size() == 1 ? "the group of class " : "the groups of classes ") + text;
}

/// The statement of a run without a refusal.
static std::string statement_of(const Report& report, const Proofs& proofs) {
    std::vector<std::string> parts;
    const auto add = [&](std::size_t number, const std::string& one, const std::string& several) {
        if (number > 0) parts.push_back(number == 1 ? one : several);
    };
    const Verdicts& verdicts = report.findings.verdicts;
    if (proofs.classification) {
        std::size_t minimal = 0;
        for (std::size_t n = 0; n < verdicts.size(); ++n)
            minimal += is_minimal(verdicts, n);
        parts.push_back(say("all ", verdicts.size(), " label classes, ", minimal, " minimal"));
    }
    parts.insert(parts.end(), proofs.families.begin(), proofs.families.end());
    add(proofs.problems.count(), last_of(proofs.problems),
        say("the verdicts on ", proofs.problems.count(), " problems"));
    std::pair<std::size_t, std::size_t> degree; // of the only class, or else the first
    if (!proofs.solutions.empty()) degree = *proofs.solutions.begin();
    add(proofs.solutions.size(),
        say("at least ", counted(degree.second, "solution"), " of class ", degree.first),
        say("lower bounds of the degrees of ", proofs.solutions.size(), " classes"));
    const auto counts = counts_in_general(report.findings);
    const CountedInGeneral count = last_of(counts);
    add(counts.count(),
        say("at least ", counted(count.solutions, "solution"), " of ", count.notation),
        say("lower bounds of the degrees of ", counts.count(), " problems in general"));
    const auto bounds = bounds_in_general(report.findings);
    const BoundedInGeneral bound = last_of(bounds);
    add(bounds.count(),
        say("at most ", counted(bound.at_most, "solution"), " of ", bound.notation,
            ", if it is minimal"),
        say("upper bounds of the degrees of ", bounds.count(), " problems in general"));
    add(report.exact.size(), "the exact degrees of 1 label class",
        say("the exact degrees of ", report.exact.size(), " label classes"));
    if (const std::string groups = groups_in_words(report.exact); !groups.empty())
        parts.push_back(groups);
    const auto models = models_of(report.findings);
    if (!models.empty())
        add(models.size(), in_words(models.begin()->second),
            say("what ", models.size(), " models have of solutions"));
    std::string text;
    for (const std::string& part : parts)
        text += (text.empty() ? "" : "; ") + part;
    return text;
}

/// Judges a run in which nothing in particular is expected: every file has to hold, and some file
/// has to prove something.
static Judgement judge_all(const Report& report) {
    const Findings& findings = report.findings;
    Judgement judgement;
    if (findings.status == 0) {
        const Proofs proofs = proofs_of(findings);
        judgement.verified = !proofs.files.empty();
        judgement.files = proofs.files;
        judgement.statement =
            judgement.verified ? statement_of(report, proofs) : "there is no file; give one";
        for (const ReplayedFile& file : findings.files)
            judgement.why.push_back(say(file.name, ": ", kind(file).argument));
    }
    return judgement;
}

/// The judgement of a run in which files are refused.
static Judgement judge_refused(const Findings& findings, const Expectation& expectation) {
    Judgement judgement;
    for (std::size_t i = 0; i < findings.files.size(); ++i)
        if (status_of(findings, i) > 0) judgement.files.push_back(findings.files[i].name);
    for (const std::string& file : judgement.files)
        judgement.why.push_back(file + ": the messages on standard error say what is refused");
    const std::string expected = in_words(expectation);
    judgement.statement = say(expected, expected.empty() ? "" : ": ", judgement.files.size(),
                              " of ", counted(findings.files.size(), "file"),
                              judgement.files.size() == 1 ? " is refused" : " are refused");
    return judgement;
}

/// What the run asks of theorems on degrees.
static AskedDegrees asked_degrees(const Classification& classes, const Findings& findings,
                                  const Expectation& expectation, bool all) {
    AskedDegrees asked{.all = all};
    if (const auto* problem = std::get_if<ExpectedProblem>(&expectation))
        asked.minimal_class = class_asked(classes, findings, *problem);
    return asked;
}

Report summarize(const Classification& classes, std::vector<ReplayedFile> files,
                 const Expectation& expectation, bool all_degrees) {
    Report report{.findings = find(classes, std::move(files))};
    const Findings& findings = report.findings;
    add_degrees(report.findings, classes,
                asked_degrees(classes, findings, expectation, all_degrees));
    report.claims = paper::compare_counts(classes, findings.verdicts);
    add_families(report);
    add_exact_degrees(report, classes);
    if (findings.status > 0) {
        withhold_verdicts(report);
        report.judgement = judge_refused(findings, expectation);
    } else if (const auto* problem = std::get_if<ExpectedProblem>(&expectation)) {
        report.judgement = judge(classes, findings, *problem);
    } else if (const auto* family = std::get_if<WholeFamily>(&expectation)) {
        report.judgement = judge(findings, *family);
    } else if (const auto* list = std::get_if<WholeList>(&expectation)) {
        report.judgement = judge(classes, findings, *list);
    } else if (const auto* model = std::get_if<ExpectedModel>(&expectation)) {
        report.judgement = judge(findings, *model);
    } else if (std::holds_alternative<WholeClassification>(expectation)) {
        report.judgement = judge(classes, findings, WholeClassification{});
    } else {
        report.judgement = judge_all(report);
    }
    report.status = std::max(findings.status, report.judgement.verified ? 0 : 1);
    return report;
}
} // namespace checker
