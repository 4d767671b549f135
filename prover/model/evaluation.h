// Running a program over a ring. A ring has a type Scalar and functions
//   constant(int), zero(), datum(i), unknown(i), sum(a, b), difference(a, b), product(a, b),
//   quotient(a, b, operation): the operation says which `/` it is.
// `zero()` is the 0 of certs/FORMAT.md, section 16, that has no degree; other rings take
// constant(0).
#pragma once

#include "prover/model/program.h"

#include <functional>
#include <map>
#include <optional>

namespace plprove::model {

/// Which operations the scalars in `wanted` need; those in `given` need none.
template <class Scalar>
std::vector<bool> needed_operations(const Program& program, const std::vector<ScalarIndex>& wanted,
                                    const std::map<ScalarIndex, Scalar>& given) {
    using Kind = Operation::Kind;
    std::vector<bool> needed(program.operations.size());
    for (const ScalarIndex index : wanted)
        needed[index] = true;
    for (std::size_t i = program.operations.size(); i-- > 0;) {
        const Operation& operation = program.operations[i];
        if (!needed[i] || operation.kind < Kind::copy || given.contains(i)) continue;
        needed[operation.left] = true;
        needed[operation.right] = true;
    }
    return needed;
}

/// The value of one operation from those before it.
template <class Ring>
typename Ring::Scalar value_of(const Operation& operation, Ring& ring,
                               const std::vector<typename Ring::Scalar>& values) {
    using Kind = Operation::Kind;
    const auto left = [&]() -> const auto& {
        return values[operation.left];
    };
    const auto right = [&]() -> const auto& {
        return values[operation.right];
    };
    switch (operation.kind) {
    case Kind::constant:
        return ring.constant(static_cast<int>(operation.left));
    case Kind::zero:
        return ring.zero();
    case Kind::datum:
        return ring.datum(operation.left);
    case Kind::unknown:
        return ring.unknown(operation.left);
    case Kind::copy:
        return left();
    case Kind::sum:
        return ring.sum(left(), right());
    case Kind::difference:
        return ring.difference(left(), right());
    case Kind::product:
        return ring.product(left(), right());
    case Kind::quotient:
        break;
    }
    return ring.quotient(left(), right(), operation);
}

/// The values of the scalars in `wanted`, by their index in the program; others are as the ring's
/// Scalar begins. Scalars in `given` have the values there, whatever the program says.
template <class Ring>
std::vector<typename Ring::Scalar>
evaluate(const Program& program, Ring& ring, const std::vector<ScalarIndex>& wanted,
         const std::map<ScalarIndex, typename Ring::Scalar>& given = {}) {
    const std::vector<bool> needed = needed_operations(program, wanted, given);
    std::vector<typename Ring::Scalar> values(program.operations.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!needed[i]) continue;
        const auto place = given.find(i);
        values[i] =
            place != given.end() ? place->second : value_of(program.operations[i], ring, values);
    }
    return values;
}

/// The scalars of a list with places.
inline std::vector<ScalarIndex> scalars_of(const std::vector<Located>& list) {
    std::vector<ScalarIndex> result;
    for (const Located& item : list)
        result.push_back(item.scalar);
    return result;
}

} // namespace plprove::model
