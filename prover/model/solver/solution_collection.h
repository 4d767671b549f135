// Numeric solutions of a model for the same data, told apart.
#pragma once

#include "prover/model/solver/model_solver.h"
#include "prover/model/solver/start.h"
#include "prover/monodromy/solution_set.h"

namespace plprove::model {

Numbers conjugate(Numbers numbers);

/// A set of solutions that are known to doubles: as near as Newton's method takes them.
SolutionSet<Numbers> no_solutions();

/// Solutions for the same data.
class SolutionCollection {
public:
    /// The arguments must outlive the collection.
    SolutionCollection(const Program& program, const Numbers& data);

    /// Adds the solution that this approximates, and its conjugate where the data are real.
    void add(const Numbers& approximation);

    /// Adds where paths from a start lead, on several ways until as many are found.
    void follow(const Start& start, const TrackedEquations& equations, std::uint64_t seed,
                unsigned threads);

    /// All solutions, whether what counts tells them apart or not.
    const std::vector<ModelSolution>& all() const { return found_; }

    /// Each that counts once, the real ones first, in the order of their numbers.
    std::vector<ModelSolution> counted() &&;

private:
    void add_new(const Numbers& solution, bool real);
    Numbers counted_by(const Numbers& unknowns) const;

    const Program& program_;
    const Numbers& data_;
    bool real_data_;
    SolutionSet<Numbers> known_;
    std::vector<ModelSolution> found_;
};

} // namespace plprove::model
