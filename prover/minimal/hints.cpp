#include "prover/minimal/hints.h"

#include <algorithm>

namespace plprove {

namespace {

/// What may be added: in two views, a point is the only reduced feature.
std::vector<Feature> features_to_add(int views) {
    if (views == 2) return {parse_feature("P/P")};
    return standard_features();
}

/// The different features of a problem, in its order.
std::vector<Feature> different_features(const Features& problem) {
    std::vector<Feature> different;
    for (const Feature& feature : problem)
        if (std::ranges::find(different, feature) == different.end()) different.push_back(feature);
    return different;
}

/// How many constraints the feature puts on the cameras.
int constraints_of(const Feature& feature) {
    int sum = 0;
    for (const Feature& left : reduce({feature}).reduced)
        sum += weight(lifted(left));
    return sum;
}

/// The changes that bring just the constraints that are missing: candidates.
std::vector<Hint> candidates(const Decision& decision) {
    std::vector<Hint> result;
    const int missing = decision.camera_dimension - decision.constraints;
    const std::vector<Feature> own = different_features(decision.problem);
    const std::vector<Feature> others = features_to_add(decision.problem.front().views());
    if (missing > 0)
        for (const Feature& feature : others)
            if (constraints_of(feature) == missing) result.push_back({{{}, feature}, {}});
    if (missing <= 0)
        for (const Feature& feature : own)
            if (constraints_of(feature) == -missing) result.push_back({{feature, {}}, {}});
    if (decision.verdict == Verdict::camera_minimal)
        for (const Feature& feature : own)
            if (!reduce_once(feature) && lifted(feature) != feature)
                result.push_back({{feature, lifted(feature)}, {}});
    if (decision.verdict == Verdict::obstructed)
        for (const Feature& feature : own)
            for (const Feature& other : others)
                if (constraints_of(feature) == weight(other))
                    result.push_back({{feature, other}, {}});
    return result;
}

bool fits(const Decision& before, const Decision& after) {
    if (after.verdict == Verdict::minimal) return true;
    return after.verdict == Verdict::camera_minimal && before.verdict != Verdict::camera_minimal;
}

/// Whether two hints lead to problems of one label class.
bool alike(const Hint& a, const Hint& b) {
    if (!a.decision.classes || !b.decision.classes) return false;
    return a.decision.classes->label == b.decision.classes->label;
}

} // namespace

std::vector<Hint> hints(const Decision& decision) {
    std::vector<Hint> result;
    if (decision.verdict == Verdict::minimal) return result;
    if (decision.problem.size() > most_features_with_hints) return result;
    for (Hint& hint : candidates(decision)) {
        const Features problem = changed(decision.problem, hint);
        if (problem.empty()) continue;
        hint.decision = decide(problem);
        const bool known =
            std::ranges::any_of(result, [&](const Hint& earlier) { return alike(earlier, hint); });
        if (fits(decision, hint.decision) && !known) result.push_back(std::move(hint));
    }
    return result;
}

} // namespace plprove
