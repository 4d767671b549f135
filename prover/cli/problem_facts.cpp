#include "prover/cli/problem_facts.h"

#include <algorithm>

namespace plprove {

std::vector<FeatureRow> feature_rows(const Features& problem) {
    std::vector<FeatureRow> rows;
    for (const Feature& feature : problem) {
        const std::string text = notation(feature);
        auto row = std::ranges::find(rows, text, &FeatureRow::notation);
        if (row == rows.end())
            row = rows.insert(rows.end(), {text, 0, dimension_in_space(feature),
                                           weight(feature) + dimension_in_space(feature)});
        ++row->count;
    }
    return rows;
}

bool is_camera_minimal(const Decision& decision) {
    return decision.verdict == Verdict::minimal || decision.verdict == Verdict::camera_minimal;
}

bool same_features(const Features& a, const Features& b) {
    const auto sorted = [](const Features& problem) {
        Features result;
        for (const Feature& feature : problem)
            result.push_back(canonical(feature));
        std::ranges::sort(result);
        return result;
    };
    return sorted(a) == sorted(b);
}

Standing standing_of(const Decision& decision) {
    if (signature_of(decision.problem)) return Standing::member;
    if (same_features(decision.problem, decision.terminal)) return Standing::terminal;
    return decision.reduction.steps.empty() ? Standing::dangling : Standing::reducible;
}

std::string_view name(Standing standing) {
    switch (standing) {
    case Standing::member:
        return "member";
    case Standing::terminal:
        return "terminal problem";
    case Standing::dangling:
        return "with dangling pins";
    case Standing::reducible:
        return "reduces to it";
    }
    return {};
}

} // namespace plprove
