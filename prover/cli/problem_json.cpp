#include "prover/cli/problem_facts.h"
#include "prover/cli/problem_report.h"

#include <nlohmann/json.hpp>

namespace plprove {

namespace {

using Json = nlohmann::ordered_json;

Json json_steps(const Decision& decision) {
    Json steps = Json::array();
    for (const ReductionStep& step : decision.reduction.steps)
        steps.push_back({{"rule", name(step.rule)},
                         {"feature", notation(step.before)},
                         {"result", step.after ? Json(notation(*step.after)) : Json()}});
    return steps;
}

Json json_features(const Decision& decision) {
    Json features = Json::array();
    for (const FeatureRow& row : feature_rows(decision.problem))
        features.push_back({{"feature", row.notation},
                            {"count", row.count},
                            {"scene", row.space},
                            {"images", row.images}});
    return features;
}

/// Adds the degree, if there is one.
void add_degree(Json& json, const Decision& decision) {
    if (const std::optional<int> degree = degree_of(decision))
        json["degree"] = {{"value", *degree}, {"status", "certified"}};
}

Json json_families(const Families& families) {
    return {{"pl0p", families.pl0p},
            {"at_most_one_pin", families.at_most_one_pin},
            {"plmp", families.plmp ? Json(*families.plmp) : Json()},
            {"five_point_extension", families.five_point_extension},
            {"registration", families.registration},
            {"trifocal_linear", families.trifocal_linear}};
}

Json json_hints(const std::vector<Hint>& hints) {
    Json list = Json::array();
    for (const Hint& hint : hints) {
        Json item = {{"add", hint.added ? Json(notation(*hint.added)) : Json()},
                     {"drop", hint.dropped ? Json(notation(*hint.dropped)) : Json()},
                     {"problem", notation(hint.decision.problem)},
                     {"verdict", name(hint.decision.verdict)}};
        if (hint.decision.classes) item["number"] = hint.decision.classes->label;
        add_degree(item, hint.decision);
        list.push_back(item);
    }
    return list;
}

void add_classes(Json& report, const Decision& decision) {
    report["number"] = decision.classes->label;
    report["standing"] = name(standing_of(decision));
    report["class"] = notation(decision.lifted);
    report["swap_class"] = decision.classes->swap;
    report["constraint_class"] = decision.classes->constraint;
    report["families"] = json_families(*decision.families);
}

} // namespace

nlohmann::ordered_json group_json(const GroupOnFile& group) {
    return {{"name", group.name},
            {"order", group.order},
            {"width", group.width},
            {"status", group.status}};
}

std::string json_report(const ProblemReport& full_report) {
    const auto& [decision, hints] = full_report;
    Json report = {
        {"problem", notation(decision.problem)},
        {"views", decision.problem.front().views()},
        {"features", json_features(decision)},
        {"dimensions",
         {{"scene", decision.space_dimension},
          {"cameras", decision.camera_dimension},
          {"images", decision.image_dimension},
          {"balanced", decision.balanced()}}},
        {"reduction", json_steps(decision)},
        {"reduced", notation(decision.reduction.reduced)},
        {"constraints", decision.constraints},
        {"verdict", name(decision.verdict)},
        {"minimal", decision.verdict == Verdict::minimal},
        {"camera_minimal", is_camera_minimal(decision)},
        {"reasons", reasons(decision)},
        {"excess", decision.obstruction.excess},
        {"star", decision.obstruction.star},
    };
    if (is_camera_minimal(decision)) report["terminal"] = notation(decision.terminal);
    if (decision.classes) add_classes(report, decision);
    add_degree(report, decision);
    if (const auto group = group_of(decision)) report["group"] = group_json(*group);
    if (!hints.empty()) report["hints"] = json_hints(hints);
    return report.dump(2) + "\n";
}

} // namespace plprove
