#include "prover/cli/problem_report.h"

#include "prover/cli/problem_facts.h"
#include "prover/cli/sections.h"
#include "prover/problem/five_points.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace plprove {

namespace {

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

std::string or_nothing(const Features& problem) {
    return problem.empty() ? "nothing" : notation(problem);
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
        const std::string step =
            notation(steps[i].before) + " -> " +
            (steps[i].after ? notation(*steps[i].after) : std::string("nothing"));
        const std::string why(explanation(steps[i].rule));
        out << step;
        if (step.size() + 3 + why.size() <= text_width) {
            out << "   " << why << '\n';
        } else {
            out << '\n';
            continue_section(out);
            write_wrapped(out, why, 2);
        }
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

void write_verdict(std::ostream& out, const Decision& decision) {
    section(out, "verdict");
    out << verdict_in_words(decision.verdict) << '\n';
    for (const std::string& reason : reasons(decision)) {
        continue_section(out);
        write_wrapped(out, reason);
    }
}

void write_degree(std::ostream& out, const Decision& decision) {
    if (const std::optional<int> degree = degree_of(decision))
        section(out, "degree") << *degree << " certified\n";
    if (const auto group = group_of(decision)) write_group(out, *group);
}

/// The number of the class; of a problem that is none of its members, with a member.
std::string number_in_words(const Decision& decision) {
    const std::string number = '#' + std::to_string(decision.classes->label);
    const std::string of_class = number + " (" + notation(decision.lifted) + ")";
    switch (standing_of(decision)) {
    case Standing::member:
        return number + " of the label classes";
    case Standing::terminal:
        return "terminal problem of #" + of_class.substr(1);
    case Standing::dangling:
        return "with its dangling pins fixed, " + of_class;
    case Standing::reducible:
        return "reduces to " +
               std::string(same_features(decision.reduction.reduced, decision.lifted)
                               ? ""
                               : "a problem of ") +
               of_class;
    }
    return {};
}

void write_number(std::ostream& out, const Decision& decision) {
    section(out, "number");
    out << number_in_words(decision) << ", swap class #" << decision.classes->swap
        << ", constraint class #" << decision.classes->constraint << '\n';
}

void write_classes(std::ostream& out, const Decision& decision) {
    if (is_camera_minimal(decision) && decision.problem.front().views() == 3) {
        section(out, "terminal");
        out << or_nothing(decision.terminal) << '\n';
    }
    if (!decision.classes) return write_degree(out, decision);
    write_number(out, decision);
    section(out, "families");
    const std::vector<std::string> names = family_names(*decision.families);
    if (names.empty()) out << "none of the named ones\n";
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) continue_section(out);
        out << names[i] << '\n';
    }
    write_degree(out, decision);
}

/// `add -/P/P: minimal, #825, degree 160`
std::string with_verdict(const Hint& hint) {
    const Decision& decision = hint.decision;
    std::string text = in_words(hint) + ": " + std::string(name(decision.verdict));
    if (decision.classes) text += ", #" + std::to_string(decision.classes->label);
    if (const auto degree = degree_of(decision)) text += ", degree " + std::to_string(*degree);
    return text;
}

void write_hints(std::ostream& out, const std::vector<Hint>& hints) {
    constexpr std::size_t most = 8;
    if (hints.empty()) return;
    section(out, "hint");
    for (std::size_t i = 0; i < std::min(most, hints.size()); ++i) {
        if (i > 0) continue_section(out);
        out << with_verdict(hints[i]) << '\n';
    }
    if (hints.size() <= most) return;
    continue_section(out);
    out << "and " << hints.size() - most << " more: --json lists all\n";
}

} // namespace

std::optional<int> degree_of(const Decision& decision) {
    if (!is_camera_minimal(decision)) return std::nullopt;
    if (decision.classes) return degree_on_file(decision.classes->constraint);
    return degree_in_two_views;
}

std::optional<GroupOnFile> group_of(const Decision& decision) {
    if (!is_camera_minimal(decision)) return std::nullopt;
    if (decision.classes) return group_on_file(decision.classes->constraint);
    return family_group_on_file(five_point_problem);
}

void write_group(std::ostream& out, const GroupOnFile& group) {
    section(out, "group") << group.name << ' ' << group.status << '\n';
}

ProblemReport report_on(const Features& problem) {
    Decision decision = decide(problem);
    std::vector<Hint> changes = hints(decision);
    return {std::move(decision), std::move(changes)};
}

std::string text_report(const ProblemReport& report) {
    const Decision& decision = report.decision;
    std::ostringstream out;
    section(out, "problem");
    out << notation(decision.problem) << '\n';
    write_dimensions(out, decision);
    write_reduction(out, decision);
    write_verdict(out, decision);
    write_classes(out, decision);
    write_hints(out, report.hints);
    return out.str();
}

} // namespace plprove
