// What a model declares (FORMAT.md, section 16): how many scalars its data, unknowns and values
// have.
#pragma once

#include "checker/model/machine.h"

namespace checker {
/// Data, or unknowns, in order.
struct Declared {
    std::vector<std::pair<std::string, std::size_t>> names{}; // and how many scalars each has
    std::size_t scalars = 0;
};

struct Layout {
    Declared data{};
    Declared unknowns{};
    /// Of all names that are defined outside of loops: how many scalars they have.
    std::map<std::string, std::size_t> values{};
    std::size_t equations = 0;
    std::size_t relations = 0;
    std::size_t counted = 0; // 0: all unknowns count
    std::uint64_t multiplications = 0;
};

/// Executes the model without any numbers. Throws Malformed where it makes no sense, or is too
/// large.
Layout layout_of(const Program& program);
} // namespace checker
