// From images to cameras for problems in general: any number of views that see everything, lines
// with several points, calibrated or projective cameras.
#pragma once

#include "prover/many_views/degrees_on_file.h"
#include "prover/many_views/system.h"
#include "prover/solver/images.h"
#include "prover/solver/solve.h"

#include <functional>

namespace plprove {

/// How many solutions a problem has that a GeneralSolver can solve. Throws BadInput, which says
/// why, for others.
int degree_to_solve(const Problem& problem);

/// Solves one problem for any number of images: from random images with all their solutions, it
/// follows these. Its functions may be called by several threads at once.
class GeneralSolver {
public:
    struct Options {
        int threads = 1;
        std::uint64_t seed = 0;
        std::function<void(int)> found{}; ///< is told how many solutions of random images are found
    };

    /// Finds the solutions of random images. Throws BadInput as degree_to_solve() does.
    GeneralSolver(const Problem& problem, const Options& options);

    const Problem& problem() const { return from_.system.problem(); }
    int degree() const { return known_.degree; }

    /// The solutions for images in the coordinates of the calibration; with `complex` also those
    /// that are not real. The cameras of a projective problem are a matrix R and a vector t that
    /// take a point X of space to the pixel R X + t, up to a factor; camera 1 is [I | 0]. Nothing
    /// is in front of such a camera. The same with any number of threads.
    Answer solve(const SeenImages& images, bool complex, int threads) const;

private:
    /// Random images with all their solutions.
    struct RandomImages {
        many_views::System system;
        many_views::Images<many_views::Complex> images;
        std::vector<many_views::Point> solutions;
    };
    static RandomImages solved_images(const Problem& problem, int degree, const Options& options);

    /// The solutions of these images in the standard chart, each once.
    std::vector<many_views::Point> follow_to(const many_views::Images<many_views::Complex>& images,
                                             const many_views::System& standard, int threads) const;

    many_views::DegreeOnFile known_;
    std::uint64_t seed_;
    RandomImages from_;
};

} // namespace plprove
