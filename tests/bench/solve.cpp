// How many solutions are found for how many images, and in which time.
//
// Usage: bench_solve PROBLEM INSTANCES [quick]
//
// Images are of two kinds: of synthetic scenes, which look like photos and have a known answer; and
// random directions, which have none. Prints one line for each kind, and for how long the engine of
// `plprove degree` takes to follow as many paths.
#include "prover/solver/solve.h"
#include "prover/degree/path_follower.h"
#include "prover/problem/spec.h"
#include "prover/solver/synthetic.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <string_view>

using namespace plprove;

namespace {

struct Figures {
    int instances = 0;
    long degree = 0; ///< of all instances together
    long found = 0;
    int whole = 0; ///< instances without a lost solution
    int with_truth = 0;
    std::vector<double> milliseconds;
};

/// The value below which this share of the values is.
double at(std::vector<double> values, double share) {
    std::ranges::sort(values);
    const auto last = static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(share * last)];
}

double distance(const Solution& solution, const SyntheticScene& scene) {
    double largest = 0;
    for (std::size_t v = 0; v < scene.cameras.size(); ++v) {
        const auto R = solution.cameras[v].R.real() - scene.cameras[v].R;
        const auto t = solution.cameras[v].t.real() - scene.cameras[v].t;
        largest = std::max({largest, R.cwiseAbs().maxCoeff(), t.cwiseAbs().maxCoeff()});
    }
    return largest;
}

bool has_truth(const Answer& answer, const SyntheticScene& scene) {
    return std::ranges::any_of(answer.solutions, [&](const Solution& solution) {
        return solution.real && distance(solution, scene) < 1e-8;
    });
}

/// Of this thread: what else the machine does hardly matters.
double processor_milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Runs and times `solve`, and adds what it found.
Answer timed(Figures& figures, const std::function<Answer()>& solve) {
    const double begin = processor_milliseconds();
    Answer answer = solve();
    const double end = processor_milliseconds();
    ++figures.instances;
    figures.degree += answer.degree;
    figures.found += answer.found;
    figures.whole += answer.lost == 0;
    figures.milliseconds.push_back(end - begin);
    return answer;
}

Figures of_scenes(const Solver& solver, int instances, const SolveOptions& options) {
    Figures figures;
    for (int i = 0; i < instances; ++i) {
        const SyntheticScene scene =
            synthetic_scene(solver.plan().problem, static_cast<std::uint64_t>(i));
        const Answer answer = timed(figures, [&] { return solver.solve(scene.images, options); });
        figures.with_truth += has_truth(answer, scene);
    }
    return figures;
}

/// Image vectors of the class in random directions. In three views.
Figures of_random_images(const Solver& solver, int instances, const SolveOptions& options) {
    Figures figures;
    Random random(1, 0);
    const SyntheticScene any = synthetic_scene(solver.plan().problem, 0);
    for (int i = 0; i < instances; ++i) {
        std::vector<Eigen::Vector3d> images;
        for (std::size_t k = 0; k < solver.system().free.size(); ++k) {
            const double x = random.real(), y = random.real(), z = random.real();
            images.push_back(Eigen::Vector3d(x, y, z).normalized());
        }
        timed(figures, [&] { return solver.solve(any.images, images, options); });
    }
    return figures;
}

/// The median time in which the engine of `plprove degree` follows as many paths, between random
/// complex images.
double median_of_engine(const Solver& solver, int instances) {
    const Start& start = solver.start();
    const TrackedSystem tracked = tracked_system(solver.system(), start.chart);
    Random random(2, 0);
    std::vector<double> milliseconds;
    for (int i = 0; i < instances; ++i) {
        Images to;
        for (std::size_t k = 0; k < start.images.size(); ++k)
            to.push_back(unit(random.complex3()));
        const auto moving = moving_images(solver.system(), start.constants, start.images, to);
        PathFollower follower(tracked);
        const double begin = processor_milliseconds();
        follower.follow_quickly(moving, start.solutions);
        milliseconds.push_back(processor_milliseconds() - begin);
    }
    return at(milliseconds, 0.5);
}

void print(const char* kind, const Figures& figures, bool truth) {
    std::printf("%-14s %d instances: %.4f %% of the solutions found, all in %d", kind,
                figures.instances,
                100.0 * static_cast<double>(figures.found) / static_cast<double>(figures.degree),
                figures.whole);
    if (truth) std::printf("; the true cameras in %d", figures.with_truth);
    std::printf("; median %.3g ms of processor time, 9 of 10 below %.3g ms\n",
                at(figures.milliseconds, 0.5), at(figures.milliseconds, 0.9));
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fputs("usage: bench_solve PROBLEM INSTANCES [quick]\n", stderr);
        return 3;
    }
    const Solver solver = make_solver(parse_spec(argv[1]));
    const int instances = std::max(1, std::atoi(argv[2]));
    const bool quick = argc > 3 && std::string_view(argv[3]) == "quick";
    const SolveOptions options{quick ? Effort::once : Effort::thorough, false, false};
    print("scenes", of_scenes(solver, instances, options), true);
    if (solver.plan().number) {
        const Figures random = of_random_images(solver, instances, options);
        print("random images", random, false);
        const double engine = median_of_engine(solver, instances);
        std::printf("%-14s %.3g ms for as many paths: random images take %.2f times as long\n",
                    "engine", engine, at(random.milliseconds, 0.5) / engine);
    }
    return 0;
}
