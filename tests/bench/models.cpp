// Speed of the path tracker on a model, beside the engine for three views on the same problem: the
// equations of Chicago (class 2394), as a person writes them. Both have 11 equations in 11
// unknowns; a step evaluates them with their Jacobian twice, and solves two linear systems.
#include "prover/model/solver/start.h"
#include "prover/three_views/camera_loops.h"
#include "tests/bench/evaluations.h"

#include <benchmark/benchmark.h>

namespace {

using namespace plprove;

constexpr const char* chicago_model = R"(model chicago
data x[1..3] : matrix 3 by 3        # the points: image vectors of three views
data l[1..2] : matrix 3 by 3        # the lines through the first two points
unknown q : vector 3, p : vector 3  # the rotations of the second view and of the third
unknown b : vector 2, c : vector 3  # their centres are (1, b) and c
let R = transpose(rotation(q))
let S = transpose(rotation(p))
let B = [1, b[1], b[2]]
for i in 1..3
  let u = x[i][1]
  let v = R*x[i][2]
  let w = S*x[i][3]
  equation dot(B, cross(u, v)) = 0
  equation dot(c, cross(u, w)) = 0
  equation dot(c - B, cross(v, w)) = 0
end
for i in 1..2
  equation dot(l[i][1], cross(R*l[i][2], S*l[i][3])) = 0
end
)";

/// Enough for all lanes.
constexpr std::size_t paths = 64;

/// The model with solutions for random data, and a way to others.
struct ModelPaths {
    model::Program program = model::compile(model::read_model(chicago_model));
    model::TrackedEquations equations{program};
    model::Start start =
        model::find_start(program, equations, {.seed = 0, .threads = 1, .known = paths});
    std::vector<model::TrackedCurve> curves;

    ModelPaths() {
        Random random(1, 1);
        for (const Complex& a : start.data) {
            const Complex b = random.complex() - a;
            curves.push_back({{{a.real(), a.imag()}, {b.real(), b.imag()}, {0, 0}}});
        }
    }
};

const ModelPaths& model_paths() {
    static const ModelPaths value;
    return value;
}

void steps_chicago_model(benchmark::State& state) {
    const ModelPaths& value = model_paths();
    const model::TrackedProgram& program = value.equations.tracked();
    model::Numbers starts;
    for (std::size_t i = 0; i < paths; ++i)
        starts.insert(starts.end(), value.start.solutions[i].begin(),
                      value.start.solutions[i].end());
    model::Numbers ends(starts.size());
    std::vector<TrackOutcome> outcomes(paths);
    std::vector<LaneNumber> workspace(model::workspace_size(program));
    std::uint64_t steps = 0;
    for (auto _ : state)
        steps += model::fastest_tracker()(program, value.curves.data(), {}, paths,
                                          reinterpret_cast<const double*>(starts.data()),
                                          reinterpret_cast<double*>(ends.data()), outcomes.data(),
                                          workspace.data())
                     .steps;
    state.SetItemsProcessed(static_cast<std::int64_t>(steps));
    state.counters["operations"] = program.operations_at_rest;
}

/// The engine's equations of Chicago, with solutions for random images, and a way to others.
struct EnginePaths {
    static constexpr std::size_t chicago = 2394;
    CameraSystem system = camera_system(label_classes()[chicago]);
    Monodromy<CameraLoops> monodromy = camera_monodromy(CameraLoops(system, 0, chicago));
    TrackedSystem tracked = tracked_system(system, monodromy.loops().chart());
    TrackedImages edge;

    EnginePaths() {
        monodromy.reach(static_cast<int>(paths), 6);
        const CameraLoops& loops = monodromy.loops();
        Random random(1, 1);
        edge = moving_images(
            system, loops.constants(), loops.images(),
            rephased(random_neighbour(loops.images(), random), Phases::near_one, random));
    }
};

const EnginePaths& engine_paths() {
    static const EnginePaths value;
    return value;
}

void steps_chicago(benchmark::State& state) {
    const EnginePaths& value = engine_paths();
    std::vector<CameraPoint> ends(paths);
    std::vector<TrackOutcome> outcomes(paths);
    std::uint64_t steps = 0;
    for (auto _ : state)
        steps += fastest_tracker()(value.tracked, value.edge, {}, paths,
                                   value.monodromy.solutions().points().data(), ends.data(),
                                   outcomes.data())
                     .steps;
    state.SetItemsProcessed(static_cast<std::int64_t>(steps));
}

#if defined(__x86_64__)
constexpr int times = 1000;

void evaluations_chicago(benchmark::State& state) {
    if (!__builtin_cpu_supports("avx2")) return state.SkipWithError("no AVX2");
    const EnginePaths& value = engine_paths();
    const CameraPoint& point = value.monodromy.solutions().points().front();
    std::uint64_t evaluations = 0;
    for (auto _ : state)
        evaluations += bench::evaluate_engine(value.tracked, value.edge,
                                              reinterpret_cast<const double*>(point.data()), times);
    state.SetItemsProcessed(static_cast<std::int64_t>(evaluations));
}

void evaluations_chicago_model(benchmark::State& state) {
    if (!__builtin_cpu_supports("avx2")) return state.SkipWithError("no AVX2");
    const ModelPaths& value = model_paths();
    const model::TrackedProgram& program = value.equations.tracked();
    std::vector<LaneNumber> workspace(model::workspace_size(program));
    std::uint64_t evaluations = 0;
    for (auto _ : state)
        evaluations +=
            bench::evaluate_model(program, value.curves.data(),
                                  reinterpret_cast<const double*>(value.start.solutions[0].data()),
                                  workspace.data(), times);
    state.SetItemsProcessed(static_cast<std::int64_t>(evaluations));
}
#endif

} // namespace

BENCHMARK(steps_chicago)->Unit(benchmark::kMillisecond);
BENCHMARK(steps_chicago_model)->Unit(benchmark::kMillisecond);
#if defined(__x86_64__)
BENCHMARK(evaluations_chicago)->Unit(benchmark::kMillisecond);
BENCHMARK(evaluations_chicago_model)->Unit(benchmark::kMillisecond);
#endif
