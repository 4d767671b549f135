// Fibres that certify the group of a model's solutions (proofs/fibres.md).
#pragma once

#include "prover/groups/cycle_types.h"
#include "prover/model/certificate.h"

#include <functional>

namespace plprove::model {

/// What fibres show of the group of the values that count.
struct GroupSearch {
    std::vector<CycleType> cycle_types; ///< of one permutation a fibre
    std::string group;                  ///< `S<d>`, `>=A<d>`, or empty, as plcheck will find
    std::vector<Fibre> fibres;          ///< as few as show it
};

/// Why no fibres can certify the group of this model; empty if they can.
std::string why_no_group(const Study& study);

/// Computes fibres, at random data, until the group is known or there are as many. Assumes that
/// they can certify it. `progress` is told how many there are.
GroupSearch find_group(const Study& study, int most,
                       const std::function<void(std::size_t)>& progress = {});

} // namespace plprove::model
