#include "prover/degree_sweep/plan.h"

#include <algorithm>
#include <limits>

namespace plprove {

namespace {

/// By which items are ordered: an unknown degree is taken for a large one.
int expected_degree(const SweepSubject& subject, std::size_t number) {
    const int degree = subject.at(number).degree;
    return degree > 0 ? degree : std::numeric_limits<int>::max();
}

/// How many solutions the user may expect to wait for.
int expected_cost(int degree, const DegreeOptions& options) {
    constexpr int usual_degree = 1000;
    if (degree == 0) degree = std::max(usual_degree, options.target);
    return options.target > 0 ? std::min(degree, options.target) : degree;
}

} // namespace

SweepPlan plan_sweep(const SweepFolder& folder, const std::vector<std::size_t>& numbers,
                     const DegreeOptions& options, bool retry) {
    SweepPlan plan;
    plan.options = options;
    for (const std::size_t number : numbers) {
        folder.require_place(number);
        const std::optional<SweepResult> result = folder.read(number, retry);
        if (result && (fulfils(*result, options) || (!retry && attempted(*result, options))))
            continue;
        plan.numbers.push_back(number);
    }
    const SweepSubject& subject = folder.subject();
    std::ranges::stable_sort(plan.numbers, {},
                             [&](std::size_t number) { return expected_degree(subject, number); });
    for (const std::size_t number : plan.numbers)
        plan.costs.push_back(expected_cost(subject.at(number).degree, options));
    return plan;
}

std::vector<std::size_t> share_of(const SweepSubject& subject, std::vector<std::size_t> numbers,
                                  std::size_t process, std::size_t processes) {
    std::ranges::stable_sort(numbers, std::greater<>(),
                             [&](std::size_t number) { return expected_degree(subject, number); });
    std::vector<std::size_t> share;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const bool to = (i / processes) % 2 == 0;
        if (i % processes == (to ? process : processes - 1 - process)) share.push_back(numbers[i]);
    }
    return share;
}

} // namespace plprove
