#include "prover/three_views/path_follower.h"

#include <algorithm>

namespace plprove {

namespace {

TrackSettings newton_settings(double noise) {
    TrackSettings settings;
    settings.prediction = 2e-3;
    settings.noise = noise;
    settings.largest_step = settings.first_step = 1;
    return settings;
}

PathFollower::Ends ends_of(TrackFunction* track, const TrackSettings& settings,
                           const TrackedSystem& system, const TrackedImages& images,
                           const std::vector<CameraPoint>& starts, PathCounts& counts) {
    std::vector<CameraPoint> to(starts.size());
    std::vector<TrackOutcome> outcomes(starts.size());
    counts.steps +=
        track(system, images, settings, starts.size(), starts.data(), to.data(), outcomes.data())
            .steps;
    PathFollower::Ends ends(starts.size());
    for (std::size_t i = 0; i < starts.size(); ++i)
        if (outcomes[i] == TrackOutcome::arrived) ends[i] = to[i];
    return ends;
}

} // namespace

PathFollower::Ends newton(TrackFunction* track, double noise, const TrackedSystem& system,
                          const TrackedImages& images, const std::vector<CameraPoint>& starts) {
    PathCounts uncounted;
    return ends_of(track, newton_settings(noise), system, images, starts, uncounted);
}

PathFollower::Ends accurate_newton(double accuracy, const TrackedSystem& system,
                                   const TrackedImages& images,
                                   const std::vector<CameraPoint>& starts) {
    TrackSettings settings = newton_settings(accuracy);
    settings.contraction = 0;     // only small corrections will do
    settings.smallest_step = 0.5; // a second attempt would be no better
    PathCounts uncounted;
    return ends_of(fastest_tracker(), settings, system, images, starts, uncounted);
}

PathFollower::Ends PathFollower::follow_quickly(const TrackedImages& images,
                                                const std::vector<CameraPoint>& starts) {
    Ends ends = attempt(fastest_tracker(), images, {}, starts);
    counts_.tracks += arrived(ends);
    return ends;
}

namespace {

/// What doubles lose they nearly always lose to rounding, where both rotations are nearly
/// isotropic.
TrackSettings tight_settings() {
    TrackSettings settings;
    settings.prediction = 1e-4; // near clusters of degenerate solutions longer steps go astray
    settings.contraction = 0.02;
    settings.noise = 1e-16;
    settings.smallest_step = 1e-13;
    settings.most_steps = 2000;
    return settings;
}

} // namespace

PathFollower::Ends PathFollower::follow_double_double(const TrackedImages& images,
                                                      const std::vector<CameraPoint>& starts) {
    counts_.tracks += starts.size();
    counts_.retried += starts.size();
    return attempt(fastest_double_double_tracker(), images, tight_settings(), starts);
}

PathFollower::Ends PathFollower::follow_triple_double(const TrackedImages& images,
                                                      const std::vector<CameraPoint>& starts) {
    TrackSettings settings = tight_settings();
    // Newton's method may converge only from 1e-18 or nearer here, and the largest rounding errors
    // seen are 1e-26.
    settings.noise = 1e-22;
    settings.smallest_step = 1e-18;
    settings.most_steps = 6000;
    return attempt(fastest_triple_double_tracker(), images, settings, starts);
}

PathFollower::Ends PathFollower::follow_detours(const Detours& detours,
                                                const std::vector<CameraPoint>& starts) {
    constexpr int most = 3;
    Ends ends(starts.size());
    for (int i = 0; i < most && arrived(ends) < ends.size(); ++i) {
        const auto legs = i == 0 ? detours.first : detours.another();
        fill(ends, starts, [&](const auto& open) { return follow_legs(legs, open); });
    }
    return ends;
}

PathFollower::Ends PathFollower::follow_legs(const std::array<TrackedImages, 2>& legs,
                                             const std::vector<CameraPoint>& starts) {
    const auto along = [&](const TrackedImages& leg, const std::vector<CameraPoint>& from) {
        return attempt(fastest_double_double_tracker(), leg, tight_settings(), from);
    };
    return follow_on(along(legs[0], starts),
                     [&](const auto& from) { return along(legs[1], from); });
}

PathFollower::Ends PathFollower::attempt(TrackFunction* track, const TrackedImages& images,
                                         const TrackSettings& settings,
                                         const std::vector<CameraPoint>& starts) {
    return ends_of(track, settings, system_, images, starts, counts_);
}

std::uint64_t PathFollower::arrived(const Ends& ends) {
    return static_cast<std::uint64_t>(
        std::ranges::count_if(ends, [](const auto& end) { return end.has_value(); }));
}

} // namespace plprove
