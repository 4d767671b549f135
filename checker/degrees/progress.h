// How a file is replayed: by how many threads, and who is told how far it is.
#pragma once

#include <cstddef>
#include <functional>

namespace checker {
struct Progress {
    std::size_t line = 0;      // of the file
    std::size_t records = 0;   // begun
    std::size_t solutions = 0; // proved
};

/// After so many refused records the rest of a file is not replayed, but refused: what is wrong
/// takes no longer than that.
inline constexpr std::size_t most_refusals = 100;

/// Is told so after each solution, or each template.
using Watch = std::function<void(const Progress&)>;

/// What is proved does not depend on any of this.
struct Execution {
    Watch watch = [](const Progress&) {};
    std::size_t threads = 1; // that prove solutions side by side
};
} // namespace checker
