// libpointline: the cameras of minimal problems of points and lines, from images.
//
//     auto solver = pointline::Solver::make("2*Pa/Pa/Pa + P/P/P");
//     if (!solver) return complain(solver.error());
//     auto answer = solver->solve(images);
//
// A solver is made once for a problem, and solves it for any number of images. All functions may be
// called by several threads at once; there is no global state. No exception leaves the library:
// what can fail returns a Result.
#pragma once

#include <pointline/result.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pointline {

/// From normalised coordinates to pixels: (fx x + cx, fy y + cy).
struct Intrinsics {
    double fx = 1, fy = 1, cx = 0, cy = 0;
};

using Point = std::array<double, 2>; ///< an image point, in pixels

/// An image line a x + b y + c = 0, in pixels.
struct Line {
    std::array<double, 3> coefficients{};
    /// The two points that it was given by, if it was: they say how it may be moved to meet a
    /// point.
    std::vector<Point> points;
};

Line line_through(const Point& p, const Point& q);

/// What a view sees of a feature: empty if nothing.
struct Sighting {
    std::optional<Point> point;
    std::map<char, Line> lines; ///< by the letters of the notation
};

struct Images {
    std::vector<Intrinsics> cameras; ///< one for each view; empty where coordinates are normalised
    /// [feature][view], features in the order of the notation, multiplicities written out.
    std::vector<std::vector<Sighting>> features;
};

/// It takes the point X of space to R X + t; R by rows. Camera 1 is [I | 0], the distance from
/// camera 1 to camera 2 is 1, with the sign that puts more points in front. Uncalibrated cameras
/// take X to the pixel R X + t, up to a factor: R is any matrix, and nothing is in front.
struct Camera {
    std::array<double, 9> R{};
    std::array<double, 3> t{};
};

struct SpaceLine {
    std::array<double, 3> point{};
    std::array<double, 3> direction{}; ///< of length 1
};

/// A real solution. What the images leave open in space is missing.
struct Solution {
    std::vector<Camera> cameras;
    std::vector<std::optional<std::array<double, 3>>> points;    ///< one for each feature
    std::vector<std::map<char, std::optional<SpaceLine>>> lines; ///< of each feature
    int in_front = 0;    ///< how many points are in front of all cameras that see them
    double residual = 0; ///< the largest distance of an image from what is seen, in pixels
    /// How much the cameras change at most, relative to a small change of the images; 0 if it was
    /// not asked for.
    double condition = 0;
};

enum class Complete { certified, unknown, evidence };

struct Answer {
    int degree = 0; ///< how many complex solutions generic images have, as far as is known
    int found = 0;  ///< how many were found
    /// Why these are all: their number is the degree, which is certified, or known by evidence.
    Complete complete = Complete::unknown;
    double moved = 0; ///< pixels that a point or line was moved at most to make lines meet points
    std::vector<Solution> solutions; ///< the real ones, those with most points in front first
};

/// `quick` and `conditions` are for two or three calibrated views and lines with at most one point.
struct Options {
    /// Follow each path once, and let those that are lost go: faster, and hardly a real solution
    /// is lost.
    bool quick = false;
    bool conditions = false; ///< estimate conditions
    /// How many threads share the work for one answer, which does not depend on it.
    unsigned threads = 1;
};

class Solver {
public:
    /// The solver of a problem (notation, a name, or the authors' number) with the start from the
    /// cache; in three views the start is made if it is not there, which may take long. No start is
    /// kept of problems with lines through several points, more than three views or uncalibrated
    /// cameras: it is made each time, seconds for 1,000 solutions.
    static Result<Solver> make(std::string_view problem) noexcept;
    /// The same with the start in a file that `plprove start` wrote.
    static Result<Solver> load(std::string_view problem, const std::string& start) noexcept;

    Result<Answer> solve(const Images& images, const Options& options = {}) const noexcept;
    /// The answers to many images, in their order, by this number of threads, or fewer if the
    /// system does not give them: this is faster than to share each answer. Empty if there is no
    /// memory for it.
    std::vector<Result<Answer>> solve(std::span<const Images> images, const Options& options,
                                      unsigned threads) const noexcept;

    /// The problem in notation.
    const std::string& problem() const;
    /// How many complex solutions the start has; 20 in two views.
    int degree() const;

private:
    struct Content;
    explicit Solver(std::shared_ptr<const Content> content);
    std::shared_ptr<const Content> content_;
};

} // namespace pointline
