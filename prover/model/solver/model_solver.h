// Numeric solutions of a model for given data, all of them: paths from random data, whose solutions
// are found once for a model.
//
// Numbers are approximate here, and nothing is certified.
#pragma once

#include "prover/model/model.h"
#include "prover/model/program.h"

#include <complex>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

namespace plprove::model {

struct ModelSolution {
    std::vector<std::complex<double>> unknowns; ///< all scalars, as they are numbered
    bool real = false;
    double residual = 0; ///< the largest value of an equation, relative to its terms
};

struct ModelAnswer {
    std::vector<ModelSolution> solutions; ///< different in what counts; real ones first
    std::size_t lost = 0;                 ///< how many fewer these are than for random data

    std::size_t real() const;
};

struct ModelSolverOptions {
    std::uint64_t seed = 0;
    unsigned threads = 1;                              ///< the answers are the same
    std::function<void(std::size_t found)> found = {}; ///< told how many are found at first
};

class ModelSolver {
public:
    /// Finds the solutions for random data. Throws ModelError where the text is not well-formed,
    /// and BadInput where equations and unknowns are not equally many, there are no data, or no
    /// solution is found.
    explicit ModelSolver(std::string_view text, const ModelSolverOptions& options = {});
    explicit ModelSolver(const Model& model, const ModelSolverOptions& options = {});
    ~ModelSolver();
    ModelSolver(ModelSolver&&) noexcept;
    ModelSolver& operator=(ModelSolver&&) noexcept;

    const Program& program() const;

    /// How many solutions there are for random data, different in what counts, that were found.
    std::size_t found() const;

    /// How many there are by a fibre (fibre.h), all solutions modulo a prime; 0 if there is none.
    std::size_t degree() const;

    /// The random data that paths start from, and all their solutions that were found, whether what
    /// counts tells them apart or not.
    const std::vector<std::complex<double>>& start_data() const;
    const std::vector<std::vector<std::complex<double>>>& start_solutions() const;

    /// Assumes as many data as the program has. Where solutions come together, are not regular or
    /// go to infinity for these data, they are lost.
    ModelAnswer solve(const std::vector<std::complex<double>>& data) const;

private:
    struct State;
    std::unique_ptr<const State> state_;
};

/// Random real data that have a real solution, the same for the same seed. Throws BadInput if none
/// are found.
std::vector<double> example_data(const Program& program, std::uint64_t seed);

} // namespace plprove::model
