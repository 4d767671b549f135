// Files of problems as tests write them: without their first line, and what the checker makes of
// them.
#pragma once

#include "checker/replay.h"
#include "tests/support/all_classes.h"
#include "tests/support/text.h"

/// What the checker makes of a file of problems without its first line: `holds`, or the first
/// complaint as `line: reason`, after `syntax` if the file does not conform.
inline std::string outcome_of_problems(const std::string& rest) {
    const checker::ReplayedFile file =
        checker::replay(all_classes(), "file", "plcert 2 problems\n" + rest);
    if (const auto* malformed = std::get_if<checker::Malformed>(&file.content))
        return checker::say("syntax, ", malformed->complaint.line, ": ",
                            malformed->complaint.reason);
    const auto* content = std::get_if<checker::ProblemsFile>(&file.content);
    REQUIRE(content);
    if (content->refusals.count == 0) return "holds";
    const auto& [line, reason] = content->refusals.first[0];
    return checker::say(line, ": ", reason);
}

/// The same of one record: its line is 3.
inline std::string outcome_of_record(const std::string& record) {
    return outcome_of_problems("modulus 2305843009213693951\n" + record);
}

/// What is wrong with a notation; `holds` if nothing is.
inline std::string outcome_of_notation(const std::string& notation) {
    const std::string outcome = outcome_of_record("problem " + notation + "\nunbalanced\n");
    return contains(outcome, ": it is balanced") ? "holds" : outcome;
}
