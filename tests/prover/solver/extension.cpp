// Extensions of the five-point problem: templates and paths, which have nothing in common, find the
// same cameras; and these satisfy the equations that templates are made of.
#include "prover/solver/extension.h"

#include "prover/monodromy/solution_set.h"
#include "prover/problem/notation.h"
#include "prover/solver/camera_solver.h"
#include "prover/solver/plan.h"
#include "prover/solver/solve.h"
#include "prover/solver/synthetic.h"
#include "prover/solver/templates/values.h"

#include <Eigen/LU>
#include <doctest/doctest.h>
#include <set>

using namespace plprove;

namespace {

/// An extension for each frame, and how many cameras a template registers with each relative pose.
struct Extension {
    const char* problem;
    templates::Frame frame;
    int registrations;
};

constexpr std::array extensions{
    Extension{"2*P/P/P + a/Pa/Pa + 2*-/P/P", templates::Frame::line, 4},
    Extension{"Pa/Pa/Pa + P/P/P + 3*-/P/P + P/-/P", templates::Frame::points, 12},
    Extension{"2*a/Pa/Pa + 3*-/P/P + 2*P/-/P", templates::Frame::lines, 16},
    Extension{"3*P/P/P + 2*-/P/P", templates::Frame::general, 8}};

std::vector<Eigen::Vector3d> images_of(const SolvePlan& how, const CameraSystem& system,
                                       std::uint64_t seed) {
    const SyntheticScene scene = synthetic_scene(how.problem, seed);
    return class_images(how, system, scene.images.observation);
}

/// Whether each camera of one is among the other's.
bool contains(const FoundCameras& all, const FoundCameras& some) {
    SolutionSet<CameraPoint> set(1e-8);
    for (const QuaternionCameras& cameras : all.cameras)
        set.add(standard_chart().point(cameras));
    for (const QuaternionCameras& cameras : some.cameras)
        if (!set.find(standard_chart().point(cameras))) return false;
    return true;
}

} // namespace

TEST_CASE("templates find the cameras that paths find") {
    for (const Extension& extension : extensions) {
        CAPTURE(extension.problem);
        const SolvePlan how = plan(parse_features(extension.problem));
        const CameraSolver solver(find_start(*how.number, 0));
        int without_paths = 0;
        for (std::uint64_t seed = 0; seed < 5; ++seed) {
            CAPTURE(seed);
            const auto images = images_of(how, solver.system(), seed);
            SearchOptions options;
            const FoundCameras by_templates = solver.solve(images, options);
            options.templates = false;
            const FoundCameras by_paths = solver.solve(images, options);
            CHECK(by_templates.lost == 0);
            CHECK(std::ssize(by_templates.cameras) == 20 * extension.registrations);
            CHECK(contains(by_templates, by_paths));
            CHECK(by_paths.steps > 0);
            without_paths += by_templates.steps == 0;
        }
        CHECK(without_paths >= 4);
    }
}

TEST_CASE("what is not a number is no camera") {
    // In this scene a template has solutions that overflow.
    const SolvePlan how = plan(parse_features("a/Pa/Pa + 4*-/P/P + 4*P/-/P"));
    const CameraSolver solver(find_start(*how.number, 0));
    const FoundCameras found = solver.solve(images_of(how, solver.system(), 4), {});
    CHECK(found.cameras.size() == 400);
    for (const QuaternionCameras& cameras : found.cameras)
        for (const auto& quaternion : cameras.quaternion)
            for (const Complex& x : quaternion)
                CHECK(std::isfinite(std::abs(x)));
}

TEST_CASE("each frame has its template, and problems that are no extensions have none") {
    for (const Extension& extension : extensions) {
        CAPTURE(extension.problem);
        const auto number = plan(parse_features(extension.problem)).number;
        const auto solver = ExtensionSolver::make(label_classes()[*number]);
        REQUIRE(solver);
        CHECK(solver->registration().frame() == extension.frame);
        CHECK(solver->registration().solutions() == extension.registrations);
    }
    const auto chicago = plan(parse_features("2*Pa/Pa/Pa + P/P/P")).number;
    CHECK_FALSE(ExtensionSolver::make(label_classes()[*chicago]));
}

TEST_CASE("the equations vanish at the cameras that made the images, and nowhere else") {
    for (const Extension& extension : extensions) {
        CAPTURE(extension.problem);
        const SolvePlan how = plan(parse_features(extension.problem));
        const Signature& signature = label_classes()[*how.number];
        const CameraSystem system = camera_system(signature);
        const SyntheticScene synthetic = synthetic_scene(how.problem, 7);
        const auto pose = [&](int view) { // of the view of the class
            const auto& camera =
                synthetic
                    .cameras[static_cast<std::size_t>(how.view_of[static_cast<std::size_t>(view)])];
            return ComplexPose{camera.R.cast<Complex>(), camera.t.cast<Complex>()};
        };
        const ComplexPose first = pose(1), second = pose(2), third = pose(0);
        const auto relative = [&](const ComplexPose& camera) {
            const Eigen::Matrix3cd R = camera.R * first.R.transpose();
            return ComplexPose{R, camera.t - R * first.t};
        };
        const auto images = class_images(how, system, synthetic.images.observation);
        const auto scene = known_scene(ClassSights(system, images), 0, relative(second));
        const FramedScene framed = in_frame(scene, extension.frame, 3);
        const auto values_at = [&](const Eigen::Matrix3cd& rotation) {
            return equation_values<Complex>(framed.scene, extension.frame,
                                            framed.view * rotation * framed.space.transpose());
        };
        const auto at_truth = values_at(relative(third).R);
        const auto elsewhere = values_at(Eigen::Matrix3cd::Identity());
        const auto in_integers = templates::equations(
            templates::draw_data(templates::registration(signature, 0), extension.frame, 1),
            extension.frame);
        REQUIRE(at_truth.size() == in_integers.size());
        for (std::size_t e = 0; e < at_truth.size(); ++e)
            CHECK(std::abs(at_truth[e]) < 1e-9 * std::abs(elsewhere[e]));
        const Eigen::Vector3cd t = translation(scene, relative(third).R);
        CHECK((t - relative(third).t).norm() < 1e-9 * t.norm());
    }
}

TEST_CASE("any number of threads finds the same cameras, to the last bit") {
    const SolvePlan how = plan(parse_features(extensions[0].problem));
    const CameraSolver solver(find_start(*how.number, 0));
    const auto images = images_of(how, solver.system(), 1);
    for (const bool templates : {true, false}) {
        CAPTURE(templates);
        SearchOptions options;
        options.templates = templates;
        const FoundCameras alone = solver.solve(images, options);
        for (const unsigned threads : {2U, 3U, 7U}) {
            CAPTURE(threads);
            options.threads = threads;
            const FoundCameras shared = solver.solve(images, options);
            CHECK(shared.steps == alone.steps);
            REQUIRE(shared.cameras.size() == alone.cameras.size());
            for (std::size_t k = 0; k < alone.cameras.size(); ++k) {
                CHECK(shared.cameras[k].quaternion == alone.cameras[k].quaternion);
                CHECK(shared.cameras[k].centre == alone.cameras[k].centre);
            }
        }
    }
}
