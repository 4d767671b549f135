// What `plprove problem` says: the decision about a problem, for people and for machines.
#pragma once

#include "prover/catalogue/degrees.h"
#include "prover/catalogue/groups.h"
#include "prover/minimal/hints.h"

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace plprove {

/// What `plprove problem` knows of a problem. A problem that fixes its cameras has a degree, which
/// is certified.
struct ProblemReport {
    Decision decision;
    std::vector<Hint> hints; ///< changes that make it minimal
};

/// The degree of a problem that was decided; nothing if it does not fix its cameras.
std::optional<int> degree_of(const Decision& decision);
/// The group of its solutions, where it is known.
std::optional<GroupOnFile> group_of(const Decision& decision);

/// A section of a group that is on file.
void write_group(std::ostream& out, const GroupOnFile& group);
/// The same as a JSON object.
nlohmann::ordered_json group_json(const GroupOnFile& group);

/// Decides, and looks for hints.
ProblemReport report_on(const Features& problem);

/// The decision in words, one fact a paragraph.
std::string text_report(const ProblemReport& report);

/// The same as a JSON object.
std::string json_report(const ProblemReport& report);

} // namespace plprove
