// Speed of the degree engine: paths of the Chicago problem (class 2394) with the widest lanes of
// this machine, with one lane, with two and three times as many digits, and by the engine for any
// number of views, which knows nothing of three views; and proving solutions in the checker.
#include "checker/replay.h"
#include "prover/many_views/monodromy.h"
#include "prover/many_views/path.h"
#include "prover/problem/notation.h"
#include "prover/three_views/camera_loops.h"
#include "prover/three_views/degree.h"
#include "prover/three_views/degree_text.h"

#include <algorithm>
#include <benchmark/benchmark.h>

namespace {

using namespace plprove;

constexpr std::size_t chicago = 2394;

/// Images of the Chicago problem with all solutions, and an edge that leads elsewhere.
struct Paths {
    CameraSystem system = camera_system(label_classes()[chicago]);
    Monodromy<CameraLoops> monodromy = camera_monodromy(CameraLoops(system, 0, chicago));
    TrackedSystem tracked;
    TrackedImages edge;

    Paths() {
        monodromy.reach(312, 6);
        Random random(1, 1);
        const CameraLoops& loops = monodromy.loops();
        tracked = tracked_system(system, loops.chart());
        edge = moving_images(
            system, loops.constants(), loops.images(),
            rephased(random_neighbour(loops.images(), random), Phases::near_one, random));
    }
};

const Paths& paths() {
    static const Paths value;
    return value;
}

void follow(benchmark::State& state, TrackFunction* track) {
    const std::vector<CameraPoint>& starts = paths().monodromy.solutions().points();
    std::vector<CameraPoint> ends(starts.size());
    std::vector<TrackOutcome> outcomes(starts.size());
    std::uint64_t steps = 0;
    for (auto _ : state)
        steps += track(paths().tracked, paths().edge, {}, starts.size(), starts.data(), ends.data(),
                       outcomes.data())
                     .steps;
    const auto count = static_cast<std::int64_t>(starts.size());
    state.SetItemsProcessed(state.iterations() * count);
    state.counters["steps_a_track"] =
        static_cast<double>(steps) / static_cast<double>(state.iterations() * count);
    state.counters["lost"] = static_cast<double>(
        std::count_if(outcomes.begin(), outcomes.end(),
                      [](TrackOutcome outcome) { return outcome != TrackOutcome::arrived; }));
}

void track_chicago(benchmark::State& state) {
    follow(state, fastest_tracker());
}
void track_chicago_one_lane(benchmark::State& state) {
    follow(state, portable::track);
}
void track_chicago_wide(benchmark::State& state) {
    follow(state, fastest_double_double_tracker());
}
void track_chicago_triple(benchmark::State& state) {
    follow(state, fastest_triple_double_tracker());
}

void track_chicago_any_views(benchmark::State& state) {
    const Problem problem = parse_problem("2*Pa/Pa/Pa + P/P/P");
    const many_views::MonodromyResult found = many_views::run_monodromy(problem, 0, {});
    Random random(1, 1);
    const auto to = many_views::random_images(problem, random);
    std::ptrdiff_t lost = 0;
    const auto lost_of = [](const auto& ends) {
        return std::ranges::count_if(ends, [](const auto& end) { return !end; });
    };
    for (auto _ : state)
        lost = lost_of(many_views::follow_all(found.system, found.images, to, found.points,
                                              many_views::Care::usual, 1));
    state.SetItemsProcessed(state.iterations() * std::ssize(found.points));
    state.counters["lost"] = static_cast<double>(lost);
}

void check_solutions(benchmark::State& state) {
    const DegreeRun run = compute_degree(chicago, {.at_least = 312});
    const std::string bytes = write_degree_file(std::span(&*run.certificate, 1));
    const checker::Classification classes = checker::classify();
    for (auto _ : state)
        benchmark::DoNotOptimize(checker::replay(classes, "degrees", bytes));
    state.SetItemsProcessed(state.iterations() * run.certificate->degree());
}

} // namespace

BENCHMARK(track_chicago)->Unit(benchmark::kMillisecond);
BENCHMARK(track_chicago_one_lane)->Unit(benchmark::kMillisecond);
BENCHMARK(track_chicago_wide)->Unit(benchmark::kMillisecond);
BENCHMARK(track_chicago_triple)->Unit(benchmark::kMillisecond);
BENCHMARK(track_chicago_any_views)->Unit(benchmark::kMillisecond);
BENCHMARK(check_solutions)->Unit(benchmark::kMillisecond);
