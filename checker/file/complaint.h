// The two ways in which a file fails (FORMAT.md, section 6): it violates the grammar, and nothing
// in it counts; or a record does not prove what it says, and this record does not count.
#pragma once

#include "checker/file/text.h"

#include <vector>

namespace checker {
/// What is wrong with a line of a file; line 0 is the file as a whole.
struct Complaint {
    std::size_t line = 0;
    std::string reason;
};

/// Thrown where a file violates the grammar.
struct Malformed {
    Complaint complaint;
};

/// Thrown where a record does not prove what it says.
struct Refused {
    template <class... Part> explicit Refused(const Part&... parts) : reason(say(parts...)) {}
    std::string reason;
};

/// The records of a file that are refused: how many, and the first of them.
struct Refusals {
    static constexpr std::size_t most_reported = 20;
    std::size_t count = 0;
    std::vector<Complaint> first{};

    void add(std::size_t line, std::string reason) {
        if (count < most_reported) first.push_back({line, std::move(reason)});
        ++count;
    }
};
} // namespace checker
