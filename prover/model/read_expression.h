// Reading sums and indices.
#pragma once

#include "prover/model/cursor.h"
#include "prover/model/model.h"
#include "prover/model/names.h"

namespace plprove::model {

/// The names that may stand in a sum, and those of loops, which may stand in an index.
struct Names {
    Scope all;
    Scope loops;
};

/// Reads a sum. Throws ModelError.
Expression read_sum(Cursor& cursor, const Names& names);

/// Reads an index. Throws ModelError.
Index read_index(Cursor& cursor, const Names& names);

} // namespace plprove::model
