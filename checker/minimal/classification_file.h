// Classification files (FORMAT.md, sections 5 and 6): a certificate for each label class.
#pragma once

#include "checker/file/reader.h"
#include "checker/minimal/obstruction.h"

namespace checker {
/// What a record proves: the obstruction of a label class, which is minimal if there is none.
struct ClassVerdict {
    std::size_t number = 0; // of the class
    Obstruction obstruction{};
};

/// What a classification file proves.
struct ClassificationFile {
    std::vector<ClassVerdict> verdicts{};
    Refusals refusals{};
};

/// Replays a file after its first line. Throws Malformed.
ClassificationFile replay_classification(Reader& reader, const Classification& classes);
} // namespace checker
