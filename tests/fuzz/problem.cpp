// Fuzzed: the ways to name a problem (notation, name, number, signature, the authors' Macaulay2
// encoding), hints, and parts of problems. What is accepted obeys the laws below; what is not is
// refused with a message.
#include "prover/catalogue/part.h"
#include "prover/minimal/hints.h"
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

void check(const Features& problem) {
    require(!problem.empty() && problem.size() <= max_features, "an impossible size");
    require(std::ranges::all_of(
                problem,
                [&](const Feature& feature) { return feature.views() == problem.front().views(); }),
            "features in different numbers of views");
    const std::string text = notation(problem);
    require(parse_features(text) == problem, "notation does not survive a round trip");
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
    Features other(problem.rbegin(), problem.rend());
    for (Feature& feature : other)
        std::ranges::reverse(feature.sights);
    const Decision mirrored = decide(other);
    require(mirrored.verdict == decision.verdict && mirrored.constraints == decision.constraints,
            "a relabeled problem has another verdict");
    require(mirrored.classes.has_value() == decision.classes.has_value() &&
                (!decision.classes || mirrored.classes->swap == decision.classes->swap),
            "a relabeled problem has another swap&label class");
}

/// What hints lead to is minimal, and one feature away.
void check_hints(const Features& problem) {
    const Decision decision = decide(problem);
    const auto size = static_cast<std::ptrdiff_t>(problem.size());
    for (const Hint& hint : hints(decision)) {
        const Features& changed = hint.decision.problem;
        const std::ptrdiff_t expected = size + hint.added.has_value() - hint.dropped.has_value();
        require(std::ssize(changed) == expected, "a hint of more than one feature");
        const Verdict verdict = decide(changed).verdict;
        require(verdict == Verdict::minimal || verdict == Verdict::camera_minimal,
                "a hint that does not help");
    }
}

/// A problem contains its own features, and they contain it.
void check_part(const Features& problem) {
    std::vector<Part> parts;
    try {
        parts = parse_part(notation(problem));
    } catch (const NotationError&) {
        return;
    }
    Features fixed;
    for (const Feature& feature : problem)
        fixed.push_back(lifted(feature));
    const auto signature = signature_of(fixed);
    require(signature.has_value(), "a part of other features than the 27");
    require(contains(*signature, parts.front()), "a problem lacks its own features");
    require(is_contained(*signature, parts.front()), "a problem has more than its own features");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Features problem;
    try {
        problem = parse_spec({reinterpret_cast<const char*>(data), size});
    } catch (const NotationError& error) {
        const std::string_view reason = error.what();
        const bool has_place = reason.starts_with("column ");
        const bool is_name = reason.find(" is no name of a problem") != std::string_view::npos;
        require(has_place || is_name, "a message without a place");
        require(reason.size() < 1000, "a long message");
        require(std::ranges::all_of(reason, [](char c) { return c >= ' ' && c <= '~'; }),
                "a message unfit for a terminal");
        return 0;
    }
    check(problem);
    check_hints(problem);
    check_part(problem);
    return 0;
}
