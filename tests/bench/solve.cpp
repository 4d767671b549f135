// How many solutions are found for how many images, and in which time.
//
// Usage: bench_solve PROBLEM INSTANCES [quick] [paths] [threads=N] [noise]
//        bench_solve PROBLEM INSTANCES samples [paths=N] [noise]
//
// `paths` follows paths where there is a template. `noise` moves what the images of synthetic
// scenes show by half a pixel, and says how far the best solution is from the truth. `samples`
// solves as estimators do, with so many paths a sample; with `noise`, a sample is good if it has
// cameras whose rotations are within 5 degrees of the truth.
//
// Images are of two kinds: of synthetic scenes, which look like photos and have a known answer; and
// random directions, which have none. Prints one line for each kind, and how long the engine of
// `plprove degree` takes for the same number of paths, and how many it loses.
#include "prover/solver/solve.h"
#include "prover/problem/spec.h"
#include "prover/solver/sample_solver.h"
#include "prover/solver/synthetic.h"
#include "prover/three_views/path_follower.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <random>
#include <string_view>

using namespace plprove;

namespace {

struct Figures {
    int instances = 0;
    long degree = 0; ///< of all instances together
    long found = 0;
    int whole = 0; ///< instances without a lost solution
    int with_truth = 0;
    std::vector<double> milliseconds; ///< of processor time
    std::vector<double> wall;         ///< until the answer is there
};

/// The value below which this share of the values is.
double at(std::vector<double> values, double share) {
    std::ranges::sort(values);
    const auto last = static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(share * last)];
}

template <class Scalar>
double distance(const std::vector<Pose<Scalar>>& cameras, const SyntheticScene& scene) {
    double largest = 0;
    for (std::size_t v = 0; v < scene.cameras.size(); ++v) {
        const auto R = cameras[v].R.real() - scene.cameras[v].R;
        const auto t = cameras[v].t.real() - scene.cameras[v].t;
        largest = std::max({largest, R.cwiseAbs().maxCoeff(), t.cwiseAbs().maxCoeff()});
    }
    return largest;
}

bool has_truth(const Answer& answer, const SyntheticScene& scene) {
    return std::ranges::any_of(answer.solutions, [&](const Solution& solution) {
        return solution.real && distance(solution.cameras, scene) < 1e-8;
    });
}

/// Of this thread: what else the machine does hardly matters. With several threads, that of the one
/// that waits for the others.
double processor_milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Runs and times `solve`, and adds what it found.
Answer timed(Figures& figures, const std::function<Answer()>& solve) {
    const double begin = processor_milliseconds();
    const auto wall_begin = std::chrono::steady_clock::now();
    Answer answer = solve();
    const std::chrono::duration<double, std::milli> wall =
        std::chrono::steady_clock::now() - wall_begin;
    const double end = processor_milliseconds();
    ++figures.instances;
    figures.degree += answer.degree;
    figures.found += answer.found;
    figures.whole += answer.lost == 0;
    figures.milliseconds.push_back(end - begin);
    figures.wall.push_back(wall.count());
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

/// Normal deviates with half a pixel of standard deviation, in normalised coordinates.
class HalfPixels {
public:
    explicit HalfPixels(std::uint64_t seed) : random_(seed) {}

    Eigen::Vector3d moved(const Eigen::Vector3d& x) {
        constexpr double sigma = 0.5 / 800; // the focal length of synthetic scenes
        std::normal_distribution<double> normal(0, sigma);
        return x / x.z() + Eigen::Vector3d(normal(random_), normal(random_), 0);
    }

private:
    std::mt19937_64 random_;
};

/// A line is drawn through two points, 100 pixels apart: the seen point of its feature, or else the
/// point next to the centre, and another one. Each of them moves.
void move(Sighting& sighting, HalfPixels& noise) {
    constexpr double length = 100.0 / 800;
    const std::optional<Eigen::Vector3d> before = sighting.point;
    if (before) sighting.point = noise.moved(*before);
    for (std::optional<Eigen::Vector3d>& line : sighting.lines) {
        if (!line) continue;
        const Eigen::Vector2d normal = line->head<2>();
        const Eigen::Vector2d along = Eigen::Vector2d(-normal.y(), normal.x()).normalized();
        Eigen::Vector2d begin = -normal * line->z() / normal.squaredNorm();
        if (before) begin = before->hnormalized();
        const Eigen::Vector2d end = begin + length * along;
        const Eigen::Vector3d first = before ? *sighting.point : noise.moved(begin.homogeneous());
        line = first.cross(noise.moved(end.homogeneous()));
    }
}

/// Moves all that the views see.
void move(SyntheticScene& scene, std::uint64_t seed) {
    HalfPixels noise(seed);
    for (FeatureSightings& views : scene.images.observation)
        for (Sighting& sighting : views)
            move(sighting, noise);
}

/// The largest angle between a rotation and the true one, in degrees.
template <class Scalar>
double rotation_error(const std::vector<Pose<Scalar>>& cameras, const SyntheticScene& scene) {
    double largest = 0;
    for (std::size_t v = 0; v < scene.cameras.size(); ++v) {
        const Eigen::Matrix3d R = cameras[v].R.real();
        largest = std::max(largest, Eigen::AngleAxisd(R * scene.cameras[v].R.transpose()).angle());
    }
    return largest * 180 / static_cast<double>(EIGEN_PI);
}

/// Prints the error of the best of all real solutions, if half a pixel of noise is on the images.
void print_errors(const Solver& solver, int instances, const SolveOptions& options) {
    constexpr double none = 180;
    std::vector<double> errors;
    for (int i = 0; i < instances; ++i) {
        SyntheticScene scene =
            synthetic_scene(solver.plan().problem, static_cast<std::uint64_t>(i));
        move(scene, static_cast<std::uint64_t>(i));
        double least = none;
        for (const Solution& solution : solver.solve(scene.images, options).solutions)
            if (solution.real) least = std::min(least, rotation_error(solution.cameras, scene));
        errors.push_back(least);
    }
    std::printf("%-14s %d instances: the best solution has rotations within %.2g degrees (median), "
                "%.2g in 9 of 10\n",
                "half a pixel", instances, at(errors, 0.5), at(errors, 0.9));
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

struct EngineFigures {
    std::vector<double> milliseconds; ///< for the paths once, in doubles
    std::uint64_t paths = 0;
    std::uint64_t lost = 0; ///< with twice the digits and on detours, too
};

/// The engine of `plprove degree` follows the same number of paths, between random complex images.
EngineFigures of_engine(const Solver& solver, int instances) {
    const Start& start = solver.start();
    const TrackedSystem tracked = tracked_system(solver.system(), start.chart);
    const auto moving = [&](const Images& from, const Images& to) {
        return moving_images(solver.system(), start.constants, from, to);
    };
    Random random(2, 0);
    EngineFigures figures;
    for (int i = 0; i < instances; ++i) {
        Images to;
        for (std::size_t k = 0; k < start.images.size(); ++k)
            to.push_back(unit(random.complex3()));
        const auto detour = [&] {
            const Images middle = detour_midpoint(start.images, to, random);
            return std::array{moving(start.images, middle), moving(middle, to)};
        };
        const TrackedImages straight = moving(start.images, to);
        PathFollower follower(tracked);
        const double begin = processor_milliseconds();
        auto ends = follower.follow_quickly(straight, start.solutions);
        figures.milliseconds.push_back(processor_milliseconds() - begin);
        fill(ends, start.solutions,
             [&](const auto& open) { return follower.follow_double_double(straight, open); });
        fill(ends, start.solutions, [&](const auto& open) {
            return follower.follow_detours({detour(), detour}, open);
        });
        figures.paths += start.solutions.size();
        figures.lost += without_end(start.solutions, ends).first.size();
    }
    return figures;
}

void print(const char* kind, const Figures& figures, bool truth) {
    std::printf("%-14s %d instances: %.4f %% of the solutions found, all in %d", kind,
                figures.instances,
                100.0 * static_cast<double>(figures.found) / static_cast<double>(figures.degree),
                figures.whole);
    if (truth) std::printf("; the true cameras in %d", figures.with_truth);
    std::printf("; median %.3g ms of processor time, 9 of 10 below %.3g ms; %.3g ms by the clock\n",
                at(figures.milliseconds, 0.5), at(figures.milliseconds, 0.9),
                at(figures.wall, 0.5));
}

/// Prints how often the true cameras are among those of a sample, or near ones if there is noise,
/// and in which time.
void print_samples(const SampleSolver& solver, int instances, bool noise) {
    constexpr double near = 5; // degrees
    std::vector<double> milliseconds;
    int good = 0;
    std::size_t found = 0;
    for (int i = 0; i < instances; ++i) {
        SyntheticScene scene = synthetic_scene(solver.problem(), static_cast<std::uint64_t>(i));
        if (noise) move(scene, static_cast<std::uint64_t>(i));
        const double begin = processor_milliseconds();
        const auto cameras = solver.solve(scene.images);
        milliseconds.push_back(processor_milliseconds() - begin);
        found += cameras.size();
        good += std::ranges::any_of(cameras, [&](const auto& poses) {
            return noise ? rotation_error(poses, scene) < near : distance(poses, scene) < 1e-6;
        });
    }
    std::printf("%-14s %d instances: %s cameras in %d; %.3g cameras a sample; median %.3g ms "
                "of processor time, 9 of 10 below %.3g ms\n",
                "samples", instances, noise ? "near" : "the true", good,
                static_cast<double>(found) / instances, at(milliseconds, 0.5),
                at(milliseconds, 0.9));
}

std::size_t paths_of(const std::vector<std::string_view>& words) {
    for (const std::string_view word : words)
        if (word.starts_with("paths="))
            return static_cast<std::size_t>(std::max(1, std::atoi(word.data() + 6)));
    return SampleSolver::usual_paths;
}

SearchOptions search_options(const std::vector<std::string_view>& words) {
    SearchOptions options;
    for (const std::string_view word : words) {
        if (word == "quick") options.effort = Effort::once;
        if (word == "paths") options.templates = false;
        if (word.starts_with("threads="))
            options.threads = static_cast<unsigned>(std::max(1, std::atoi(word.data() + 8)));
    }
    return options;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fputs("usage: bench_solve PROBLEM INSTANCES [quick] [paths] [threads=N] [noise]\n"
                   "       bench_solve PROBLEM INSTANCES samples [paths=N] [noise]\n",
                   stderr);
        return 3;
    }
    const Features problem = parse_spec(argv[1]);
    const int instances = std::max(1, std::atoi(argv[2]));
    const std::vector<std::string_view> words(argv + 3, argv + argc);
    if (std::ranges::find(words, "samples") != words.end()) {
        print_samples(SampleSolver(problem, paths_of(words)), instances,
                      std::ranges::find(words, "noise") != words.end());
        return 0;
    }
    const Solver solver = make_solver(problem);
    const SolveOptions options{search_options(words), false, false};
    if (std::ranges::find(words, "noise") != words.end()) {
        print_errors(solver, instances, options);
        return 0;
    }
    print("scenes", of_scenes(solver, instances, options), true);
    if (solver.plan().number) {
        const Figures random = of_random_images(solver, instances, options);
        print("random images", random, false);
        const EngineFigures figures = of_engine(solver, instances);
        const double engine = at(figures.milliseconds, 0.5);
        std::printf("%-14s %.3g ms for the same number of paths: random images take %.2f "
                    "times as long; %llu of %llu paths lost\n",
                    "engine", engine, at(random.milliseconds, 0.5) / engine,
                    static_cast<unsigned long long>(figures.lost),
                    static_cast<unsigned long long>(figures.paths));
    }
    return 0;
}
