#include "prover/minimal/decision.h"

#include "prover/minimal/block.h"
#include "prover/system/words.h"

#include <algorithm>
#include <numeric>

namespace plprove {

namespace {

int total(const Features& problem, int (*function)(const Feature&)) {
    int sum = 0;
    for (const Feature& feature : problem)
        sum += function(feature);
    return sum;
}

int dimension_in_images(const Feature& feature) {
    return weight(feature) + dimension_in_space(feature);
}

Verdict verdict_of(const Decision& decision) {
    if (decision.constraints < decision.camera_dimension) return Verdict::under_constrained;
    if (decision.constraints > decision.camera_dimension) return Verdict::over_constrained;
    if (decision.obstruction.deficiency() > 0) return Verdict::obstructed;
    return decision.balanced() ? Verdict::minimal : Verdict::camera_minimal;
}

std::string view_name(int view) {
    return std::to_string(view + 1);
}

const Feature& star_of(const Features& problem) {
    return *std::ranges::max_element(
        problem, {}, [](const Feature& feature) { return feature.has_point ? feature.lines : 0; });
}

std::string star_reason(const Features& problem) {
    const Feature& star = star_of(problem);
    const std::string point = "the point with " + std::to_string(star.lines) + " pins";
    const std::string slide = " slide along its ray to " + point +
                              ", so that the images of the "
                              "point and its pins stay";
    for (int view = 0; view < star.views(); ++view) {
        const auto seen = std::ranges::count_if(problem, [&](const Feature& feature) {
            return feature.sights[static_cast<std::size_t>(view)] != Sight{};
        });
        if (seen == 1 && problem.size() > 1)
            return "view " + view_name(view) + " sees only " + point + ": let camera " +
                   view_name(view) + slide + "; no other image notices";
    }
    if (star.lines >= 7)
        return "let each camera" + slide + ": up to scale, that is a family of 2 motions, and " +
               (star.lines == 8 ? "nothing else constrains them"
                                : "the other feature puts 1 condition on them");
    return "let each camera" + slide +
           ": up to scale, that is a family of 2 motions, and the free "
           "line puts 1 condition on them, since its normals are coplanar already";
}

} // namespace

std::string_view name(Verdict verdict) {
    switch (verdict) {
    case Verdict::minimal:
        return "minimal";
    case Verdict::camera_minimal:
        return "camera-minimal";
    case Verdict::obstructed:
        return "obstructed";
    case Verdict::under_constrained:
        return "under-constrained";
    case Verdict::over_constrained:
        return "over-constrained";
    }
    return {};
}

Decision decide(const Features& problem) {
    Decision decision;
    decision.problem = problem;
    decision.reduction = reduce(problem);
    decision.lifted = lifted(decision.reduction.reduced);
    decision.terminal = terminal(decision.reduction.reduced);
    decision.space_dimension = total(problem, dimension_in_space);
    decision.image_dimension = total(problem, dimension_in_images);
    const int views = problem.front().views();
    decision.camera_dimension = calibrated_cameras.dimension(views);
    decision.constraints = total(decision.lifted, weight);
    decision.obstruction = obstruction(decision.lifted);
    // Of a problem that is not balanced, a star says nothing about the rank.
    if (decision.constraints != decision.camera_dimension) decision.obstruction.star = 0;
    decision.verdict = verdict_of(decision);

    const auto signature = views == 3 ? signature_of(decision.lifted) : std::nullopt;
    if (signature && decision.constraints == decision.camera_dimension) {
        const std::vector<Signature>& classes = label_classes();
        decision.classes = {class_number(classes, representative(*signature)),
                            class_number(classes, swap_representative(*signature)),
                            class_number(classes, constraint_representative(*signature))};
        decision.families = families_of(*signature, decision.obstruction.deficiency() == 0);
    }
    return decision;
}

std::vector<std::string> reasons(const Decision& decision) {
    std::vector<std::string> result;
    const int missing = decision.camera_dimension - decision.constraints;
    const std::string given = "the images put " + counted(decision.constraints, "constraint") +
                              " on the " + std::to_string(decision.camera_dimension) +
                              " camera parameters";
    switch (decision.verdict) {
    case Verdict::minimal:
        result.push_back(given + ", independent at generic images, and the problem is balanced");
        break;
    case Verdict::camera_minimal:
        result.push_back(given + ", independent at generic images");
        result.push_back(
            "not minimal, since it is unbalanced: the images leave " +
            counted(decision.space_dimension + decision.camera_dimension - decision.image_dimension,
                    "degree") +
            " of freedom of the scene open");
        break;
    case Verdict::under_constrained:
        result.push_back(given + ": under-constrained by " + std::to_string(missing));
        break;
    case Verdict::over_constrained:
        result.push_back(given + ": over-constrained by " + std::to_string(-missing));
        break;
    case Verdict::obstructed:
        result.push_back(given + ", but " + std::to_string(decision.obstruction.deficiency()) +
                         " fewer are independent, at any images");
        break;
    }
    for (std::size_t pair = 0; pair < view_pairs.size(); ++pair)
        if (const int excess = decision.obstruction.excess[pair]; excess > 0)
            result.push_back("views " + view_name(view_pairs[pair][0]) + " and " +
                             view_name(view_pairs[pair][1]) + " share " +
                             std::to_string(excess + 5) +
                             " points, but their relative pose has only 5 degrees of freedom");
    if (decision.obstruction.star > 0) result.push_back(star_reason(decision.lifted));
    return result;
}

} // namespace plprove
