#include "prover/solver/plan.h"

#include "prover/minimal/decision.h"
#include "prover/system/exit.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace plprove {

namespace {

/// A feature on its way to the class, and where its lines come from.
struct Traced {
    Feature feature;
    SourceFeature source;
};

/// Which line the step from `before` to `after` forgets. Lines that the same views see are alike.
int forgotten_line(const Feature& before, const Feature& after) {
    for (int line = 0; line < after.lines; ++line)
        if (views_of(before, line) != views_of(after, line)) return line;
    return after.lines;
}

/// The feature reduced, or nothing where nothing of it is left.
std::optional<Traced> reduced(const Feature& feature, std::size_t number) {
    Traced traced{feature, {number, {}}};
    for (int line = 0; line < feature.lines; ++line)
        traced.source.pins.push_back(line);
    while (const auto step = reduce_once(traced.feature)) {
        if (!step->after) return std::nullopt;
        auto& pins = traced.source.pins;
        if (step->after->lines < traced.feature.lines)
            pins.erase(pins.begin() + forgotten_line(traced.feature, *step->after));
        traced.feature = *step->after;
    }
    return traced;
}

std::vector<Traced> reduced_features(const Features& problem) {
    std::vector<Traced> result;
    for (std::size_t f = 0; f < problem.size(); ++f)
        if (auto traced = reduced(problem[f], f)) result.push_back(std::move(*traced));
    return result;
}

/// The same lines in the order in which the standard feature has them.
std::vector<int> in_standard_order(const Traced& traced, const Feature& standard) {
    std::vector<int> pins;
    std::vector<bool> used(traced.source.pins.size(), false);
    for (int line = 0; line < standard.lines; ++line)
        for (int other = 0; other < traced.feature.lines; ++other) {
            const auto index = static_cast<std::size_t>(other);
            if (used[index] || views_of(traced.feature, other) != views_of(standard, line))
                continue;
            used[index] = true;
            pins.push_back(traced.source.pins[index]);
            break;
        }
    return pins;
}

Features features_of(const std::vector<Traced>& traced) {
    Features problem;
    for (const Traced& one : traced)
        problem.push_back(one.feature);
    return problem;
}

/// The features with views and pins as in the table of the 27, in its order. Assumes that they are
/// among them.
std::vector<SourceFeature> in_class_order(const std::vector<Traced>& traced) {
    std::vector<std::pair<std::size_t, SourceFeature>> found;
    for (const Traced& one : traced) {
        const Signature signature = *signature_of({one.feature});
        const auto index =
            static_cast<std::size_t>(std::ranges::find(signature, 1) - signature.begin());
        SourceFeature source = one.source;
        source.pins = in_standard_order(one, standard_features()[index]);
        found.emplace_back(index, source);
    }
    std::ranges::stable_sort(found, {}, [](const auto& entry) { return entry.first; });
    std::vector<SourceFeature> result;
    for (const auto& [index, source] : found)
        result.push_back(source);
    return result;
}

/// Finds the order of the views in which the features represent their label class.
void choose_views(SolvePlan& plan, std::vector<Traced> traced) {
    for (Traced& one : traced)
        one.feature = lifted(one.feature);
    const Signature wanted = representative(*signature_of(features_of(traced)));
    do {
        std::vector<Traced> relabeled = traced;
        for (Traced& one : relabeled)
            one.feature = relabel_views(one.feature, plan.view_of);
        if (signature_of(features_of(relabeled)) != wanted) continue;
        plan.sources = in_class_order(relabeled);
        return;
    } while (std::ranges::next_permutation(plan.view_of).found);
}

} // namespace

SolvePlan plan(const Features& problem) {
    const Decision decision = decide(problem);
    if (decision.verdict != Verdict::minimal && decision.verdict != Verdict::camera_minimal) {
        std::string message = "only minimal and camera-minimal problems can be solved, and " +
                              notation(problem) + " is neither";
        for (const std::string& reason : reasons(decision))
            message += ": " + reason;
        throw BadInput(message + ": `plprove list --minimal` names problems that can be solved");
    }
    SolvePlan plan{problem, std::nullopt, {0, 1, 2}, {}};
    const std::vector<Traced> traced = reduced_features(problem);
    if (decision.classes) {
        plan.number = decision.classes->label;
        choose_views(plan, traced);
    } else {
        for (const Traced& one : traced)
            plan.sources.push_back(one.source);
    }
    return plan;
}

namespace {

/// The point of the line that is farthest from another point of it.
Eigen::Vector3d far_point(const Eigen::Vector3d& line, const Eigen::Vector3d& point) {
    return line.cross(point).normalized();
}

} // namespace

std::array<std::array<Eigen::Vector3d, 5>, 2> five_points(const SolvePlan& plan,
                                                          const Observation& observation) {
    std::array<std::array<Eigen::Vector3d, 5>, 2> points;
    for (std::size_t view = 0; view < 2; ++view)
        for (std::size_t k = 0; k < 5; ++k)
            points[view][k] = observation[plan.sources[k].feature][view].point->normalized();
    return points;
}

std::vector<Eigen::Vector3d> class_images(const SolvePlan& plan, const CameraSystem& system,
                                          const Observation& observation) {
    const Eigen::Vector3d through(0.36, 0.48, 0.8); // any vector gives a line through a point
    std::vector<Eigen::Vector3d> images;
    for (const FreeVector& free : system.free) {
        const SourceFeature& source = plan.sources[static_cast<std::size_t>(free.feature)];
        const int view = plan.view_of[static_cast<std::size_t>(free.view)];
        const Sighting& sighting = observation[source.feature][static_cast<std::size_t>(view)];
        if (free.line < 0) {
            images.push_back(sighting.point->normalized());
            continue;
        }
        const int pin = source.pins[static_cast<std::size_t>(free.line)];
        const auto& line = sighting.lines[static_cast<std::size_t>(pin)];
        if (!free.toward)
            images.push_back(line->normalized());
        else
            images.push_back(
                far_point(line ? *line : sighting.point->cross(through), *sighting.point));
    }
    return images;
}

} // namespace plprove
