#include "prover/degree_sweep/plan.h"

#include "prover/catalogue/degrees.h"

#include <algorithm>
#include <limits>

namespace plprove {

SweepPlan plan_sweep(const SweepFolder& folder, const std::vector<std::size_t>& classes,
                     const DegreeOptions& options, bool retry) {
    constexpr double unknown = std::numeric_limits<double>::infinity();
    std::vector<std::pair<double, std::size_t>> wanted;
    double largest = 1; // of the known ones
    for (const std::size_t number : classes) {
        folder.require_place(number);
        const std::optional<ClassResult> result = folder.read(number, retry);
        if (result && (fulfils(*result, options) || (!retry && attempted(*result, options))))
            continue;
        double expected = result ? result->degree() : 0;
        if (expected == 0) expected = degree_on_file(number).value_or(0);
        largest = std::max(largest, expected);
        wanted.emplace_back(expected > 0 ? expected : unknown, number);
    }
    std::ranges::sort(wanted);
    if (options.target > 0) largest = options.target;
    SweepPlan plan;
    plan.options = options;
    plan.on_file = classes.size() - wanted.size();
    for (const auto& [expected, number] : wanted) {
        plan.classes.push_back(number);
        plan.costs.push_back(std::min(expected, largest));
    }
    return plan;
}

SweepPlan largest_first(SweepPlan plan) {
    std::ranges::reverse(plan.classes);
    std::ranges::reverse(plan.costs);
    return plan;
}

} // namespace plprove
