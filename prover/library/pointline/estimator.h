// Poses of two or three cameras from many matches, some of them wrong.
//
//     pointline::Estimator estimator;
//     auto estimate = estimator.estimate(matches);
//     if (!estimate) return complain(estimate.error());
//
// RANSAC with local optimisation: samples of a minimal problem give cameras, and those that explain
// most matches are refined. No exception leaves the library. An estimator may be called by several
// threads at once.
#pragma once

#include <pointline/solver.h>

#include <cstdint>

namespace pointline {

/// How a lens moves image points, as OpenCV has it (D. C. Brown, 1966): radial k1, k2, k3,
/// tangential p1, p2.
struct Distortion {
    double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0;
};

/// Two points of an image line, in pixels.
struct Segment {
    Point begin{}, end{};
};

/// The point is on the line, in space. Both are indices.
struct Incidence {
    std::size_t point = 0, line = 0;
};

/// What two or three views share. Nothing where a view does not see it, or nobody found it there.
struct Matches {
    std::vector<Intrinsics> cameras;     ///< one for each view
    std::vector<Distortion> distortions; ///< one for each view; empty where there are none
    std::vector<std::vector<std::optional<Point>>> points;  ///< [point][view]
    std::vector<std::vector<std::optional<Segment>>> lines; ///< [line][view]
    std::vector<Incidence> incidences;
};

/// A minimal problem of which matches have samples.
struct Offer {
    std::string problem; ///< in notation
    int degree = 0;
    /// About how many milliseconds of one core a sample takes, and how many pass until one may be
    /// expected to lead to rotations within 5 degrees of the truth: where 30 % of the matches are
    /// wrong, and half a pixel of noise is on images with a focal length of 800 pixels.
    double milliseconds = 0, expected = 0;
};

struct EstimatorOptions {
    /// Notation, a name, or the authors' number; `auto` takes the first of offers().
    std::string problem = "auto";
    double threshold = 2; ///< pixels: a match that is farther off is wrong
    /// That among the samples there is one without wrong matches.
    double confidence = 0.99;
    int least_samples = 8, most_samples = 1000;
    std::uint64_t seed = 0;  ///< the same estimate for the same seed
    unsigned threads = 1;    ///< the estimate does not depend on it
    bool covariance = false; ///< compute it
};

struct Estimate {
    std::vector<Camera> cameras; ///< camera 1 is [I | 0], the distance to camera 2 is 1
    /// In space, of what the cameras explain: the others are wrong, or test no cameras (a point
    /// that one view sees, a line that two views see).
    std::vector<std::optional<std::array<double, 3>>> points;
    std::vector<std::optional<SpaceLine>> lines;
    std::string problem; ///< that was sampled, in notation
    int samples = 0;     ///< how many were drawn
    double rms = 0;      ///< pixels: of the distances of all that is explained
    /// Of the cameras after the first, by rows, six entries each: the rotation vector w of exp(w)
    /// R, in radians, and t. Empty if it was not asked for.
    std::vector<double> covariance;
};

class Estimator {
public:
    Estimator();

    /// The problems, of a list of those that are solved fast, of which the matches have samples,
    /// with views in any order; the one that is expected to take least time first.
    static Result<std::vector<Offer>> offers(const Matches& matches) noexcept;

    /// Fails with no_estimate where no sample leads to cameras that explain more than the sample.
    Result<Estimate> estimate(const Matches& matches,
                              const EstimatorOptions& options = {}) const noexcept;

private:
    struct Content;
    std::shared_ptr<Content> content_; ///< the solvers so far
};

} // namespace pointline
