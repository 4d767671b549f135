// Random residues that nobody chose: they follow from the words of a model.
#pragma once

#include "prover/geometry/modular.h"
#include "prover/model/model.h"

#include <vector>

namespace plprove::model {

/// A sequence of random numbers (splitmix64). Different streams are independent.
class RandomResidues {
public:
    /// From the SHA-256 digest of the model's lines.
    RandomResidues(const Model& model, std::uint64_t stream);

    std::uint64_t bits();
    Modular residue();
    std::vector<Modular> residues(std::size_t count);
    /// From -bound to bound.
    int integer(int bound);

private:
    std::uint64_t state_;
};

} // namespace plprove::model
