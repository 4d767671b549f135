#include "checker/report/report.h"

namespace checker {
/// How many of these hold, and how many are refused.
static std::string held(std::size_t number, std::string_view thing, std::size_t refused) {
    return say(counted(number, thing), number == 1 ? " holds, " : " hold, ", refused, " refused");
}

static std::string in_words(const Malformed&) {
    return "not a certificate file";
}

static std::string in_words(const Unreadable&) {
    return "cannot be read";
}

static std::string in_words(const ClassificationFile& file) {
    return held(file.verdicts.size(), "certificate", file.refusals.count);
}

static std::string in_words(const ProblemFile& file) {
    if (file.verdict.empty()) return "refused";
    const std::string number = file.of_class ? say(", class ", file.of_class->number) : "";
    return say("certified ", file.verdict, number, ": ", file.problem);
}

static std::string in_words(const LowerBound& bound) {
    return say("\n- class ", bound.number, ": certified to have at least ",
               counted(bound.solutions, "solution"));
}

static std::string in_words(const SolutionCount& count) {
    return say("\n- ", count.notation, ": certified at least ",
               counted(count.solutions, "solution"));
}

static std::string in_words(const SolutionBound& bound) {
    return say("\n- ", bound.notation, ": certified at most ", counted(bound.at_most, "solution"),
               ", if it is minimal");
}

template <class Bound> static std::string in_words(const std::vector<Bound>& bounds) {
    std::string text;
    for (const Bound& bound : bounds)
        text += in_words(bound);
    return text;
}

/// The same as held(), and the bounds if they are few.
template <class Bound>
static std::string held(const std::vector<Bound>& bounds, std::string_view thing,
                        const Refusals& refusals) {
    constexpr std::size_t few = 3;
    const std::string text = held(bounds.size(), thing, refusals.count);
    return bounds.size() > few ? text : text + in_words(bounds);
}

static std::string in_words(const DegreeFile& file) {
    return held(file.bounds, "degree record", file.refusals);
}

static std::string in_words(const ProblemVerdict& verdict) {
    return say(verdict.notation, verdict.minimal ? " is minimal" : " is not minimal");
}

static std::string in_words(const ProblemsFile& file) {
    std::string text = held(file.verdicts.size(), "certificate", file.refusals.count);
    if (file.verdicts.size() == 1) text += say(": ", in_words(file.verdicts[0]));
    if (file.missing > 0) text += say("; the family has ", file.missing, " more problems");
    return text;
}

static std::string in_words(const SolutionsFile& file) {
    return held(file.counts, "solution record", file.refusals);
}

static std::string in_words(const AtMostFile& file) {
    return held(file.bounds, "upper bound", file.refusals);
}

static std::string in_words(const ModelFile& file) {
    std::string text = held(file.records, "record", file.refusals.count);
    if (file.at_least > 0) text += say(": at least ", counted(file.at_least, "solution"));
    if (file.at_most)
        text += say(file.at_least > 0 ? ", at most " : ": at most ",
                    counted(*file.at_most, "solution"));
    return say("model ", file.name, ": ", text);
}

std::string finding(const ReplayedFile& file) {
    const auto what = [](const auto& content) { return in_words(content); };
    return say(file.name, ": ", std::visit(what, file.content), '\n');
}

std::string lower_bounds(const ReplayedFile& file) {
    if (const auto* degrees = std::get_if<DegreeFile>(&file.content))
        return in_words(degrees->bounds);
    if (const auto* solutions = std::get_if<SolutionsFile>(&file.content))
        return in_words(solutions->counts);
    return {};
}
} // namespace checker
