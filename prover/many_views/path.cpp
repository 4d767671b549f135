#include "prover/many_views/path.h"

#include "prover/many_views/way.h"

#include <atomic>
#include <thread>

namespace plprove::many_views {

namespace {

TrackSettings settings_for(Care care) {
    TrackSettings settings = usual_settings;
    if (care == Care::usual) return settings;
    settings.prediction = 1e-6;
    settings.contraction = 0.005;
    settings.largest_step = 0.05;
    settings.most_steps = 20000;
    if (care == Care::careful) return settings;
    settings.noise = 1e-16;
    settings.smallest_step = 1e-13;
    return settings;
}

/// Some paths in a row; the lanes of the tracker take them as they get free.
struct Batch {
    std::size_t first = 0, size = 0;
};

constexpr std::size_t batch_size = 64;

class Follower {
public:
    Follower(const System& system, const Images<Complex>& from, const Images<Complex>& to,
             Care care)
        : unknowns_(system.unknowns()), way_(system, from, to), settings_(settings_for(care)),
          track_(care == Care::precise ? fastest_double_double_tracker() : fastest_tracker()) {}

    /// Sets the ends of a batch.
    void run(const Batch& batch, const std::vector<Point>& starts,
             std::vector<std::optional<Point>>& ends) const {
        const auto numbers = batch.size * static_cast<std::size_t>(unknowns_);
        std::vector<Complex> from(numbers), to(numbers);
        for (std::size_t i = 0; i < batch.size; ++i)
            point(from, i) = starts[batch.first + i];
        std::vector<TrackOutcome> outcomes(batch.size);
        std::vector<LaneNumber> workspace(workspace_size(way_.tracked()));
        track_(way_.tracked(), settings_, batch.size, reinterpret_cast<const double*>(from.data()),
               reinterpret_cast<double*>(to.data()), outcomes.data(), workspace.data());
        for (std::size_t i = 0; i < batch.size; ++i)
            if (outcomes[i] == TrackOutcome::arrived) ends[batch.first + i] = point(to, i);
    }

private:
    Eigen::Map<Point> point(std::vector<Complex>& numbers, std::size_t i) const {
        return {numbers.data() + i * static_cast<std::size_t>(unknowns_), unknowns_};
    }

    Eigen::Index unknowns_;
    Way way_;
    TrackSettings settings_;
    TrackFunction* track_;
};

} // namespace

std::vector<std::optional<Point>> follow_all(const System& system, const Images<Complex>& from,
                                             const Images<Complex>& to,
                                             const std::vector<Point>& starts, Care care,
                                             int threads) {
    const Follower follower(system, from, to, care);
    std::vector<std::optional<Point>> ends(starts.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t first = next++ * batch_size; first < starts.size();
             first = next++ * batch_size)
            follower.run({first, std::min(batch_size, starts.size() - first)}, starts, ends);
    };
    std::vector<std::jthread> helpers;
    for (int thread = 1; thread < threads; ++thread)
        helpers.emplace_back(work);
    work();
    helpers.clear();
    return ends;
}

std::optional<Point> follow(const System& system, const Images<Complex>& from,
                            const Images<Complex>& to, const Point& start, Care care) {
    return follow_all(system, from, to, {start}, care, 1).front();
}

} // namespace plprove::many_views
