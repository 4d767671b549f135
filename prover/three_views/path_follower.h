// Following solutions while the images move: in doubles first, and what is lost with more digits or
// on a detour.
#pragma once

#include "prover/monodromy/path_ends.h"
#include "prover/three_views/tracking/tracker.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace plprove {

struct PathCounts {
    std::uint64_t tracks = 0; ///< to an end, or lost for good
    std::uint64_t retried = 0;
    std::uint64_t steps = 0;
};

/// Follows paths. The ends that it returns are empty where a path was lost.
class PathFollower {
public:
    using Ends = PathEnds<CameraPoint>;

    explicit PathFollower(const TrackedSystem& system) : system_(system) {}

    /// A detour, in two legs, and what makes another one in case it loses a path, too.
    struct Detours {
        std::array<TrackedImages, 2> first;
        std::function<std::array<TrackedImages, 2>()> another;
    };

    /// Loses about one of a hundred, which is not counted.
    Ends follow_quickly(const TrackedImages& images, const std::vector<CameraPoint>& starts);
    /// With tighter settings and twice the digits.
    Ends follow_double_double(const TrackedImages& images, const std::vector<CameraPoint>& starts);
    /// With three times the digits, what was lost with twice the digits.
    Ends follow_triple_double(const TrackedImages& images, const std::vector<CameraPoint>& starts);
    /// With twice the digits, what was lost on the straight way.
    Ends follow_detours(const Detours& detours, const std::vector<CameraPoint>& starts);
    const PathCounts& counts() const { return counts_; }

private:
    Ends follow_legs(const std::array<TrackedImages, 2>& legs,
                     const std::vector<CameraPoint>& starts);
    Ends attempt(TrackFunction* track, const TrackedImages& images, const TrackSettings& settings,
                 const std::vector<CameraPoint>& starts);
    static std::uint64_t arrived(const Ends& ends);
    TrackedSystem system_;
    PathCounts counts_;
};

/// Newton's method from each start, for images at rest: tracking is no more there. Corrections
/// below `noise`, relative to the point, are rounding. No end where it does not converge at once.
PathFollower::Ends newton(TrackFunction* track, double noise, const TrackedSystem& system,
                          const TrackedImages& images, const std::vector<CameraPoint>& starts);

/// The same in doubles. No end where rounding leaves corrections above `accuracy`, either.
PathFollower::Ends accurate_newton(double accuracy, const TrackedSystem& system,
                                   const TrackedImages& images,
                                   const std::vector<CameraPoint>& starts);

} // namespace plprove
