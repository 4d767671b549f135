// Fuzzed: the ways to name a problem (notation, number, signature, the authors' Macaulay2
// encoding). What is accepted obeys the laws below; what is not is refused with a message.
#include "prover/classification/decision.h"
#include "prover/problem/spec.h"
#include "tests/fuzz/require.h"

#include <algorithm>

using namespace plprove;

namespace {

/// How much there is of a feature, counted so that each rule takes some away.
std::size_t size(const Feature& feature) {
    return static_cast<std::size_t>(2 * feature.lines) + feature.has_point;
}

// Enumerated before the clock of the fuzzer runs.
const std::size_t number_of_classes = label_classes().size();

void check(const Problem& problem) {
    require(!problem.empty() && problem.size() <= max_features, "an impossible size");
    require(std::ranges::all_of(
                problem,
                [&](const Feature& feature) { return feature.views() == problem.front().views(); }),
            "features in different numbers of views");
    const std::string text = notation(problem);
    require(parse_problem(text) == problem, "notation does not survive a round trip");
    require(parse_spec(text) == problem, "a specification reads notation differently");

    const Decision decision = decide(problem);
    for (const ReductionStep& step : decision.reduction.steps) {
        require(!step.after || size(*step.after) < size(step.before), "a rule takes nothing away");
        require(!step.after || parse_feature(notation(*step.after)) == *step.after,
                "a reduced feature does not survive a round trip");
    }
    for (const Feature& feature : decision.reduction.reduced)
        require(!reduce_once(feature), "a rule applies to a reduced problem");
    for (const Feature& feature : decision.lifted)
        require(!reduce_once(feature) && lifted(feature) == feature, "a lifted feature is not");
    require(!decision.classes || decision.classes->label < number_of_classes, "no such class");
    require(!reasons(decision).empty(), "a verdict without a reason");

    // (Which view fixes a dangling pin depends on their order, so the label class may differ.)
    // Neither the order of the views nor that of the features changes the verdict.
    Problem other(problem.rbegin(), problem.rend());
    for (Feature& feature : other)
        std::ranges::reverse(feature.sights);
    const Decision mirrored = decide(other);
    require(mirrored.verdict == decision.verdict && mirrored.constraints == decision.constraints,
            "a relabeled problem has another verdict");
    require(mirrored.classes.has_value() == decision.classes.has_value() &&
                (!decision.classes || mirrored.classes->swap == decision.classes->swap),
            "a relabeled problem has another swap&label class");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Problem problem;
    try {
        problem = parse_spec({reinterpret_cast<const char*>(data), size});
    } catch (const NotationError& error) {
        const std::string_view reason = error.what();
        require(reason.starts_with("column ") && reason.size() < 1000, "a message without a place");
        require(std::ranges::all_of(reason, [](char c) { return c >= ' ' && c <= '~'; }),
                "a message unfit for a terminal");
        return 0;
    }
    check(problem);
    return 0;
}
