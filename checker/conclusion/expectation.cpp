#include "checker/conclusion/expectation.h"

#include "checker/conclusion/pages_of_theorems.h"
#include "checker/degrees/constraint_class.h"

namespace checker {
/// The notation without blanks.
static std::string without_blanks(std::string_view notation) {
    std::string text;
    for (const char c : notation)
        if (c != ' ' && c != '\t' && c != '\n') text += c;
    return text;
}

CanonicalProblem parse_problem(std::string_view notation) {
    const std::string text = without_blanks(notation);
    unsigned views = 0;
    Features list;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find('+', start), text.size());
        const std::string line = text.substr(start, end - start) + '\n';
        start = end + 1;
        if (line == "\n") throw Malformed{{0, "expected a feature before and after each `+`"}};
        Reader reader(line);
        const Written summand = read_notation(reader, section_1);
        const auto its_views = static_cast<unsigned>(summand.problem.view_count());
        if (views == 0) views = its_views;
        if (its_views != views)
            throw Malformed{{0, "expected all features in the same number of views"}};
        list.insert(list.end(), summand.features.begin(), summand.features.end());
        if (list.size() > 1000) throw Malformed{{0, "expected at most 1000 features"}};
    }
    return canonical(views, list);
}

/// What is proved of a problem beside its degree.
struct Proved {
    std::string verdict{}; // empty if none
    std::string file{};    // that proves it
    /// The label class that has the same degree: that of the lifted problem.
    std::optional<std::size_t> number{};
};

/// The class's record in a classification file; none if it has none.
static const Verdict* record_of(const ClassificationFile& file, std::size_t number) {
    const auto place = std::ranges::lower_bound(file.verdicts, number, {}, &Verdict::number);
    return place != file.verdicts.end() && place->number == number ? &*place : nullptr;
}

/// By a problem file about the problem, else by the record of its class in a classification.
static Proved prove_by_class(const Classification& classes, const Findings& findings,
                             const CanonicalProblem& problem) {
    Proved proved{.number = class_of(classes, problem)};
    for (std::size_t i = 0; i < findings.files.size(); ++i) {
        const ReplayedFile& file = findings.files[i];
        if (!findings.counts(i)) continue;
        const auto* own = std::get_if<ProblemFile>(&file.content);
        if (own && !own->verdict.empty() && own->canonical == problem) {
            proved = {own->verdict, file.name, std::nullopt};
            if (own->of_class) proved.number = own->of_class->number;
            return proved;
        }
        const auto* all = std::get_if<ClassificationFile>(&file.content);
        const Verdict* record = all && proved.number ? record_of(*all, *proved.number) : nullptr;
        if (!record || !proved.verdict.empty()) continue;
        proved.verdict = record->obstruction.minimal() ? "minimal" : "obstructed";
        proved.file = file.name;
    }
    return proved;
}

/// The same, or else by a file of problems in general.
static Proved prove(const Classification& classes, const Findings& findings,
                    const ExpectedProblem& expected) {
    Proved proved = prove_by_class(classes, findings, expected.problem);
    if (!proved.verdict.empty() || !expected.in_general) return proved;
    const auto found = prove_in_general(findings, *expected.in_general);
    if (!found) return proved;
    proved.verdict = found->minimal ? "minimal" : "not-minimal";
    proved.file = found->file;
    return proved;
}

/// Whether a verdict says what is expected, or implies it.
static bool implies(const std::string& verdict, const std::string& expected) {
    if (verdict.empty()) return false;
    if (expected == "not-minimal") return verdict != "minimal";
    if (expected == "camera-minimal" && verdict == "minimal") return true;
    return verdict == expected || verdict.starts_with(expected + ' ');
}

/// Of a constraint class, the files that bound its degree.
struct BoundFiles {
    std::vector<std::string> lower{}; // those with a record of the class, or all if none has one:
                                      // then it attains the bound of another class
    std::vector<std::string> upper{}; // what an upper bound rests on, other than theorems
};

static BoundFiles files_of_bounds(const Classification& classes, const Findings& findings,
                                  const Signature& signature) {
    const Signature key = constraint_class(signature);
    const auto is_own = [&](std::size_t number) {
        return constraint_class(classes.representatives[number]) == key;
    };
    BoundFiles files;
    std::vector<std::string> others;
    for (std::size_t i = 0; i < findings.files.size(); ++i) {
        const auto& [name, sha256, content] = findings.files[i];
        if (!findings.counts(i)) continue;
        if (const auto* degrees = std::get_if<DegreeFile>(&content)) {
            const bool own = std::ranges::any_of(degrees->bounds, is_own, &LowerBound::number);
            (own ? files.lower : others).push_back(name);
        }
        const auto* problem = std::get_if<ProblemFile>(&content);
        const bool own_problem = problem && problem->of_class && is_own(problem->of_class->number);
        if (own_problem || std::holds_alternative<ClassificationFile>(content) ||
            std::holds_alternative<BoundsFile>(content))
            files.upper.push_back(name);
    }
    if (files.lower.empty()) files.lower = others;
    return files;
}

static std::string in_words(const ExpectedDegree& degree) {
    return say("has ", degree.exactly ? "exactly " : "at least ", degree.solutions,
               " camera solutions");
}

static std::string in_words(const ExpectedProblem& expected) {
    std::string text = expected.notation;
    if (!expected.verdict.empty()) text += " is " + expected.verdict;
    if (!expected.verdict.empty() && expected.degree) text += ", and";
    if (expected.degree) text += ' ' + in_words(*expected.degree);
    return text;
}

std::string in_words(const Expectation& expectation) {
    if (const auto* problem = std::get_if<ExpectedProblem>(&expectation)) return in_words(*problem);
    if (const auto* family = std::get_if<WholeFamily>(&expectation))
        return "the family " + family->name;
    const bool whole = std::holds_alternative<WholeClassification>(expectation);
    return whole ? "the whole table" : "";
}

static std::string in_words(const UpperBound& bound) {
    const auto* theorem = std::get_if<TheoremRow>(&bound.by);
    if (std::holds_alternative<ByForms>(bound.by))
        return say("at most ", bound.solutions,
                   ", by forms that vanish at all solutions: proofs/fixed_forms.md");
    if (!theorem)
        return say("at most ", bound.solutions, ", by templates of relative pose and registration");
    return say("at most ", bound.solutions, ", by Theorem ", theorem->theorem, " of proofs/",
               page_of(theorem->theorem));
}

static void add_file(Judgement& judgement, const std::string& file) {
    if (std::ranges::find(judgement.files, file) == judgement.files.end())
        judgement.files.push_back(file);
}

/// What the bounds miss of an expected degree; empty if nothing.
static std::string missing(const DegreeBounds& bounds, const ExpectedDegree& expected) {
    if (bounds.at_least == 0) return "no file bounds its degree from below; add a degree file";
    const std::string at_least = say("at least ", bounds.at_least, " solutions are certified");
    if (bounds.exact() && bounds.at_least != expected.solutions &&
        (expected.exactly || bounds.at_least < expected.solutions))
        return say("exactly ", bounds.at_least, " solutions are certified");
    if (bounds.at_least < expected.solutions) return at_least;
    if (!expected.exactly || bounds.exact()) return {};
    if (bounds.at_most) return say(at_least, ", and at most ", bounds.at_most->solutions);
    return at_least + ", and no upper bound; one may need the classification and bounds.plc";
}

/// The bounds of the number of relative poses of two views, which a camera-minimal problem in two
/// views has as its degree: exact if some class attains a product of which it is a factor
/// (proofs/templates.md, section 6).
static DegreeBounds bounds_of_poses(const Findings& findings) {
    DegreeBounds bounds;
    const auto poses = findings.registrations.find(relative_pose);
    if (poses == findings.registrations.end()) return bounds;
    bounds.at_most = UpperBound{poses->second, relative_pose};
    const auto is_attained = [](const auto& entry) {
        const DegreeBounds& known = entry.second;
        return known.exact() && !known.at_most->by_theorem();
    };
    if (std::ranges::any_of(findings.degrees, is_attained)) bounds.at_least = poses->second;
    return bounds;
}

/// What is known of a degree, and by which files.
struct KnownDegree {
    DegreeBounds bounds{};
    BoundFiles files{};
    std::string source{}; // in words, whose degree it is; empty if the files do not say
};

/// What class or relative poses say of the degree.
static KnownDegree degree_of_class(const Classification& classes, const Findings& findings,
                                   const Proved& proved, unsigned views) {
    if (views == 2 && implies(proved.verdict, "camera-minimal")) {
        BoundFiles files = files_of_bounds(classes, findings, Signature{});
        files.lower.insert(files.lower.end(), files.upper.begin(), files.upper.end());
        return {bounds_of_poses(findings), files,
                "its degree is the number of relative poses of two views"};
    }
    if (!proved.number) return {};
    const Signature& signature = classes.representatives[*proved.number];
    return {bounds_of(findings.degrees, signature), files_of_bounds(classes, findings, signature),
            say("its degree is that of label class ", *proved.number, ", ", notation(signature))};
}

/// The same, with what a file of solutions counts, if that is more. Of a problem in general also
/// what theorems say.
static KnownDegree degree_of(const Classification& classes, const Findings& findings,
                             const Proved& proved, const ExpectedProblem& expected) {
    KnownDegree known = degree_of_class(classes, findings, proved, expected.problem.views);
    if (!expected.in_general) return known;
    const CountedInGeneral counted = count_in_general(findings, *expected.in_general);
    if (counted.solutions > known.bounds.at_least) {
        known.bounds.at_least = counted.solutions;
        known.files.lower = {counted.file};
        if (known.source.empty()) known.source = "its solutions are counted by " + counted.file;
    }
    const auto bound = bound_in_general(findings, *expected.in_general);
    if (proved.verdict != "minimal" || !bound) return known;
    known.files.upper = {proved.file};
    known.bounds.at_most = UpperBound{bound->at_most, TheoremRow{0, bound->theorem}};
    if (!bound->file.empty()) {
        known.bounds.at_most->by = ByForms{};
        known.files.upper.push_back(bound->file);
    }
    if (known.bounds.at_least == 0) {
        known.bounds.at_least = 1;
        known.files.lower = {proved.file};
        known.source = "a minimal problem has a solution";
    }
    return known;
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
    if (bounds.at_least > 0)
        judgement.why.push_back(say("at least ", bounds.at_least, " solutions of its equations"));
    if (bounds.at_most) judgement.why.push_back(in_words(*bounds.at_most));
    const std::string gap = missing(bounds, expected);
    if (!gap.empty()) return gap;
    for (const std::string& file : known.files.lower)
        add_file(judgement, file);
    if (expected.exactly)
        for (const std::string& file : known.files.upper)
            add_file(judgement, file);
    return {};
}

/// Judges the verdict: adds the step, returns what is missing.
static std::string judge_verdict(Judgement& judgement, const Proved& proved,
                                 const std::string& expected) {
    if (!proved.verdict.empty())
        judgement.why.push_back(say("it is ", proved.verdict, ", by ", proved.file));
    if (expected.empty()) return {};
    if (proved.verdict.empty())
        return "no file says whether it is; add its certificate, which plprove problem PROBLEM "
               "--certificate FILE writes";
    if (!implies(proved.verdict, expected)) return "it is certified " + proved.verdict;
    add_file(judgement, proved.file);
    return {};
}

Judgement judge(const Classification& classes, const Findings& findings,
                const ExpectedProblem& expected) {
    Judgement judgement;
    const Proved proved = prove(classes, findings, expected);
    std::string gap = judge_verdict(judgement, proved, expected.verdict);
    if (gap.empty() && expected.degree) {
        if (!proved.file.empty()) add_file(judgement, proved.file);
        gap = judge_degree(judgement, degree_of(classes, findings, proved, expected),
                           expected.problem.views == 0, *expected.degree);
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
            say("the family ", expected.name, ": no file has all its problems; add certs/",
                expected.name, ".plc");
        return judgement;
    }
    const auto& verdicts = std::get<general::ProblemsFile>(file->content).verdicts;
    const auto minimal = std::ranges::count_if(verdicts, &general::Verdict::minimal);
    judgement.verified = true;
    judgement.statement = say("the family ", expected.name, ": all ", verdicts.size(),
                              " problems are certified, ", minimal, " minimal");
    judgement.files = {file->name};
    judgement.why.push_back("each problem of the family has a record that holds");
    return judgement;
}
} // namespace checker
