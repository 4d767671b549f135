#include "prover/model/total_degree.h"

#include "prover/model/evaluation.h"

#include <algorithm>

namespace plprove::model {

namespace {

/// Degrees of numerators and denominators.
struct DegreeRing {
    struct Scalar {
        std::size_t above = 0, below = 0;
    };

    static Scalar constant(int) { return {}; }
    static Scalar zero() { return {}; }
    static Scalar datum(std::size_t) { return {1, 0}; }
    static Scalar unknown(std::size_t) { return {1, 0}; }
    static Scalar sum(const Scalar& a, const Scalar& b) {
        return {std::max(a.above + b.below, b.above + a.below), a.below + b.below};
    }
    static Scalar difference(const Scalar& a, const Scalar& b) { return sum(a, b); }
    static Scalar product(const Scalar& a, const Scalar& b) {
        return {a.above + b.above, a.below + b.below};
    }
    static Scalar quotient(const Scalar& a, const Scalar& b, const Operation&) {
        return {a.above + b.below, a.below + b.above};
    }
};

} // namespace

std::size_t sum_of_degrees(const Program& program) {
    DegreeRing ring;
    const std::vector<ScalarIndex> equations = scalars_of(program.equations);
    const auto degrees = evaluate(program, ring, equations);
    std::size_t sum = 0;
    for (const ScalarIndex equation : equations)
        sum += degrees[equation].above;
    return sum;
}

} // namespace plprove::model
