// How commands print a group of solutions.
#pragma once

#include "prover/groups/cycle_types.h"
#include "prover/groups/monodromy_group.h"

#include <nlohmann/json_fwd.hpp>
#include <ostream>

namespace plprove {

/// `S8 wr S2 wr S10`, `a subgroup of` this, or `a primitive subgroup of S27`.
std::string in_words(const MonodromyGroup& group);

/// The sections `order`, `steps` and `width`.
void write_steps(std::ostream& out, const MonodromyGroup& group);

/// A section `cycles` for each permutation.
void write_cycles(std::ostream& out, const std::vector<CycleType>& cycle_types);

/// The group as evidence by so many loops.
nlohmann::ordered_json evidence_json(const MonodromyGroup& group, int loops);

} // namespace plprove
