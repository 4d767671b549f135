#include "prover/degree_sweep/plan.h"

#include "prover/catalogue/degrees.h"

#include <algorithm>

namespace plprove {

SweepPlan plan_sweep(const SweepFolder& folder, const std::vector<std::size_t>& classes,
                     const DegreeOptions& options, bool retry) {
    SweepPlan plan;
    plan.options = options;
    for (const std::size_t number : classes) {
        folder.require_place(number);
        const std::optional<ClassResult> result = folder.read(number, retry);
        if (result && (fulfils(*result, options) || (!retry && attempted(*result, options))))
            continue;
        plan.classes.push_back(number);
    }
    std::ranges::stable_sort(plan.classes, {}, degree_on_file);
    for (const std::size_t number : plan.classes) {
        const int degree = degree_on_file(number).value();
        plan.costs.push_back(options.target > 0 ? std::min(degree, options.target) : degree);
    }
    return plan;
}

std::vector<std::size_t> share_of(std::vector<std::size_t> classes, std::size_t process,
                                  std::size_t processes) {
    std::ranges::stable_sort(classes, std::greater<>(), degree_on_file);
    std::vector<std::size_t> share;
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const bool to = (i / processes) % 2 == 0;
        if (i % processes == (to ? process : processes - 1 - process)) share.push_back(classes[i]);
    }
    return share;
}

} // namespace plprove
