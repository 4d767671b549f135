// The notation of problems, sums of features: `2*Pa/Pa/Pa + P/P/P`, and with shared lines, more
// views or other cameras `projective: 3*PL/PL/PL + Pa/Pa/Pa`. docs/notation.md explains it,
// certs/FORMAT.md specifies it in sections 1 and 13.
#pragma once

#include "prover/problem/problem.h"

#include <string_view>

namespace plprove {

/// The largest number of features of a problem: readers refuse more.
inline constexpr std::size_t max_features = 1000;

/// Reads one feature of section 1, such as `Pa/Pa/a`. Throws NotationError.
Feature parse_feature(std::string_view text);

/// Reads a sum of such features with multiplicities, in two or three views; blanks around `+` and
/// `*` may be left out or added. Throws NotationError.
Features parse_features(std::string_view text);

/// The kind of cameras with which the notation of a problem begins.
const CameraModel& cameras_of(std::string_view text);

/// Reads any problem, in 2 to 12 views. Points that are not in an order of construction are put
/// into one. Lines are numbered as they appear: feature by feature, new capital letters first, then
/// small letters, in alphabetical order. Throws NotationError.
Problem parse_problem(std::string_view text);

/// `Pa/Pa/a`: the views in order, `P` for the point, letters for the lines, `-` for nothing; then,
/// in parentheses, what exists but no view sees.
std::string notation(const Feature& feature);

/// The sum, equal neighbours joined: `2*Pa/Pa/Pa + P/P/P`.
std::string notation(const Features& features);

/// First the points in their order, each with its pins, then the free lines. parse_problem() reads
/// it again; its lines may then have other numbers. Throws NotationError if a point has more than
/// 26 pins, or more than 25 lines have two points or more.
std::string notation(const Problem& problem);

} // namespace plprove
