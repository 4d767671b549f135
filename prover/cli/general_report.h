// What plprove prints of problems in general (prover/general).
#pragma once

#include "prover/minimal/problem_record.h"

#include <optional>
#include <span>
#include <string>

namespace plprove {

/// The degree of a minimal problem in at most three calibrated views whose points share no lines,
/// but such as two points imply: that of its features, which is certified. Nothing for others.
std::optional<int> degree_of_features(const ProblemRecord& certificate);

/// The verdict on one problem, with its dimensions and the reason, for people and as JSON.
std::string text_report(const ProblemRecord& certificate);
std::string json_report(const ProblemRecord& certificate);

/// The same of a problem without a verdict: what is seen, as evidence.
std::string text_report(const Undecided& found);
std::string json_report(const Undecided& found);

/// One problem a line. Formats: `name`, `notation`, and `csv` with a header: views, free_points,
/// dependent_points, free_lines, adjacent_lines, minimal (1 or 0), degree (empty: not computed),
/// name, notation, reason, degree_status, degree_certified (empty: no lower bound is certified),
/// group, group_order, width and group_status (empty: not known).
std::string list_of(std::span<const ProblemRecord> certificates, const std::string& format);

} // namespace plprove
