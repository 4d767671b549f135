#include "checker/report/report.h"

#include "checker/degrees/constraint_class.h"

namespace checker {
const Refusals& refusals_of(const ReplayedFile& file) {
    static const Refusals none;
    if (const auto* content = std::get_if<ClassificationFile>(&file.content))
        return content->refusals;
    if (const auto* content = std::get_if<ProblemFile>(&file.content)) return content->refusals;
    if (const auto* content = std::get_if<DegreeFile>(&file.content)) return content->refusals;
    if (const auto* content = std::get_if<BoundsFile>(&file.content)) return content->refusals;
    return none;
}

std::string_view kind_of(const ReplayedFile& file) {
    constexpr std::array<std::string_view, 6> kinds{"",        "classification", "problem",
                                                    "degrees", "bounds",         "digests"};
    static_assert(kinds.size() == std::variant_size_v<FileContent>);
    return kinds[file.content.index()];
}

/// Compares the files with the digests of a list, where a name may be the end of a path.
static void compare_digests(Report& report, std::size_t list_number) {
    const ReplayedFile& list = report.files[list_number];
    for (const auto& [sha256, name] : std::get<DigestList>(list.content).files) {
        bool given = false;
        for (std::size_t i = 0; i < report.files.size(); ++i) {
            const ReplayedFile& file = report.files[i];
            if (!("/" + file.name).ends_with("/" + name)) continue;
            given = true;
            const bool same = file.sha256 == sha256;
            Comparison& comparison = report.comparisons[i];
            comparison.digest = say(same ? "as in " : "not as in ", list.name);
            if (!same)
                comparison.objections.push_back(say("its SHA-256 digest is ", file.sha256, ", in ",
                                                    list.name, " it is ", sha256));
        }
        if (!given) report.comparisons[list_number].not_given.push_back(name);
    }
}

/// By class number, what classification and problem files prove.
static Verdicts verdicts_of(const Classification& classes, const std::vector<ReplayedFile>& files) {
    Verdicts verdicts(classes.representatives.size());
    for (const ReplayedFile& file : files) {
        if (const auto* content = std::get_if<ClassificationFile>(&file.content))
            for (const auto& [number, obstruction] : content->verdicts)
                verdicts[number] = obstruction;
        if (const auto* content = std::get_if<ProblemFile>(&file.content))
            if (const auto& verdict = content->of_class)
                verdicts[verdict->number] = verdict->obstruction;
    }
    return verdicts;
}

static std::vector<LowerBound> lower_bounds_of(const std::vector<ReplayedFile>& files) {
    std::vector<LowerBound> bounds;
    for (const ReplayedFile& file : files)
        if (const auto* content = std::get_if<DegreeFile>(&file.content))
            bounds.insert(bounds.end(), content->bounds.begin(), content->bounds.end());
    return bounds;
}

static RegistrationBounds upper_bounds_of(const std::vector<ReplayedFile>& files) {
    RegistrationBounds bounds;
    for (const ReplayedFile& file : files)
        if (const auto* content = std::get_if<BoundsFile>(&file.content))
            for (const auto& [type, bound] : content->bounds)
                add_bound(bounds, type, bound);
    return bounds;
}

static std::vector<UpperBoundCount> count_upper_bounds(const paper::KnownDegrees& known) {
    std::map<std::size_t, UpperBoundCount> counts;
    for (std::size_t n = 0; n < known.verdicts.size(); ++n) {
        if (!is_minimal(known.verdicts, n) || !known.classes.represents_swap_class(n)) continue;
        const DegreeBounds bounds = paper::bounds_of(known, n);
        if (!bounds.at_most) continue;
        UpperBoundCount& count = counts[bounds.at_most->solutions];
        count.solutions = bounds.at_most->solutions;
        ++(bounds.at_most->by_theorem() ? count.by_theorem : count.by_templates);
    }
    std::vector<UpperBoundCount> ascending;
    for (const auto& [solutions, count] : counts)
        ascending.push_back(count);
    return ascending;
}

static std::vector<ExactDegree> exact_degrees(const paper::KnownDegrees& known) {
    std::vector<ExactDegree> exact;
    for (std::size_t n = 0; n < known.verdicts.size(); ++n) {
        if (!is_minimal(known.verdicts, n)) continue;
        const DegreeBounds bounds = paper::bounds_of(known, n);
        if (bounds.exact()) exact.push_back({n, bounds.at_least});
    }
    return exact;
}

/// What follows of degrees, if no bounds contradict each other.
static void add_degrees(Report& report, const Classification& classes, const Verdicts& verdicts) {
    const std::vector<LowerBound> lower = lower_bounds_of(report.files);
    const RegistrationBounds upper = upper_bounds_of(report.files);
    if (lower.empty() && upper.empty()) return;
    std::vector<bool> minimal;
    for (std::size_t n = 0; n < verdicts.size(); ++n)
        minimal.push_back(is_minimal(verdicts, n));
    const DegreeTable table = combine(classes, minimal, lower, upper);
    if (const auto reason = contradiction(table)) { // whichever is wrong, nothing follows
        for (std::size_t i = 0; i < report.files.size(); ++i) {
            const FileContent& content = report.files[i].content;
            if (std::holds_alternative<DegreeFile>(content) ||
                std::holds_alternative<BoundsFile>(content))
                report.comparisons[i].objections.push_back("bounds contradict each other: " +
                                                           *reason);
        }
        return;
    }
    const auto poses = upper.find(relative_pose);
    const std::size_t relative_poses = poses == upper.end() ? 0 : poses->second;
    const paper::KnownDegrees known{classes, verdicts, table, relative_poses};
    if (!upper.empty()) report.upper_bounds = count_upper_bounds(known);
    if (lower.empty()) return;
    report.degrees = paper::compare_degrees(known);
    report.exact = exact_degrees(known);
}

/// 0 if the file holds, 1 if it or a record of it is refused, 2 if it does not conform.
static int status_of(const ReplayedFile& file, const Comparison& comparison) {
    if (std::holds_alternative<Malformed>(file.content)) return 2;
    return refusals_of(file).count > 0 || !comparison.objections.empty() ? 1 : 0;
}

Report summarize(const Classification& classes, std::vector<ReplayedFile> files) {
    Report report{.files = std::move(files)};
    report.comparisons.resize(report.files.size());
    for (std::size_t i = 0; i < report.files.size(); ++i)
        if (std::holds_alternative<DigestList>(report.files[i].content)) compare_digests(report, i);
    const Verdicts verdicts = verdicts_of(classes, report.files);
    report.claims = paper::compare_counts(classes, verdicts);
    add_degrees(report, classes, verdicts);
    for (std::size_t i = 0; i < report.files.size(); ++i)
        report.status = std::max(report.status, status_of(report.files[i], report.comparisons[i]));
    return report;
}
} // namespace checker
