// Classification files as tests of the grammar write them, and what is wrong with them.
#pragma once

#include "checker/replay.h"
#include "tests/support/all_classes.h"

#include <doctest/doctest.h>

inline const std::string pool =
    "pool 1\ncamera 2 quaternion 1 0 0 1 translation 1 2 3\n"
    "camera 3 quaternion 1 1 0 1 translation 3 2 1\nfeature P/P/P point 1 2 3\n";

/// What is wrong with a file that does not conform, as `line: reason`.
inline std::string complaint(const std::string& bytes) {
    const checker::ReplayedFile file = checker::replay(all_classes(), "file", bytes);
    const auto* malformed = std::get_if<checker::Malformed>(&file.content);
    CAPTURE(bytes.substr(0, 500));
    REQUIRE(malformed);
    return checker::say(malformed->complaint.line, ": ", malformed->complaint.reason);
}
