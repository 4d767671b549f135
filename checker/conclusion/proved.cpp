#include "checker/conclusion/proved.h"

#include "checker/family/isomorphism.h"
#include "checker/problem/notation.h"

namespace checker {
/// Whether the line is known from its points, two of them, wherever it is seen.
static bool is_implied(const Problem& problem, const Line& line) {
    return line.points.size() == 2 && std::ranges::all_of(line.points, [&](std::size_t point) {
               return (line.seen_by & ~problem.points[point].seen_by) == 0;
           });
}

Problem without_implied_lines(const Problem& problem) {
    Problem result = problem;
    result.lines.clear();
    for (Point& point : result.points)
        point.lines.clear();
    for (const Line& line : problem.lines) {
        if (is_implied(problem, line)) continue;
        for (const std::size_t point : line.points)
            result.points[point].lines.push_back(result.lines.size());
        result.lines.push_back(line);
    }
    return result;
}

/// What views see of a point and the lines through it; none if a line has another point.
static std::optional<Feature> feature_of(const Problem& problem, const Point& point) {
    Feature feature{.point = point.seen_by};
    for (const std::size_t n : point.lines) {
        if (problem.lines[n].points.size() > 1) return std::nullopt;
        feature.pin[feature.pins++] = problem.lines[n].seen_by;
    }
    return feature;
}

static std::optional<Features> features_of(const Problem& problem) {
    Features list;
    for (const Point& point : problem.points) {
        const auto feature = feature_of(problem, point);
        if (!feature) return std::nullopt;
        list.push_back(*feature);
    }
    for (const Line& line : problem.lines)
        if (line.points.empty())
            list.push_back({.free_line = true, .pin = {line.seen_by}, .pins = 1});
    return list;
}

std::optional<std::size_t> class_of(const Classification& classes, const Problem& problem) {
    const bool in_three_views =
        problem.cameras == &calibrated_cameras && problem.views == all_views;
    const std::optional<Features> list = features_of(problem);
    if (!in_three_views || !list || surplus(problem) != 0) return std::nullopt;
    Signature signature{};
    for (const Feature& feature : *list) {
        const std::size_t index = index_of(feature);
        if (index == feature_count) return std::nullopt;
        ++signature[index];
    }
    return number_of(classes, largest_relabeled(signature));
}

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
