// The equations of many views: solved by the scene that the images are of, and differentiated
// right.
#include "prover/many_views/system.h"

#include "prover/problem/notation.h"

#include <Eigen/LU>
#include <doctest/doctest.h>

using namespace plprove;
using namespace plprove::many_views;

namespace {

/// Calibrated and projective, with shared lines, pins and free lines.
const std::vector<std::string> problems{
    "5*P/P",
    "2*PL/PL/PL + PLa/PLa/PLa + a/a/a",
    "3*PL/PL/PL/PL + a/a/a/a",
    "projective: 7*P/P",
    "projective: 9*a/a/a",
    "projective: Pabcdef/Pabcdef/Pabcdef/Pabcdef + 3*a/a/a/a",
};

double largest(const Eigen::VectorXcd& values) {
    return values.cwiseAbs().maxCoeff();
}

} // namespace

TEST_CASE("the system is square, and the scene solves it") {
    for (const std::string& text : problems) {
        CAPTURE(text);
        Random random(3, 1);
        const System system(parse_problem(text), random);
        const SolvedImages scene = system.random_scene(random);
        Evaluation at_scene;
        system.evaluate(on_the_way(scene.images, scene.images, 0), scene.solution, at_scene);
        CHECK(at_scene.values.size() == system.unknowns());
        CHECK(largest(at_scene.values) < 1e-12);
        // Other vectors for the same images have the same solutions.
        const auto same = rephased(system.problem(), scene.images, random);
        system.evaluate(on_the_way(same, same, 0), scene.solution, at_scene);
        CHECK(largest(at_scene.values) < 1e-12);
        // Other images do not.
        const auto other = random_images(system.problem(), random);
        system.evaluate(on_the_way(other, other, 0), scene.solution, at_scene);
        CHECK(largest(at_scene.values) > 1e-3);
    }
}

TEST_CASE("derivatives are limits of differences") {
    constexpr double step = 1e-6;
    for (const std::string& text : problems) {
        CAPTURE(text);
        Random random(4, 1);
        const System system(parse_problem(text), random);
        const auto from = random_images(system.problem(), random);
        const auto to = random_images(system.problem(), random);
        const Point point = system.random_scene(random).solution;
        Evaluation middle, before, after;
        const auto evaluate = [&](double time, const Point& at, Evaluation& result) {
            system.evaluate(on_the_way(from, to, time), at, result);
            return result.values;
        };
        evaluate(0.3, point, middle);
        const Point speeds =
            (evaluate(0.3 + step, point, after) - evaluate(0.3 - step, point, before)) / (2 * step);
        CHECK(largest(speeds - middle.speeds) < 1e-7);
        for (Eigen::Index k = 0; k < system.unknowns(); ++k) {
            const Point direction = Point::Unit(system.unknowns(), k);
            const Point difference = (evaluate(0.3, point + step * direction, after) -
                                      evaluate(0.3, point - step * direction, before)) /
                                     (2 * step);
            CHECK(largest(difference - middle.jacobian.col(k)) < 1e-7);
        }
    }
}

TEST_CASE("a camera whose quaternion has norm zero is told from one that is nearly so") {
    Random random(5, 1);
    const System system(parse_problem("3*PL/PL/PL/PL + a/a/a/a"),
                        many_views::CameraChart::standard(calibrated_cameras, 4));
    Point point = system.random_scene(random).solution;
    CHECK(system.has_cameras(point));
    const Eigen::Index last = system.depths() + system.chart().offset(3);
    point.segment(last, 3) << Complex(0), Complex(0), Complex(0, 1); // 1 + i i = 0
    CHECK(!system.has_cameras(point));
    // The matrix has rank 1 there: what is left of the camera is its translation.
    const Camera camera = system.chart().camera(3, point.tail(system.chart().dimension())).camera;
    CHECK(camera.leftCols<3>().fullPivLu().rank() == 1);
    point[last + 2] += 1e-5;
    CHECK(system.has_cameras(point));
    const System projective(parse_problem("projective: 7*P/P"), random);
    CHECK(projective.has_cameras(projective.random_scene(random).solution));
}
