#include "checker/conclusion/findings.h"

#include "checker/conclusion/in_general.h"
#include "checker/conclusion/models.h"
#include "checker/conclusion/registrations.h"

namespace checker {
const Refusals& refusals_of(const ReplayedFile& file) {
    static const Refusals none;
    const auto refusals = [](const auto& content) -> const Refusals& {
        if constexpr (requires { content.refusals; })
            return content.refusals;
        else
            return none;
    };
    return std::visit(refusals, file.content);
}

static bool is_no_certificate(const FileContent& content) {
    return std::holds_alternative<Malformed>(content) ||
           std::holds_alternative<Unreadable>(content);
}

int status_of(const Findings& findings, std::size_t file) {
    const ReplayedFile& replayed = findings.files[file];
    if (is_no_certificate(replayed.content)) return 2;
    return refusals_of(replayed).count > 0 || !findings.counts(file) ? 1 : 0;
}

/// Whether a file has records that hold.
struct HasRecords {
    bool operator()(const DegreeFile& file) const { return !file.bounds.empty(); }
    bool operator()(const SolutionsFile& file) const { return !file.counts.empty(); }
    bool operator()(const ProblemsFile& file) const { return !file.verdicts.empty(); }
    bool operator()(const AtMostFile& file) const { return !file.bounds.empty(); }
    bool operator()(const ModelFile& file) const { return file.records > 0; }
    template <class Other> bool operator()(const Other&) const { return true; }
};

static void object_to_empty_files(Findings& findings) {
    for (std::size_t i = 0; i < findings.files.size(); ++i) {
        const ReplayedFile& file = findings.files[i];
        if (refusals_of(file).count == 0 && !std::visit(HasRecords{}, file.content))
            findings.objections[i].push_back("it has no record, so it proves nothing");
    }
}

/// By class number, what classification and problem files prove.
static Verdicts verdicts_of(const Classification& classes, const Findings& findings) {
    Verdicts verdicts(classes.representatives.size());
    for (std::size_t i = 0; i < findings.files.size(); ++i) {
        if (!findings.counts(i)) continue;
        const FileContent& file = findings.files[i].content;
        if (const auto* content = std::get_if<ClassificationFile>(&file))
            for (const auto& [number, obstruction] : content->verdicts)
                verdicts[number] = obstruction;
        if (const auto* content = std::get_if<ProblemFile>(&file))
            if (const auto& verdict = content->of_class)
                verdicts[verdict->number] = verdict->obstruction;
    }
    return verdicts;
}

Findings find(const Classification& classes, std::vector<ReplayedFile> files) {
    Findings findings{.files = std::move(files)};
    findings.objections.resize(findings.files.size());
    object_to_empty_files(findings);
    for (const auto& [file, reason] : contradictions_of_models(findings.files))
        findings.objections[file].push_back("bounds contradict each other: " + reason);
    findings.verdicts = verdicts_of(classes, findings);
    return findings;
}

static std::vector<LowerBound> lower_bounds_of(const Findings& findings) {
    std::vector<LowerBound> bounds;
    for (std::size_t i = 0; i < findings.files.size(); ++i)
        if (const auto* content = std::get_if<DegreeFile>(&findings.files[i].content))
            if (findings.counts(i))
                bounds.insert(bounds.end(), content->bounds.begin(), content->bounds.end());
    return bounds;
}

/// Adds the files of models that a bound is by, if it is by models.
static void add_models(Contradictions& found, const Findings& findings, const UpperBound& bound,
                       const std::string& reason) {
    if (const auto* type = std::get_if<Registration>(&bound.by))
        for (const std::size_t file : files_on(findings, *type))
            found.emplace(file, reason);
}

/// Finds degree files that count more solutions than an upper bound allows, and the files of
/// models if these are the bound.
static void add_counts(Contradictions& found, const Findings& findings,
                       const Classification& classes, const DegreeTable& table) {
    for (std::size_t i = 0; i < findings.files.size(); ++i) {
        const auto* file = std::get_if<DegreeFile>(&findings.files[i].content);
        if (!file || !findings.counts(i)) continue;
        for (const LowerBound& record : file->bounds) {
            const DegreeBounds known = bounds_of(table, classes.representatives[record.number]);
            const auto reason = contradiction(record.solutions, known.at_most);
            if (!reason) continue;
            const std::string of_class = say("class ", record.number, " has ", *reason);
            found.emplace(i, of_class);
            add_models(found, findings, *known.at_most, of_class);
        }
    }
}

/// Finds models that allow fewer solutions than a theorem says that there are.
static void add_few(Contradictions& found, const Findings& findings, const DegreeTable& table) {
    for (const auto& [signature, known] : table)
        if (known.theorem)
            if (const auto reason = contradiction(known.theorem->solutions, known.at_most))
                add_models(found, findings, *known.at_most,
                           say(notation(signature), " has ", *reason));
}

void add_degrees(Findings& findings, const Classification& classes, const AskedDegrees& asked) {
    std::vector<bool> minimal;
    for (std::size_t n = 0; n < findings.verdicts.size(); ++n)
        minimal.push_back(is_minimal(findings.verdicts, n));
    const RegistrationBounds upper = registration_bounds(findings, classes, minimal);
    DegreeTable table = bounds_by_files(classes, minimal, lower_bounds_of(findings), upper);
    add_theorems(table, classes, minimal, asked);
    Contradictions found = contradictions_in_general(findings);
    add_counts(found, findings, classes, table);
    add_few(found, findings, table);
    for (const auto& [file, reason] : found)
        findings.objections[file].push_back("bounds contradict each other: " + reason);
    for (std::size_t i = 0; i < findings.files.size(); ++i)
        findings.status = std::max(findings.status, status_of(findings, i));
    if (!found.empty()) return; // whichever bound is wrong, nothing follows
    findings.registrations = upper;
    findings.degrees = table;
}
} // namespace checker
