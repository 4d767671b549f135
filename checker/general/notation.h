// The notation of problems in general (FORMAT.md, section 13).
#pragma once

#include "checker/file/reader.h"
#include "checker/general/problem.h"

namespace checker::general {
/// A problem as written, and what it means.
struct Written {
    std::string notation{};
    Problem problem{};
};

/// Takes a notation and the end of its line. Throws Malformed.
Written read_notation(Reader& reader);
} // namespace checker::general
