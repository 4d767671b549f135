// Certificates that a problem in general has at least so many solutions (certs/FORMAT.md, section
// 14): the solutions that monodromy has found, carried over to integer images.
#pragma once

#include "prover/multiview/monodromy.h"

#include <span>
#include <string>

namespace plprove::multiview {

/// Starting values of a solution, times 2^bits: of each coordinate the real part, and unless it is
/// real the imaginary part. The cameras come first.
struct StartingValues {
    bool real = true;
    int bits = 0;
    std::vector<std::int64_t> values;
};

/// What a record of the file says.
struct SolutionsRecord {
    general::Problem problem;
    std::vector<std::vector<int>> views; ///< what each sees
    std::vector<StartingValues> solutions;

    /// How many solutions these are: one that is not real stands for its conjugate, too.
    int count() const;
};

/// Follows the solutions to random integer images, on other paths again if some get lost. The
/// record has all that arrive, each real one and each pair once. The same result for the same seed,
/// whatever the number of threads.
SolutionsRecord certify(const MonodromyResult& found, std::uint64_t seed, int threads);

/// The file of these records. Throws FormatLimit if the format does not allow it.
std::string write_solutions(std::span<const SolutionsRecord> records);

} // namespace plprove::multiview
