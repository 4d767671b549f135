// From images to cameras for problems in general: any number of views that see everything, lines
// with several points, calibrated or projective cameras.
#pragma once

#include "prover/solver/images.h"
#include "prover/solver/solve.h"

#include <functional>

namespace plprove {

struct GeneralOptions {
    bool complex = true; ///< also solutions that are not real
    int threads = 1;
    std::uint64_t seed = 0;
    std::function<void(int)> found{}; ///< is told how many solutions of random images are found
};

/// How many solutions a problem has that solve_in_general() can solve. Throws BadInput, which says
/// why, for others.
int degree_to_solve(const Problem& problem);

/// Finds all solutions of random images, and follows them to these, in the coordinates of the
/// calibration. The cameras of a projective problem are a matrix R and a vector t that take a point
/// X of space to the pixel R X + t, up to a factor; camera 1 is [I | 0]. Nothing is in front of
/// such a camera. Throws BadInput as degree_to_solve() does.
Answer solve_in_general(const Problem& problem, const SeenImages& images,
                        const GeneralOptions& options);

} // namespace plprove
