#include "prover/cli/problem_report.h"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace plprove {

namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> family_names(const Families& families) {
    std::vector<std::string> names;
    if (families.pl0p) names.emplace_back("PL0P: free points and free lines only");
    if (families.at_most_one_pin) names.emplace_back("at most one pin per point");
    if (families.plmp) names.push_back("complete visibility: " + *families.plmp + " in PLMP");
    if (families.five_point_extension) names.emplace_back("extension of the five-point problem");
    if (families.registration) names.emplace_back("camera registration");
    if (families.trifocal_linear)
        names.emplace_back("one of the 66 problems linear in the trifocal tensor");
    return names;
}

/// Equal features of the problem, counted, with the degrees of freedom of one of them.
struct FeatureRow {
    std::string notation;
    int count = 0;
    int space = 0;
    int images = 0;
};

std::vector<FeatureRow> feature_rows(const Problem& problem) {
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

std::string or_nothing(const Problem& problem) {
    return problem.empty() ? "nothing" : notation(problem);
}

constexpr int label_width = 12;

void section(std::ostream& out, const std::string& label) {
    out << std::left << std::setw(label_width) << label;
}

void continue_section(std::ostream& out) {
    section(out, "");
}

void write_dimensions(std::ostream& out, const Decision& decision) {
    section(out, "dimensions");
    out << "scene " << decision.space_dimension << " + cameras " << decision.camera_dimension
        << (decision.balanced() ? " = " : " against ") << "images " << decision.image_dimension
        << (decision.balanced() ? ": balanced\n" : ": unbalanced\n");
    const std::vector<FeatureRow> rows = feature_rows(decision.problem);
    std::size_t width = 7;
    for (const FeatureRow& row : rows)
        width = std::max(width, row.notation.size());
    const auto cells = [&](const auto& count, const std::string& feature, const auto& space,
                           const auto& images) {
        continue_section(out);
        out << std::right << std::setw(5) << count << "  " << std::left
            << std::setw(static_cast<int>(width)) << feature << std::right << std::setw(7) << space
            << std::setw(8) << images << '\n';
    };
    cells("count", "feature", "scene", "images");
    for (const FeatureRow& row : rows)
        cells(row.count, row.notation, row.space, row.images);
}

void write_reduction(std::ostream& out, const Decision& decision) {
    section(out, "reduction");
    const auto& steps = decision.reduction.steps;
    if (steps.empty()) out << "none: the problem is reduced\n";
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (i > 0) continue_section(out);
        out << notation(steps[i].before) << " -> "
            << (steps[i].after ? notation(*steps[i].after) : "nothing") << "   "
            << explanation(steps[i].rule) << '\n';
    }
    if (!steps.empty()) {
        section(out, "reduced");
        out << or_nothing(decision.reduction.reduced) << '\n';
    }
}

std::string verdict_in_words(Verdict verdict) {
    switch (verdict) {
    case Verdict::minimal:
        return "minimal";
    case Verdict::camera_minimal:
        return "camera-minimal, but not minimal";
    case Verdict::obstructed:
        return "neither minimal nor camera-minimal: obstructed";
    case Verdict::under_constrained:
        return "neither minimal nor camera-minimal: under-constrained";
    case Verdict::over_constrained:
        return "neither minimal nor camera-minimal: over-constrained";
    }
    return {};
}

bool is_camera_minimal(const Decision& decision) {
    return decision.verdict == Verdict::minimal || decision.verdict == Verdict::camera_minimal;
}

void write_verdict(std::ostream& out, const Decision& decision) {
    section(out, "verdict");
    out << verdict_in_words(decision.verdict) << '\n';
    for (const std::string& reason : reasons(decision)) {
        continue_section(out);
        out << reason << '\n';
    }
}

void write_degrees(std::ostream& out, const std::vector<DegreeRecord>& degrees) {
    section(out, "degree");
    if (degrees.empty()) out << "none on file\n";
    for (const DegreeRecord& degree : degrees) {
        if (&degree != &degrees.front()) continue_section(out);
        out << in_words(degree) << ' ' << name(degree.status) << ": " << degree.source << " (#"
            << degree.number << ")\n";
    }
}

void write_classes(std::ostream& out, const Decision& decision,
                   const std::vector<DegreeRecord>& degrees) {
    if (is_camera_minimal(decision) && decision.problem.front().views() == 3) {
        section(out, "terminal");
        out << or_nothing(decision.terminal) << '\n';
    }
    if (!decision.classes) return;
    section(out, "number");
    out << '#' << decision.classes->label << " of the label classes, swap class #"
        << decision.classes->swap << ", constraint class #" << decision.classes->constraint << '\n';
    section(out, "families");
    const std::vector<std::string> names = family_names(*decision.families);
    if (names.empty()) out << "none of the named ones\n";
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) continue_section(out);
        out << names[i] << '\n';
    }
    if (is_camera_minimal(decision)) write_degrees(out, degrees);
}

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

Json json_degree(const DegreeRecord& degree) {
    return {{"value", degree.degree},
            {"bound", name(degree.bound)},
            {"status", name(degree.status)},
            {"source", degree.source},
            {"number", degree.number}};
}

Json json_families(const Families& families) {
    return {{"pl0p", families.pl0p},
            {"at_most_one_pin", families.at_most_one_pin},
            {"plmp", families.plmp ? Json(*families.plmp) : Json()},
            {"five_point_extension", families.five_point_extension},
            {"registration", families.registration},
            {"trifocal_linear", families.trifocal_linear}};
}

} // namespace

std::string text_report(const Decision& decision, const std::vector<DegreeRecord>& degrees) {
    std::ostringstream out;
    section(out, "problem");
    out << notation(decision.problem) << '\n';
    write_dimensions(out, decision);
    write_reduction(out, decision);
    write_verdict(out, decision);
    write_classes(out, decision, degrees);
    return out.str();
}

std::string json_report(const Decision& decision, const std::vector<DegreeRecord>& degrees) {
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
    if (decision.classes) {
        report["number"] = decision.classes->label;
        report["swap_class"] = decision.classes->swap;
        report["constraint_class"] = decision.classes->constraint;
        report["families"] = json_families(*decision.families);
    }
    if (!degrees.empty() && is_camera_minimal(decision)) {
        report["degree"] = json_degree(degrees.front());
        for (const DegreeRecord& degree : degrees)
            report["degrees"].push_back(json_degree(degree));
    }
    return report.dump(2) + "\n";
}

} // namespace plprove
