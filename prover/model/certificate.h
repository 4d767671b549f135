// What is known of a model, and the file that certifies it (certs/FORMAT.md, section 16).
#pragma once

#include "prover/model/elimination.h"
#include "prover/model/solution_point.h"

#include <functional>
#include <optional>
#include <span>
#include <string>

namespace plprove::model {

/// A model, and what was found of it.
struct Study {
    Model model;
    Program program;
    std::optional<Fibre> fibre;
    std::string no_fibre; ///< why there is no fibre, else empty
    std::string only_one; ///< why the fibre has one solution, where there may be more; else empty
    RanksSeen ranks;      ///< if there is no fibre, and as many equations as unknowns
    std::optional<Elimination> elimination;
    std::string no_elimination; ///< why there is no elimination, else empty

    /// Fewer equations than unknowns determine no solution.
    bool is_underdetermined() const { return program.equations.size() < program.unknowns; }

    /// How many solutions there are at least; 0 if that is not known.
    std::size_t at_least() const { return fibre ? fibre->count() : 0; }

    /// How many solutions there are at most; nothing if that is not known.
    std::optional<std::size_t> at_most() const;
};

/// How to find a fibre of a model with as many equations as unknowns.
using FibreFinder = std::function<FibreSearch(const Model&, const Program&)>;

/// By a Gröbner basis.
FibreSearch fibre_by_basis(const Model& model, const Program& program);

/// Reads a model, and looks for a fibre and an elimination. Throws ModelError where the text is not
/// well-formed, and BadInput if a relation does not hold.
Study study(std::string_view text, const FibreFinder& find = fibre_by_basis);

/// The file with what was found. Throws BadInput if that is nothing, and FormatLimit if the file is
/// larger than the format allows.
std::string write(const Study& study);

/// The same with these fibres in place of the one that was found.
std::string write(const Study& study, std::span<const Fibre> fibres);

} // namespace plprove::model
