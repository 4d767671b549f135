#include "prover/library/pointline/solver.h"

#include "prover/library/guarded.h"
#include "prover/library/in_arrays.h"
#include "prover/library/seen_images.h"
#include "prover/problem/spec.h"
#include "prover/solver/general.h"
#include "prover/solver/solve.h"

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <thread>
#include <variant>

namespace pointline {

struct Solver::Content {
    std::string problem;
    plprove::Features features;
    std::variant<plprove::Solver, plprove::GeneralSolver> solver;
};

namespace {

Solution solution(const plprove::Features& features, const plprove::Solution& found) {
    Solution result;
    for (const plprove::ComplexPose& pose : found.cameras)
        result.cameras.push_back(camera({pose.R.real(), pose.t.real()}));
    for (std::size_t f = 0; f < features.size(); ++f) {
        const plprove::SpaceFeature& feature = found.features[f];
        result.points.emplace_back();
        if (feature.point) result.points.back() = vector(feature.point->real());
        auto& lines = result.lines.emplace_back();
        for (std::size_t line = features[f].shared.size(); line < feature.lines.size(); ++line) {
            auto& entry = lines[plprove::letter_of(features[f], static_cast<int>(line))];
            if (const auto& in_space = feature.lines[line])
                entry =
                    SpaceLine{vector(in_space->point.real()), vector(in_space->direction.real())};
        }
    }
    result.in_front = found.in_front;
    result.residual = found.residual;
    result.condition = found.condition.value_or(0);
    return result;
}

Complete complete(plprove::Completeness completeness) {
    switch (completeness) {
    case plprove::Completeness::certified:
        return Complete::certified;
    case plprove::Completeness::evidence:
        return Complete::evidence;
    case plprove::Completeness::unknown:
        return Complete::unknown;
    }
    return Complete::unknown;
}

std::string content_of(const std::string& path) {
    std::error_code none;
    if (std::filesystem::exists(path, none) && !std::filesystem::is_regular_file(path, none))
        throw std::runtime_error("cannot read " + path + ": this is no file");
    std::ifstream file(path, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(file), {});
    if (!file) throw std::runtime_error("cannot read " + path + ": does it exist?");
    return text;
}

} // namespace

Line line_through(const Point& p, const Point& q) {
    return {{p[1] - q[1], q[0] - p[0], p[0] * q[1] - p[1] * q[0]}, {p, q}};
}

Solver::Solver(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

Result<Solver> Solver::make(std::string_view problem) noexcept {
    return guarded<Solver>(Failure::bad_problem, [&] {
        if (const auto general = plprove::parse_general_spec(problem))
            return Solver(std::make_shared<const Content>(
                Content{plprove::notation(*general), plprove::features_of(*general),
                        plprove::GeneralSolver(*general, {})}));
        const plprove::Features parsed = plprove::parse_spec(problem);
        return Solver(std::make_shared<const Content>(
            Content{plprove::notation(parsed), parsed, plprove::make_solver(parsed)}));
    });
}

Result<Solver> Solver::load(std::string_view problem, const std::string& start) noexcept {
    auto plan = guarded<plprove::SolvePlan>(Failure::bad_problem, [&] {
        if (plprove::parse_general_spec(problem))
            throw plprove::BadInput(
                "starts are kept of two or three calibrated views and lines with "
                "at most one point: leave the start out");
        return plprove::plan(plprove::parse_spec(problem));
    });
    if (!plan) return plan.error();
    return guarded<Solver>(Failure::bad_start, [&] {
        return Solver(std::make_shared<const Content>(
            Content{plprove::notation(plan->problem), plan->problem,
                    plprove::Solver(*plan, plprove::read_start(content_of(start), start))}));
    });
}

namespace {

/// What a solver finds, and how far images were moved before.
struct FoundAnswer {
    plprove::Answer answer;
    double moved = 0;
};

FoundAnswer found(const plprove::Solver& solver, const Images& images, const Options& options) {
    const plprove::MovedImages seen = plprove::seen_images(solver.plan().problem, images);
    plprove::SolveOptions how;
    how.search.effort = options.quick ? plprove::Effort::once : plprove::Effort::thorough;
    how.search.threads = options.threads;
    how.complex = false;
    how.conditions = options.conditions;
    return {solver.solve(seen.images, how), seen.moved};
}

FoundAnswer found(const plprove::GeneralSolver& solver, const Images& images,
                  const Options& options) {
    const plprove::MovedImages seen = plprove::seen_images(solver.problem(), images);
    return {solver.solve(seen.images, false, static_cast<int>(options.threads)), seen.moved};
}

} // namespace

Result<Answer> Solver::solve(const Images& images, const Options& options) const noexcept {
    return guarded<Answer>(Failure::bad_images, [&] {
        const auto [all, moved] = std::visit(
            [&](const auto& solver) { return found(solver, images, options); }, content_->solver);
        Answer answer{all.degree, all.found, complete(all.complete), moved, {}};
        for (const plprove::Solution& one : all.solutions)
            answer.solutions.push_back(solution(content_->features, one));
        return answer;
    });
}

std::vector<Result<Answer>> Solver::solve(std::span<const Images> images, const Options& options,
                                          unsigned threads) const noexcept try {
    std::vector<Result<Answer>> answers(images.size(), Error{});
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < images.size(); i = next++)
            answers[i] = solve(images[i], options);
    };
    std::vector<std::jthread> workers;
    try {
        for (unsigned k = 1; k < threads; ++k)
            workers.emplace_back(work);
    } catch (const std::system_error&) {
        // Those that there are do it, too.
    }
    work();
    workers.clear();
    return answers;
} catch (const std::exception&) {
    return {};
}

const std::string& Solver::problem() const {
    return content_->problem;
}

int Solver::degree() const {
    return std::visit([](const auto& solver) { return solver.degree(); }, content_->solver);
}

} // namespace pointline
