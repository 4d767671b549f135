// How a fuzzed property fails: with a message, and an abort that fuzzers and ctest notice.
#pragma once

#include <cstdio>
#include <cstdlib>

inline void require(bool holds, const char* otherwise) {
    if (holds) return;
    std::fprintf(stderr, "fuzzed property violated: %s\n", otherwise);
    std::abort();
}
