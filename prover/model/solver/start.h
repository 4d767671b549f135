// Where the paths to all data begin: random complex data, with all solutions that are found.
#pragma once

#include "prover/model/solver/data_loops.h"

#include <functional>

namespace plprove::model {

struct Start {
    Numbers data;
    std::vector<Numbers> solutions;
};

struct StartSettings {
    std::uint64_t seed = 0;
    unsigned threads = 1;
    /// How many solutions there are, 0 if that is not known: then the search ends when several
    /// loops, and several other solutions, lead to no new ones.
    std::size_t known = 0;
    std::function<void(std::size_t found)> found = {}; ///< told how many are found
    Bends bends = Bends::usual;
    int most_solutions = 20'000; ///< the search ends when more are found, for some data
};

/// The relative distance of approximations of one solution.
inline constexpr double near_at_starts = 1e-7;

/// The search for a start. What it found refers to it, and to its arguments.
class StartSearch {
public:
    /// Throws BadInput where not even one solution is found.
    StartSearch(const Program& program, const TrackedEquations& equations, StartSettings settings);
    StartSearch(const StartSearch&) = delete;
    StartSearch& operator=(const StartSearch&) = delete;

    /// Looks for all solutions.
    void run();

    const Numbers& data() const { return first_.data; }
    DataMonodromy& monodromy() { return monodromy_; }

private:
    SolvedData first_solution();
    bool is_complete() const;
    void follow_loops();
    bool add_another();

    const Program& program_;
    const TrackedEquations& equations_;
    StartSettings settings_;
    Random random_;
    SolvedData first_;
    DataMonodromy monodromy_;
};

/// Solutions by monodromy, from random ones. Throws BadInput where not even one is found. The same
/// for the same seed, whatever the number of threads.
Start find_start(const Program& program, const TrackedEquations& equations,
                 const StartSettings& settings);

} // namespace plprove::model
