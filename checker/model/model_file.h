// Files of models (FORMAT.md, section 16): how many solutions a model has for generic data.
#pragma once

#include "checker/effort/execution.h"
#include "checker/fibres/frobenius.h"
#include "checker/file/reader.h"

#include <optional>

namespace checker {
/// What a file of a model proves.
struct ModelFile {
    std::string name{};
    std::string text{};                   // the lines of the model, by which models are the same
    std::size_t claimed = 0;              // by the model's source; 0 if nothing is claimed
    std::size_t at_least = 0;             // solutions, for generic data
    std::optional<std::size_t> at_most{}; // none: no elimination holds
    std::vector<CycleType> cycle_types{}; // of permutations of as many values that count, by fibres
    std::size_t records = 0; // fibres and eliminations that hold, and the dimension count
    Refusals refusals{};

    /// The group that the records show (frobenius.h); empty if none.
    std::string group() const {
        return at_most == at_least ? group_shown_by(cycle_types, at_least, Orbits::unknown) : "";
    }
};

/// Replays a file after its first line. Throws Malformed.
ModelFile replay_model(Reader& reader, const Execution& execution);
} // namespace checker
