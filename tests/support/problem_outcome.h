// Problem files as tests write them: without their first line, and what the checker makes of them.
#pragma once

#include "checker/replay.h"
#include "tests/support/all_classes.h"
#include "tests/support/text.h"

/// What the checker makes of a problem file without its first line: `holds`, or the complaint as
/// `line: reason`, after `syntax` if the file does not conform.
inline std::string outcome_of_problem(const std::string& rest) {
    const checker::ReplayedFile file =
        checker::replay(all_classes(), "file", "plcert 2 problem\n" + rest);
    if (const auto* malformed = std::get_if<checker::Malformed>(&file.content))
        return checker::say("syntax, ", malformed->complaint.line, ": ",
                            malformed->complaint.reason);
    const auto* content = std::get_if<checker::ProblemFile>(&file.content);
    REQUIRE(content);
    CHECK(content->verdict.empty() == (content->refusals.count > 0));
    if (content->refusals.count == 0) return "holds";
    CHECK(!content->of_class);
    REQUIRE(content->refusals.first.size() == 1);
    const auto& [line, reason] = content->refusals.first[0];
    return checker::say(line, ": ", reason);
}
