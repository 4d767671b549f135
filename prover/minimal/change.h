// A change of a problem by one feature.
#pragma once

#include "prover/problem/feature.h"

#include <optional>

namespace plprove {

/// One of the problem's features is dropped, one is added, or one is put for another.
struct Change {
    std::optional<Feature> dropped;
    std::optional<Feature> added;

    auto operator<=>(const Change&) const = default;
};

/// `add P/P/-`, `drop a/a/a`, `put Pa/P/a for P/P/a`.
std::string in_words(const Change& change);

/// The problem with that change.
Features changed(const Features& problem, const Change& change);

} // namespace plprove
