// The zeros of the camera equations at images at rest, as a search finds them.
#pragma once

#include "prover/monodromy/path_ends.h"
#include "prover/monodromy/solution_set.h"
#include "prover/system/in_parts.h"
#include "prover/three_views/images.h"

#include <algorithm>

namespace plprove {

/// The equations of a problem in a chart, with the constants of its auxiliary lines and points.
struct ChartedEquations {
    CameraSystem system;
    CameraChart chart;
    std::vector<Complex3> constants;
    TrackedSystem tracked;

    ChartedEquations(CameraSystem equations, const CameraChart& in, std::vector<Complex3> auxiliary)
        : system(std::move(equations)), chart(in), constants(std::move(auxiliary)),
          tracked(tracked_system(system, chart)) {}
};

class ZerosAtRest {
public:
    using Ends = PathEnds<CameraPoint>;

    /// Of real images that have at most `most` zeros. `equations` must outlive this. The work is
    /// shared by `threads` threads; what is found does not depend on it.
    ZerosAtRest(const ChartedEquations& equations, const Images& images, int most,
                unsigned threads);

    /// To 13 digits; each once.
    const SolutionSet<CameraPoint>& found() const { return found_; }
    bool is_complete() const { return found_.size() >= most_; }

    /// Adds the zeros to which these ends lead by Newton's method. Two paths rarely have the same
    /// end, if one has jumped: none of the two is returned.
    Ends add(Ends ends);

    /// Adds the zeros that these cameras approximate.
    void add(const std::vector<QuaternionCameras>& approximations);

private:
    void add(const CameraPoint& zero);
    void add_conjugates();
    Ends polished(const Ends& ends) const;
    Ends accurate(const std::vector<CameraPoint>& zeros) const;
    Ends settled(std::vector<CameraPoint> open) const;
    Ends in_double_doubles(const std::vector<CameraPoint>& zeros) const;

    const ChartedEquations& equations_;
    unsigned threads_;
    int most_;
    std::vector<Complex3> vectors_;
    TrackedImages at_rest_;
    SolutionSet<CameraPoint> found_;
    std::size_t conjugated_ = 0; ///< the first zeros, whose conjugates are added
};

/// The ends from all points, by `threads` threads. `work` takes points to ends, each by itself.
template <class Work>
PathEnds<CameraPoint> in_threads(const std::vector<CameraPoint>& points, unsigned threads,
                                 const Work& work) {
    PathEnds<CameraPoint> ends(points.size());
    in_parts(points.size(), threads, [&](std::size_t begin, std::size_t end) {
        const std::vector<CameraPoint> part(points.data() + begin, points.data() + end);
        const PathEnds<CameraPoint> found = work(part);
        std::ranges::copy(found, ends.begin() + static_cast<std::ptrdiff_t>(begin));
    });
    return ends;
}

} // namespace plprove
