// Files of problems (FORMAT.md, section 13): single problems, or all of a family.
#pragma once

#include "checker/effort/execution.h"
#include "checker/family/family.h"
#include "checker/file/reader.h"

namespace checker {
/// What a file of problems proves.
struct ProblemsFile {
    const Family* family = nullptr; // null if the file claims none
    std::size_t missing = 0;        // problems of the family that have no record that holds
    std::vector<ProblemVerdict> verdicts{};
    Refusals refusals{};
};

/// Replays a file after its first line. Throws Malformed.
ProblemsFile replay_problems(Reader& reader, const Execution& execution);

/// The file's family if each of its problems has a record that holds; else null.
const Family* complete_family(const ProblemsFile& file);

/// How many problems the number counts.
std::size_t value_of(const FamilyNumber& number, const ProblemsFile& file);
} // namespace checker
