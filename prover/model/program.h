// What a model computes: its data and unknowns, and a straight-line program for the scalars that
// its statements speak of. Any ring will do to run it (evaluation.h).
#pragma once

#include "prover/model/model.h"

#include <string>
#include <vector>

namespace plprove::model {

/// A scalar of a program: the index of the operation that computes it.
using ScalarIndex = std::size_t;

/// One operation. `left` and `right` are indices of operations before it; of a constant, a datum or
/// an unknown, `left` is its value or its number, from 0.
struct Operation {
    enum class Kind : std::uint8_t {
        constant,
        zero, ///< a 0 that has no degree
        datum,
        unknown,
        copy, ///< a scalar of a `let` statement
        sum,
        difference,
        product,
        quotient
    };
    Kind kind = Kind::constant;
    /// Whether a datum or an unknown occurs in what is computed.
    bool varies = false;
    std::size_t left = 0;
    std::size_t right = 0;
    std::size_t division = 0; ///< of a quotient: the number of the `/`, as they are executed
    bool by_variable = false; ///< of a quotient: whether the divisor has data or unknowns
};

/// An array: its shape, and its scalars in lexicographic order of the indices.
struct Array {
    std::vector<int> shape;
    std::vector<ScalarIndex> scalars;
};

/// A name and its array.
struct Named {
    std::string name;
    Array value;
};

/// A scalar, and the place in the text that it comes from.
struct Located {
    ScalarIndex scalar = 0;
    Position at;
};

struct Program {
    std::vector<Operation> operations;
    std::size_t data = 0;     ///< how many scalars
    std::size_t unknowns = 0; ///< how many scalars
    std::vector<Named> data_names, unknown_names;
    std::vector<Named> lets; ///< those outside of loops; their scalars are copies
    std::vector<Located> equations;
    std::vector<Located> relations;
    std::vector<Located> conditions;
    std::vector<ScalarIndex> counted;       ///< by `count` statements
    bool counts = false;                    ///< whether there is a `count` statement
    std::vector<std::string> related;       ///< names in `relation` statements
    std::vector<std::string> counted_names; ///< names in `count` statements
};

/// Compiles a model. Throws ModelError where shapes do not fit, or a limit of the format is
/// exceeded.
Program compile(const Model& model);

} // namespace plprove::model
