#include "checker/conclusion/known_degree.h"

#include "checker/conclusion/pages_of_theorems.h"
#include "checker/conclusion/registrations.h"
#include "checker/degrees/constraint_class.h"

namespace checker {
std::vector<std::string> degree_files(const Classification& classes, const Findings& findings,
                                      const Signature& key) {
    const auto is_own = [&](std::size_t number) {
        return constraint_class(classes.representatives[number]) == key;
    };
    std::vector<std::string> names;
    for (std::size_t i = 0; i < findings.files.size(); ++i)
        if (const auto* file = std::get_if<DegreeFile>(&findings.files[i].content))
            if (findings.counts(i) &&
                std::ranges::any_of(file->bounds, is_own, &LowerBound::number))
                names.push_back(findings.files[i].name);
    return names;
}

/// The files of models that a bound is by; none if it is not by models.
static std::vector<std::string> model_files(const Findings& findings, const DegreeBounds& bounds) {
    std::vector<std::string> names;
    const auto* type = bounds.at_most ? std::get_if<Registration>(&bounds.at_most->by) : nullptr;
    if (type)
        for (const std::size_t file : files_on(findings, *type))
            names.push_back(findings.files[file].name);
    return names;
}

/// Those of a class that a file proves minimal. A theorem needs no more than this file.
static BoundFiles files_of_bounds(const Classification& classes, const Findings& findings,
                                  const Proved& proved, const Signature& signature,
                                  const DegreeBounds& bounds) {
    BoundFiles files;
    if (!proved.file.empty()) files.upper = {proved.file};
    for (const std::string& name : model_files(findings, bounds))
        files.upper.push_back(name);
    files.lower =
        bounds.theorem ? files.upper : degree_files(classes, findings, constraint_class(signature));
    return files;
}

/// The number of relative poses of two views, which a camera-minimal problem in two views has as
/// its degree: exact if the degree of some class is its bound times that of a registration
/// (proofs/registrations.md, section 6).
static KnownDegree degree_of_poses(const Classification& classes, const Findings& findings,
                                   const Proved& proved) {
    KnownDegree known{.source = "its degree is the number of relative poses of two views"};
    std::vector<std::string> files{proved.file};
    for (const ReplayedFile& file : findings.files)
        if (std::holds_alternative<ClassificationFile>(file.content)) files.push_back(file.name);
    const auto poses = findings.registrations.find(relative_pose);
    if (poses == findings.registrations.end()) return known;
    known.bounds.at_most = UpperBound{poses->second, relative_pose};
    Registration attained = relative_pose;
    for (std::size_t n = 0; n < findings.verdicts.size() && known.bounds.at_least == 0; ++n) {
        if (!is_minimal(findings.verdicts, n)) continue;
        const Signature& signature = classes.representatives[n];
        const auto product = bound_by_registration(signature, findings.registrations);
        if (!product || product->bound != bounds_of(findings.degrees, signature).at_least) continue;
        known.bounds.at_least = poses->second;
        attained = product->type;
    }
    for (const std::size_t file : files_on(findings, attained))
        files.push_back(findings.files[file].name);
    known.files = {files, files};
    return known;
}

/// What class or relative poses say of the degree.
static KnownDegree degree_of_class(const Classification& classes, const Findings& findings,
                                   const Proved& proved, const Problem& problem) {
    if (problem.view_count() == 2 && implies(proved.verdict, "camera-minimal"))
        return degree_of_poses(classes, findings, proved);
    if (!proved.number) return {};
    const Signature& signature = classes.representatives[*proved.number];
    const DegreeBounds bounds = bounds_of(findings.degrees, signature);
    return {bounds, files_of_bounds(classes, findings, proved, signature, bounds),
            say("its degree is that of label class ", *proved.number, ", ", notation(signature))};
}

static std::string source_of(const CountedInGeneral& counted) {
    std::string source = "its solutions are counted by " + counted.file;
    if (counted.solutions > counted.counted)
        source += say(": ", counted.counted, ", and by Theorem G of proofs/multiples.md there are ",
                      counted.solutions);
    return source;
}

// With what a file of solutions counts, if that is more; of a problem in general also with what
// theorems say.
KnownDegree degree_of(const Classification& classes, const Findings& findings, const Proved& proved,
                      const ExpectedProblem& expected) {
    KnownDegree known = degree_of_class(classes, findings, proved, expected.problem);
    const CountedInGeneral counted = count_in_general(findings, expected.problem);
    if (counted.solutions > known.bounds.at_least) {
        known.bounds.at_least = counted.solutions;
        known.files.lower = {counted.file};
        if (known.source.empty()) known.source = source_of(counted);
    }
    // Of a label class these are fibres of the same cameras, in another chart.
    known.bounds.cycle_types.insert(known.bounds.cycle_types.end(), counted.cycle_types.begin(),
                                    counted.cycle_types.end());
    if (is_five_point_problem(expected.problem))
        known.bounds.group_theorem = theorem_of_five_points;
    if (proved.verdict != "minimal" || known.bounds.exact()) return known;
    const auto bound = bound_in_general(findings, expected.problem);
    if (!bound) return known;
    known.files.upper = {proved.file};
    known.bounds.at_most = upper_bound(*bound);
    if (!bound->file.empty()) known.files.upper.push_back(bound->file);
    if (!bound->reason.empty()) {
        known.bounds.theorem = exactly::Degree{bound->at_most, bound->theorem};
        known.bounds.counted = known.bounds.at_least;
        known.bounds.at_least = std::max(known.bounds.counted, bound->at_most);
        known.files.lower = {proved.file};
        known.source = bound->reason;
    } else if (known.bounds.at_least == 0) {
        known.bounds.at_least = 1;
        known.files.lower = {proved.file};
        known.source = "a minimal problem has a solution";
    }
    return known;
}

std::optional<std::size_t> class_asked(const Classification& classes, const Findings& findings,
                                       const ExpectedProblem& expected) {
    if (!expected.degree && expected.group.empty()) return std::nullopt;
    const Proved proved = prove(classes, findings, verdicts_in_general(findings), expected);
    return implies(proved.verdict, "camera-minimal") ? proved.number : std::nullopt;
}
} // namespace checker
