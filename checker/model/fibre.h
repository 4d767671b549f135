// Fibres: all solutions for some data modulo q at once, as polynomials modulo g (FORMAT.md, section
// 16). They prove lower bounds on the number of solutions.
#pragma once

#include "checker/effort/execution.h"
#include "checker/model/extension.h"
#include "checker/model/layout.h"

namespace checker {
struct Fibre {
    std::vector<Residue> data{};
    Polynomial lower{}; // g without its highest term
    std::vector<Polynomial> unknowns{};
    Numbers separated_by{};
    std::size_t distinct = 0; // values that count; with nothing to count, solutions
    Numbers distinct_by{};
};

Fibre read_fibre(Reader& reader, const Layout& layout);

/// How many solutions the fibre proves. Throws Refused.
std::size_t check_fibre(const Program& program, const Layout& layout, const Fibre& fibre);

/// The effort of checking a fibre.
std::uint64_t effort_of(const Layout& layout, const Fibre& fibre);

/// Takes residues modulo q, `count` of them.
std::vector<Residue> read_residues(Reader& reader, std::size_t count);
} // namespace checker
