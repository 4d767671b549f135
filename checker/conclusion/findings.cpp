#include "checker/conclusion/findings.h"

namespace checker {
const Refusals& refusals_of(const ReplayedFile& file) {
    static const Refusals none;
    if (const auto* content = std::get_if<ClassificationFile>(&file.content))
        return content->refusals;
    if (const auto* content = std::get_if<ProblemFile>(&file.content)) return content->refusals;
    if (const auto* content = std::get_if<DegreeFile>(&file.content)) return content->refusals;
    if (const auto* content = std::get_if<BoundsFile>(&file.content)) return content->refusals;
    if (const auto* content = std::get_if<general::ProblemsFile>(&file.content))
        return content->refusals;
    if (const auto* content = std::get_if<general::SolutionsFile>(&file.content))
        return content->refusals;
    if (const auto* content = std::get_if<general::AtMostFile>(&file.content))
        return content->refusals;
    return none;
}

int status_of(const Findings& findings, std::size_t file) {
    const ReplayedFile& replayed = findings.files[file];
    if (std::holds_alternative<Malformed>(replayed.content)) return 2;
    if (std::holds_alternative<Unreadable>(replayed.content)) return 2;
    return refusals_of(replayed).count > 0 || !findings.counts(file) ? 1 : 0;
}

/// Compares the files with the digests of a list, whose names start in its own folder.
static void compare_digests(Findings& findings, std::size_t list_number,
                            const std::multimap<std::string, std::size_t>& files_by_place) {
    constexpr std::size_t most_reported = 20;
    const ReplayedFile& list = findings.files[list_number];
    Comparison& own = findings.comparisons[list_number];
    const std::string list_place = place_of(list.name, working_folder());
    for (const auto& [sha256, name] : std::get<DigestList>(list.content).files) {
        const auto [begin, end] = files_by_place.equal_range(place_of(name, folder_of(list_place)));
        if (begin == end) {
            ++own.listed_not_given;
            if (own.not_given.size() < most_reported) own.not_given.push_back(name);
        }
        for (auto place = begin; place != end; ++place) {
            const ReplayedFile& file = findings.files[place->second];
            Comparison& comparison = findings.comparisons[place->second];
            ++own.listed;
            const bool same = file.sha256 == sha256;
            if (!same || comparison.digest.empty())
                comparison.digest = say(same ? "as in " : "not as in ", list.name);
            if (!same && comparison.objections.size() < most_reported)
                comparison.objections.push_back(say("its SHA-256 digest is ", file.sha256, ", in ",
                                                    list.name, " it is ", sha256));
        }
    }
    if (own.listed == 0)
        own.objections.push_back(say("it lists none of the files given: its names start in its own "
                                     "folder, ",
                                     folder_of(list_place), "; move it there, or give its files"));
}

static void compare_digests(Findings& findings) {
    std::multimap<std::string, std::size_t> files_by_place;
    for (std::size_t i = 0; i < findings.files.size(); ++i)
        files_by_place.emplace(place_of(findings.files[i].name, working_folder()), i);
    for (std::size_t i = 0; i < findings.files.size(); ++i)
        if (std::holds_alternative<DigestList>(findings.files[i].content))
            compare_digests(findings, i, files_by_place);
}

/// Whether the file has records, or templates, that hold or are refused.
static bool has_records(const ReplayedFile& file) {
    if (refusals_of(file).count > 0) return true;
    if (const auto* content = std::get_if<DegreeFile>(&file.content))
        return !content->bounds.empty();
    if (const auto* content = std::get_if<BoundsFile>(&file.content)) return content->templates > 0;
    if (const auto* content = std::get_if<general::SolutionsFile>(&file.content))
        return !content->counts.empty();
    if (const auto* content = std::get_if<general::ProblemsFile>(&file.content))
        return !content->verdicts.empty();
    if (const auto* content = std::get_if<general::AtMostFile>(&file.content))
        return content->bounds.size() > 0;
    return true;
}

static void object_to_empty_files(Findings& findings) {
    for (std::size_t i = 0; i < findings.files.size(); ++i)
        if (!has_records(findings.files[i]))
            findings.comparisons[i].objections.push_back("it has no record, so it proves nothing");
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

static std::vector<LowerBound> lower_bounds_of(const Findings& findings) {
    std::vector<LowerBound> bounds;
    for (std::size_t i = 0; i < findings.files.size(); ++i)
        if (const auto* content = std::get_if<DegreeFile>(&findings.files[i].content))
            if (findings.counts(i))
                bounds.insert(bounds.end(), content->bounds.begin(), content->bounds.end());
    return bounds;
}

static RegistrationBounds upper_bounds_of(const Findings& findings) {
    RegistrationBounds bounds;
    for (std::size_t i = 0; i < findings.files.size(); ++i)
        if (const auto* content = std::get_if<BoundsFile>(&findings.files[i].content))
            if (findings.counts(i))
                for (const auto& [type, bound] : content->bounds)
                    add_bound(bounds, type, bound);
    return bounds;
}

/// Bounds that contradict each other refuse all files of bounds: whichever is wrong, nothing
/// follows.
static void refuse_bounds(Findings& findings, const std::string& reason) {
    for (std::size_t i = 0; i < findings.files.size(); ++i) {
        const FileContent& content = findings.files[i].content;
        if (std::holds_alternative<DegreeFile>(content) ||
            std::holds_alternative<BoundsFile>(content))
            findings.comparisons[i].objections.push_back("bounds contradict each other: " + reason);
    }
}

/// What follows of degrees, if no bounds contradict each other.
static void add_degrees(Findings& findings, const Classification& classes) {
    const std::vector<LowerBound> lower = lower_bounds_of(findings);
    const RegistrationBounds upper = upper_bounds_of(findings);
    if (lower.empty() && upper.empty()) return;
    std::vector<bool> minimal;
    for (std::size_t n = 0; n < findings.verdicts.size(); ++n)
        minimal.push_back(is_minimal(findings.verdicts, n));
    const DegreeTable table = combine(classes, minimal, lower, upper);
    if (const auto reason = contradiction(table)) return refuse_bounds(findings, *reason);
    findings.registrations = upper;
    findings.has_lower_bounds = !lower.empty();
    findings.degrees = table;
}

Findings find(const Classification& classes, std::vector<ReplayedFile> files) {
    Findings findings{.files = std::move(files)};
    findings.comparisons.resize(findings.files.size());
    compare_digests(findings);
    object_to_empty_files(findings);
    findings.verdicts = verdicts_of(classes, findings);
    add_degrees(findings, classes);
    for (std::size_t i = 0; i < findings.files.size(); ++i)
        findings.status = std::max(findings.status, status_of(findings, i));
    return findings;
}
} // namespace checker
