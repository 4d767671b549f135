// Sweeps with the fake engine, for tests of what they keep and collect.
#pragma once

#include "prover/degree_sweep/classes.h"
#include "prover/degree_sweep/plan.h"
#include "prover/degree_sweep/sweep.h"
#include "tests/fake_engine/fake_engine.h"

#include <algorithm>
#include <functional>
#include <stdexcept>

namespace plprove {

inline const SweepWatch unwatched{[](const SweepProgress&) {}, [] {}};

/// The numbers of all constraint classes of minimal problems.
inline std::vector<std::size_t> numbers_of_classes() {
    std::vector<std::size_t> numbers;
    for (const SweepItem& item : all_constraint_classes().items)
        numbers.push_back(item.number);
    return numbers;
}

/// The first of them.
inline std::vector<std::size_t> some_classes() {
    std::vector<std::size_t> classes = numbers_of_classes();
    classes.resize(300);
    return classes;
}

inline void run_sweep(const SweepFolder& folder, const std::vector<std::size_t>& classes,
                      const DegreeOptions& options, unsigned threads = 2, bool retry = false) {
    SweepPlan plan = plan_sweep(folder, classes, options, retry);
    plan.threads = threads;
    sweep(folder, plan, fake_engine::compute, unwatched);
}

inline std::size_t left_to_do(const SweepFolder& folder, const std::vector<std::size_t>& classes,
                              const DegreeOptions& options, bool retry = false) {
    return plan_sweep(folder, classes, options, retry).numbers.size();
}

/// The first class for which the condition holds.
inline std::size_t class_with(const std::function<bool(std::size_t)>& condition) {
    for (const std::size_t number : numbers_of_classes())
        if (condition(number)) return number;
    throw std::logic_error("no such class");
}

/// Whether the fake engine computes the class without fault.
inline bool is_well(std::size_t number) {
    return !fake_engine::throws(number) && !fake_engine::falls_short(number);
}

} // namespace plprove
