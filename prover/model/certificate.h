// What is known of a model, and the file that certifies it (certs/FORMAT.md, section 16).
#pragma once

#include "prover/model/elimination.h"
#include "prover/model/solution_point.h"

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

/// Reads a model, and looks for a fibre and an elimination. Throws ModelError where the text is not
/// well-formed, and BadInput if a relation does not hold.
Study study(std::string_view text);

/// The file with what was found. Throws BadInput if that is nothing, and FormatLimit if the file is
/// larger than the format allows.
std::string write(const Study& study);

/// The same with these fibres in place of the one that was found.
std::string write(const Study& study, std::span<const Fibre> fibres);

} // namespace plprove::model
