// libpointline for a page: what the views see comes in as numbers, all real solutions go out. The
// code is the library's own. What the page never asks of it is left out (left_out.cpp).
#include "prover/library/seen_images.h"
#include "prover/problem/notation.h"
#include "prover/solver/solve.h"

#include <emscripten.h>

using namespace plprove;

namespace {

/// Reads numbers one after the other.
class Numbers {
public:
    explicit Numbers(const double* next) : next_(next) {}

    double real() { return *next_++; }
    std::size_t size() { return static_cast<std::size_t>(real()); }
    template <std::size_t N>
    void fill(std::array<Complex, N>& numbers) {
        for (Complex& z : numbers) {
            const double re = real();
            z = {re, real()};
        }
    }
    template <std::size_t N>
    void fill(std::vector<std::array<Complex, N>>& list) {
        for (auto& numbers : list)
            fill(numbers);
    }
    pointline::Point point() {
        const double x = real();
        return {x, real()};
    }

private:
    const double* next_;
};

/// A start as prover/solver/start_file.cpp writes it: the class, how many constants, images and
/// solutions there are, and then all numbers in the order of the file.
Start start_of(Numbers numbers) {
    Start start;
    start.number = numbers.size();
    start.constants.resize(numbers.size());
    start.images.resize(numbers.size());
    start.solutions.resize(numbers.size());
    for (Complex3& form : start.chart.rotation)
        numbers.fill(form);
    numbers.fill(start.chart.centre);
    numbers.fill(start.constants);
    numbers.fill(start.images);
    numbers.fill(start.solutions);
    return start;
}

Solver solver_of(const SolvePlan& plan, const double* start) {
    return plan.number ? Solver(plan, start_of(Numbers(start))) : Solver(plan);
}

/// For each view focal length and principal point (4 numbers); then of each feature, view by view,
/// what the problem says that it sees: the point (2), and two points of each line (4).
pointline::Images images_of(const Features& problem, Numbers numbers) {
    const int views = problem.front().views();
    pointline::Images images;
    for (int view = 0; view < views; ++view) {
        pointline::Intrinsics& camera = images.cameras.emplace_back();
        for (double* x : {&camera.fx, &camera.fy, &camera.cx, &camera.cy})
            *x = numbers.real();
    }
    for (const Feature& feature : problem) {
        auto& sightings = images.features.emplace_back();
        for (int view = 0; view < views; ++view) {
            pointline::Sighting& sighting = sightings.emplace_back();
            if (feature.sees_point(view)) sighting.point = numbers.point();
            for (int line = 0; line < feature.lines; ++line) {
                if (!feature.sees_line(view, line)) continue;
                const pointline::Point p = numbers.point(), q = numbers.point();
                sighting.lines[static_cast<char>('a' + line)] = {
                    {p[1] - q[1], q[0] - p[0], p[0] * q[1] - p[1] * q[0]}, {p, q}};
            }
        }
    }
    return images;
}

/// What pages hold: a solver, and what it said last.
struct OpenSolver {
    explicit OpenSolver(SolvePlan plan, const double* start) : solver(solver_of(plan, start)) {}

    void put(const Eigen::Vector3cd& x) {
        for (int i = 0; i < 3; ++i)
            answer.push_back(x[i].real());
    }
    void put(const Solution& solution);

    Solver solver;
    std::vector<double> answer;
    std::string error;
};

/// How many points are in front of the cameras, and the residual; each camera, R by rows and t;
/// each feature: its point, and a point and the direction of each line. What is missing is not a
/// number.
void OpenSolver::put(const Solution& solution) {
    const Eigen::Vector3cd missing = Eigen::Vector3cd::Constant(std::nan(""));
    answer.push_back(solution.in_front);
    answer.push_back(solution.residual);
    for (const ComplexPose& pose : solution.cameras) {
        for (int i = 0; i < 3; ++i)
            put(pose.R.row(i).transpose());
        put(pose.t);
    }
    for (const SpaceFeature& feature : solution.features) {
        put(feature.point.value_or(missing));
        for (const auto& line : feature.lines) {
            put(line ? line->point : missing);
            put(line ? line->direction : missing);
        }
    }
}

std::string open_error;

} // namespace

extern "C" {

/// A solver of the problem in notation; nothing, and why (open_solver_error), where it is none. In
/// two views no start is read.
EMSCRIPTEN_KEEPALIVE OpenSolver* open_solver(const char* problem, const double* start) {
    try {
        return new OpenSolver(plan(parse_features(problem)), start);
    } catch (const std::exception& error) {
        open_error = error.what();
        return nullptr;
    }
}

EMSCRIPTEN_KEEPALIVE const char* open_solver_error() {
    return open_error.c_str();
}

/// The answer as numbers, valid until the next one: how many solutions generic images have, how
/// many of them were found, whether it is certified that there are no more, how many pixels images
/// were moved; how many solutions are real, and these. Nothing where the images are none
/// (solver_error). With `quick`, paths that are lost are not followed again.
EMSCRIPTEN_KEEPALIVE const double* solve_images(OpenSolver* open, const double* numbers,
                                                int quick) {
    try {
        const Features& problem = open->solver.plan().problem;
        const MovedImages images = seen_images(problem, images_of(problem, Numbers(numbers)));
        SolveOptions options;
        options.complex = options.conditions = options.search.templates = false;
        options.search.effort = quick != 0 ? Effort::once : Effort::thorough;
        const Answer answer = open->solver.solve(images.images, options);
        open->answer = {static_cast<double>(answer.degree), static_cast<double>(answer.found),
                        answer.complete == Completeness::certified ? 1.0 : 0.0, images.moved,
                        static_cast<double>(answer.solutions.size())};
        for (const Solution& solution : answer.solutions)
            open->put(solution);
        return open->answer.data();
    } catch (const std::exception& error) {
        open->error = error.what();
        return nullptr;
    }
}

EMSCRIPTEN_KEEPALIVE const char* solver_error(OpenSolver* open) {
    return open->error.c_str();
}
}
