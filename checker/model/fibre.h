// Fibres of models (FORMAT.md, section 16). They prove lower bounds on the number of solutions.
#pragma once

#include "checker/effort/execution.h"
#include "checker/fibres/fibre.h"
#include "checker/model/layout.h"

namespace checker {
struct ModelFibre {
    std::vector<Residue> data{};
    Fibre solutions{};
    std::size_t distinct = 0; // values that count; with nothing to count, solutions
    Numbers distinct_by{};
};

ModelFibre read_fibre(Reader& reader, const Layout& layout);

/// Throws Refused unless the fibre proves its number of solutions, as many as `distinct` says. A
/// polynomial with as many roots, one for each value that counts, its highest term left out; empty
/// if there may be more of these.
Polynomial check_fibre(const Program& program, const Layout& layout, const ModelFibre& fibre);

/// The effort of checking a fibre.
std::uint64_t effort_of(const Layout& layout, const ModelFibre& fibre);
} // namespace checker
