#include "prover/solver/general.h"

#include "prover/many_views/scene_loops.h"
#include "prover/many_views/standard_chart.h"
#include "prover/solver/general_images.h"
#include "prover/solver/poses.h"
#include "prover/system/exit.h"

#include <Eigen/LU>
#include <algorithm>

namespace plprove {

namespace {

using many_views::Point;
using many_views::System;
using ComplexImages = many_views::Images<many_views::Complex>;

bool is_projective(const Problem& problem) {
    return problem.cameras == &projective_cameras;
}

many_views::DegreeOnFile known_degree(const Problem& problem) {
    const std::string name = notation(problem);
    if (problem.cameras != &calibrated_cameras && !is_projective(problem))
        throw BadInput("solve takes calibrated and uncalibrated (projective) cameras: " + name +
                       " has others");
    const auto known = many_views::degree_on_file(name);
    if (!known || known->bound != "exact")
        throw BadInput("solve takes the minimal problems of certs/family-degrees.csv, and in at "
                       "most three views those with one point on a line: " +
                       name + " is none of these");
    return *known;
}

/// [M | t] with a rotation M, where the cameras are calibrated.
ComplexPose pose_of(const many_views::Camera& camera, bool projective) {
    ComplexPose pose{camera.leftCols<3>(), camera.col(3)};
    if (projective) return pose;
    // M is a multiple of a rotation: M M^T = factor^2, det M = factor^3.
    const auto square = camera.row(0).head<3>().cwiseProduct(camera.row(0).head<3>()).sum();
    const auto factor = pose.R.determinant() / square;
    return {pose.R / factor, pose.t / factor};
}

std::vector<ComplexPose> poses_at(const System& standard, const Point& point) {
    const bool projective = is_projective(standard.problem());
    const Point coordinates = point.tail(standard.chart().dimension());
    std::vector<ComplexPose> poses(1);
    for (std::size_t view = 1; view < static_cast<std::size_t>(standard.problem().views); ++view)
        poses.push_back(pose_of(standard.chart().camera(view, coordinates).camera, projective));
    if (!projective) fix_scale(poses);
    return poses;
}

/// The lines through several points, which no view was given.
void add_shared_lines(const Features& features, Solution& solution) {
    for (std::size_t f = 0; f < features.size(); ++f)
        for (std::size_t line = 0; line < features[f].shared.size(); ++line) {
            const auto has_it = [&](const Feature& other) {
                return &other != &features[f] &&
                       other.shared.find(features[f].shared[line]) != std::string::npos;
            };
            const auto other = std::ranges::find_if(features, has_it) - features.begin();
            const auto& a = solution.features[f].point;
            const auto& b = solution.features[static_cast<std::size_t>(other)].point;
            if (a && b) solution.features[f].lines[line] = SpaceLine{*a, (*b - *a).normalized()};
        }
}

/// Where cameras have no intrinsics: images and space in the coordinates of the given images.
void undo_centring(const std::vector<Eigen::Matrix3d>& calibration, Solution& solution) {
    const Eigen::Matrix3cd first = calibration[0].cast<std::complex<double>>();
    for (std::size_t view = 0; view < calibration.size(); ++view) {
        const Eigen::Matrix3cd K = calibration[view].cast<std::complex<double>>();
        ComplexPose& pose = solution.cameras[view];
        pose = {K * pose.R * first.inverse(), K * pose.t};
    }
    for (SpaceFeature& feature : solution.features) {
        std::ranges::fill(feature.in_front, std::nullopt);
        if (feature.point) feature.point = (first * *feature.point).eval();
        for (auto& line : feature.lines)
            if (line) line = SpaceLine{first * line->point, (first * line->direction).normalized()};
    }
    solution.in_front = 0;
}

Solution solution_at(const System& standard, const Point& point, const SeenImages& images,
                     bool real) {
    const std::vector<ComplexPose> poses = poses_at(standard, point);
    if (!real) return complex_solution(images, poses);
    if (!is_projective(standard.problem())) return real_solution(images, real_poses(poses));
    std::vector<Pose<double>> matrices;
    for (const ComplexPose& pose : poses)
        matrices.push_back({pose.R.real(), pose.t.real()});
    return real_solution(images, matrices);
}

} // namespace

int degree_to_solve(const Problem& problem) {
    return known_degree(problem).degree;
}

GeneralSolver::GeneralSolver(const Problem& problem, const Options& options)
    : known_(known_degree(problem)), seed_(options.seed),
      from_(solved_images(problem, known_.degree, options)) {}

GeneralSolver::RandomImages GeneralSolver::solved_images(const Problem& problem, int degree,
                                                         const Options& options) {
    constexpr int most_edges = 8;
    auto monodromy =
        many_views::scene_monodromy(many_views::SceneLoops(problem, options.seed, options.threads),
                                    [&](const MonodromyProgress& progress) {
                                        if (options.found) options.found(progress.solutions);
                                    });
    monodromy.reach(degree, most_edges);
    return {monodromy.loops().system(), monodromy.loops().images(0),
            monodromy.solutions().points()};
}

std::vector<Point> GeneralSolver::follow_to(const ComplexImages& images, const System& standard,
                                            int threads) const {
    constexpr int most_ways = 5;
    constexpr std::uint64_t stream = 3; // another one than that of monodromy
    Random random(seed_, stream);
    const many_views::Images<many_views::Moving> still = many_views::on_the_way(images, images, 0);
    many_views::Evaluation room;
    SolutionSet<Point> found(1e-7, Nearness::of_coordinates);
    for (int way = 0; way < most_ways && found.size() < degree(); ++way) {
        const auto care = way == 0 ? many_views::Care::usual : many_views::Care::careful;
        const ComplexImages to = many_views::rephased(standard.problem(), images, random);
        for (const auto& end : many_views::follow_all(from_.system, from_.images, to,
                                                      from_.solutions, care, threads)) {
            if (!end || !from_.system.has_cameras(*end)) continue;
            const auto point = many_views::refined(
                standard, still, many_views::in_standard_chart(from_.system, *end), room);
            if (point && !found.find(*point)) found.add(*point);
        }
    }
    return found.points();
}

Answer GeneralSolver::solve(const SeenImages& images, bool complex, int threads) const {
    const bool projective = is_projective(problem());
    const SeenImages seen = projective ? centred(images) : images;
    const System standard(problem(),
                          many_views::CameraChart::standard(*problem().cameras, problem().views));
    const Features features = features_of(problem());
    Answer answer;
    answer.degree = degree();
    for (const Point& point : follow_to(images_for_equations(problem(), seen), standard, threads)) {
        ++answer.found;
        const bool real = many_views::is_real(point);
        if (!real && !complex) continue;
        Solution& solution =
            answer.solutions.emplace_back(solution_at(standard, point, seen, real));
        add_shared_lines(features, solution);
        if (projective) undo_centring(seen.calibration, solution);
    }
    answer.lost = answer.degree - answer.found;
    if (answer.lost == 0)
        answer.complete =
            known_.status == "certified" ? Completeness::certified : Completeness::evidence;
    finish(answer, seen);
    return answer;
}

} // namespace plprove
