// What text and JSON say of a decision, in other words.
#pragma once

#include "prover/minimal/decision.h"

#include <string>
#include <vector>

namespace plprove {

/// Equal features of the problem, counted, with the degrees of freedom of one of them.
struct FeatureRow {
    std::string notation;
    int count = 0;
    int space = 0;
    int images = 0;
};

std::vector<FeatureRow> feature_rows(const Features& problem);

bool is_camera_minimal(const Decision& decision);

/// Whether two problems differ by the order of their features and the names of pins at most.
bool same_features(const Features& a, const Features& b);

/// What the problem has to do with the label class that it is decided by.
enum class Standing { member, terminal, dangling, reducible };

/// Assumes that the decision has classes.
Standing standing_of(const Decision& decision);

std::string_view name(Standing standing);

} // namespace plprove
