// Fibres: all solutions for some data modulo q at once, as polynomials modulo g (FORMAT.md, section
// 16). They prove lower bounds on the number of solutions.
#pragma once

#include "checker/fibres/extension.h"
#include "checker/file/reader.h"

namespace checker {
/// A solution for each root of g.
struct Fibre {
    Polynomial lower{};                 // g without its highest term
    std::vector<Polynomial> unknowns{}; // at t
    Numbers separated_by{};             // t is the sum of the first unknowns, each times its number
};

/// Takes a word, residues, and the end of the line.
std::vector<Residue> read_residue_line(Reader& reader, std::string_view word, std::size_t count);

/// Takes numbers of at most six digits.
Numbers read_numbers(Reader& reader, std::size_t count);

/// Takes the line with the degree of g.
std::size_t read_fibre_degree(Reader& reader);

/// Takes the lines from `polynomial` to `separated by`, which has so many numbers.
Fibre read_fibre(Reader& reader, std::size_t degree, std::size_t unknowns, std::size_t separating);

/// The sum of the first values, each times its number.
Polynomial combination_of(const Extension& extension, const Numbers& numbers,
                          const std::vector<Polynomial>& values);

/// Throws Refused unless g has no multiple root, and the unknowns differ at its roots.
void require_separate_solutions(const Extension& extension, const Fibre& fibre);
} // namespace checker
