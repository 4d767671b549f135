// Reduction of a problem to the unique reduced problem of its kind: Theorems 2 and 7 of the paper
// for three views, the supplementary note on two views; and the way from reduced problems to
// minimal and terminal ones (Theorems 5 and 6, Definition 6).
//
// Reducing never changes whether a problem is camera-minimal, nor its camera-degree (Theorem 4).
#pragma once

#include "prover/problem/notation.h"

#include <optional>
#include <string_view>

namespace plprove {

/// The rules, in the order in which they are tried. certs/FORMAT.md, section 7, defines each.
enum class Rule {
    unseen_line,
    pin_seen_once,
    pin_seen_twice,
    free_line,
    unseen_point,
    bare_point,
    point_on_line,
    point_and_pin,
};

/// The rule's name in certificates, such as `pin-seen-once`.
std::string_view name(Rule rule);

/// What the rule does, in words, with its source.
std::string_view explanation(Rule rule);

/// One application: feature number `position` (from 0) of the problem so far becomes `after`, or is
/// forgotten.
struct ReductionStep {
    Rule rule{};
    std::size_t position = 0;
    Feature before;
    std::optional<Feature> after;
};

struct Reduction {
    std::vector<ReductionStep> steps;
    Features reduced;
};

/// The first rule that applies to the feature, with its result, or nothing where the feature is
/// reduced.
std::optional<ReductionStep> reduce_once(const Feature& feature);

/// Applies rules to each feature in turn until none applies.
Reduction reduce(const Features& problem);

/// A reduced feature with its dangling pins fixed by further views that see them (Theorem 6): P/P/a
/// becomes Pa/P/a, P/b/a and Pa/b/a become Pab/b/a. Other features stay as they are.
Feature lifted(const Feature& reduced);

/// The inverse: the feature that represents this one in terminal problems (Definition 6).
Feature terminal(const Feature& reduced);

/// The problem of the lifted, or terminal, features in the order of the 27 standard features,
/// others first.
Features lifted(const Features& reduced);
Features terminal(const Features& reduced);

} // namespace plprove
