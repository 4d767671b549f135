// A fibre of a model (certs/FORMAT.md, section 16): solutions for some data modulo q, all at once.
// It shows that the model has at least as many for generic data.
#pragma once

#include "prover/model/program.h"
#include "prover/model/quotient.h"
#include "prover/model/random_residues.h"

#include <optional>
#include <string>

namespace plprove::model {

struct Fibre {
    std::vector<Modular> data;
    Univariate polynomial;            ///< g, of the degree N
    std::vector<Univariate> unknowns; ///< of degrees less than N
    std::vector<int> form;            ///< t is the sum of the unknowns, each times its integer
    /// With a `count` statement: how many of the solutions differ in what counts, and the form in
    /// the scalars that count that tells them apart.
    std::size_t distinct = 0;
    std::vector<int> counted_form;
    Univariate values; ///< has a root for each solution, or for each value that counts

    /// How many solutions it shows.
    std::size_t count() const { return counted_form.empty() ? polynomial.degree() : distinct; }
};

/// What the search for a fibre ended with.
struct FibreSearch {
    std::optional<Fibre> fibre;
    std::string reason; ///< why there is none, else empty
};

/// All solutions of the model with random data, other ones for each stream (random_residues.h).
/// Assumes as many equations as unknowns.
FibreSearch find_fibre(const Model& model, const Program& program, std::uint64_t stream = 1);

/// The fibre of solutions for these data; t is the sum of the unknowns, each times its integer of
/// `form`. Solutions where conditions fail, or that are not regular, are left out.
FibreSearch fibre_of(const Program& program, std::vector<Modular> data, std::vector<int> form,
                     Solutions solutions, RandomResidues& random);

} // namespace plprove::model
