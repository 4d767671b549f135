// Reading the notation for local features and problems: `2*Pa/Pa/Pa + P/P/P`. certs/FORMAT.md,
// section 1, specifies it.
#pragma once

#include "prover/problem/feature.h"

#include <stdexcept>
#include <string_view>
#include <vector>

namespace plprove {

/// A text that is not a problem: what was found, at which column (from 1), and what was expected.
class NotationError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A sum of local features, each listed as often as it occurs.
using Features = std::vector<Feature>;

/// The largest number of features of a problem: readers refuse more.
inline constexpr std::size_t max_features = 1000;

/// Reads one feature, such as `Pa/Pa/a`. Throws NotationError.
Feature parse_feature(std::string_view text);

/// Reads a sum of features with multiplicities; blanks around `+` and `*` may be left out or added.
/// Throws NotationError.
Features parse_features(std::string_view text);

/// The sum in notation, equal neighbours joined: `2*Pa/Pa/Pa + P/P/P`.
std::string notation(const Features& problem);

} // namespace plprove
