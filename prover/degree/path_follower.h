// Following solutions while the images move: in doubles first, and what is lost with more digits or
// on a detour.
#pragma once

#include "prover/degree/tracking/tracker.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace plprove {

struct PathCounts {
    std::uint64_t tracks = 0; ///< to an end, or lost for good
    std::uint64_t retried = 0;
    std::uint64_t failed = 0;
    std::uint64_t steps = 0;
};

/// Follows paths. The ends that it returns are empty where a path was lost.
class PathFollower {
public:
    using Ends = std::vector<std::optional<CameraPoint>>;

    explicit PathFollower(const TrackedSystem& system) : system_(system) {}

    /// A detour, in two legs, and what makes another one in case it loses a path, too.
    struct Detours {
        std::array<TrackedImages, 2> first;
        std::function<std::array<TrackedImages, 2>()> another;
    };

    /// In doubles; then, with twice as many digits, those that are lost; then on detours those that
    /// are lost again.
    Ends follow(const TrackedImages& images, const Detours& detours,
                const std::vector<CameraPoint>& starts);
    /// Loses about one of a hundred, which is not counted.
    Ends follow_quickly(const TrackedImages& images, const std::vector<CameraPoint>& starts);
    /// With tighter settings and twice as many digits; what is lost then counts as lost for good.
    Ends follow_double_double(const TrackedImages& images, const std::vector<CameraPoint>& starts);
    /// With three times as many digits, what was lost with twice as many: what arrives was not lost
    /// for good.
    Ends follow_triple_double(const TrackedImages& images, const std::vector<CameraPoint>& starts);
    /// With twice as many digits, what was lost on the straight way: what arrives was not lost for
    /// good.
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

/// The starts of the paths that have no end, and their indices.
std::pair<std::vector<CameraPoint>, std::vector<std::size_t>>
without_end(const std::vector<CameraPoint>& starts, const PathFollower::Ends& ends);

/// Follows the paths that have no end once more, by a function from starts to ends.
template <class Follow>
void fill(PathFollower::Ends& ends, const std::vector<CameraPoint>& starts, Follow follow_again) {
    const auto [open, indices] = without_end(starts, ends);
    const PathFollower::Ends again = follow_again(open);
    for (std::size_t k = 0; k < indices.size(); ++k)
        ends[indices[k]] = again[k];
}

/// Follows the paths that have an end further, by a function from starts to ends.
template <class Follow>
PathFollower::Ends follow_on(const PathFollower::Ends& ends, Follow follow_further) {
    std::vector<CameraPoint> starts;
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (ends[i]) {
            starts.push_back(*ends[i]);
            indices.push_back(i);
        }
    const PathFollower::Ends further = follow_further(starts);
    PathFollower::Ends result(ends.size());
    for (std::size_t k = 0; k < indices.size(); ++k)
        result[indices[k]] = further[k];
    return result;
}

} // namespace plprove
