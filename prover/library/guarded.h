// No exception leaves the library.
#pragma once

#include "prover/library/pointline/result.h"
#include "prover/problem/notation.h"
#include "prover/system/exit.h"

namespace pointline {

/// What `compute` returns; as an Error what it throws, where BadInput is a `failure`.
template <class T, class Compute>
Result<T> guarded(Failure failure, Compute compute) noexcept try {
    return compute();
} catch (const plprove::NotationError& error) {
    return Error{Failure::bad_problem, error.what()};
} catch (const plprove::BadInput& error) {
    return Error{failure, error.what()};
} catch (const std::exception& error) {
    return Error{Failure::system, error.what()};
}

} // namespace pointline
