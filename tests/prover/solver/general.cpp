// Problems with shared lines, more views or uncalibrated cameras: images are made of a known scene,
// whose cameras are among the solutions.
#include "prover/solver/general.h"

#include "prover/solver/images_file.h"
#include "prover/solver/synthetic.h"
#include "prover/system/exit.h"
#include "tests/prover/solver/truth.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <doctest/doctest.h>

using namespace plprove;

namespace {

Answer answer_for(const SyntheticScene& scene) {
    return GeneralSolver(*scene.general, {}).solve(scene.images, true, 1);
}

/// A scene with images in pixels, as a file has them, if cameras are uncalibrated.
SyntheticScene scene_of(const char* problem, std::uint64_t seed) {
    return synthetic_scene(parse_problem(problem), seed);
}

/// The matrix F with y·Fx = 0 for the images x and y of a point in cameras [I | 0] and [M | t], of
/// length 1.
Eigen::Matrix3d fundamental(const Eigen::Matrix3d& M, const Eigen::Vector3d& t) {
    Eigen::Matrix3d cross;
    cross << 0, -t[2], t[1], t[2], 0, -t[0], -t[1], t[0], 0;
    return (cross * M).normalized();
}

double distance_up_to_sign(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
    return std::min((a - b).norm(), (a + b).norm());
}

} // namespace

TEST_CASE("with shared lines and in more views the true cameras are among all solutions") {
    for (const char* problem : {"3*PL/PL + 2*P/P", "PLM/PLM + 2*PL/PL + 2*PM/PM",
                                "3*PL/PL/PL + P/P/P", "2*PL/PL/PL + PLa/PLa/PLa + a/a/a",
                                "3*PL/PL/PL/PL + a/a/a/a", "2*PL/PL/PL/PL + PLab/PLab/PLab/PLab"}) {
        CAPTURE(problem);
        const SyntheticScene scene = scene_of(problem, 1);
        const Answer answer = answer_for(scene);
        CHECK(answer.found == answer.degree);
        CHECK(answer.complete == Completeness::certified);
        CHECK(std::ssize(answer.solutions) == answer.found);
        const Solution& truth = solver_tests::nearest(answer, scene);
        CHECK(solver_tests::distance(truth, scene) < 1e-6);
        CHECK(truth.real);
        for (const Solution& solution : answer.solutions)
            CHECK(solution.residual < 1e-3);
        // Points, pins and free lines are those of the scene; shared lines join their points.
        for (std::size_t f = 0; f < scene.problem.size(); ++f) {
            const Feature& feature = scene.problem[f];
            const SpaceFeature& found = truth.features[f];
            if (feature.has_point) CHECK((found.point->real() - scene.points[f]).norm() < 1e-5);
            for (std::size_t line = 0; line < found.lines.size(); ++line) {
                REQUIRE(found.lines[line]);
                const Eigen::Vector3d direction = found.lines[line]->direction.real();
                if (line >= feature.shared.size()) {
                    CHECK(direction.cross(scene.directions[f][line]).norm() < 1e-5);
                    continue;
                }
                for (std::size_t g = 0; g < scene.problem.size(); ++g)
                    if (scene.problem[g].shared.find(feature.shared[line]) != std::string::npos)
                        CHECK(direction.cross(scene.points[g] - scene.points[f]).norm() < 1e-5);
            }
        }
    }
}

TEST_CASE("of uncalibrated cameras the true fundamental matrix is among those of the solutions") {
    for (const char* problem :
         {"projective: 7*P/P", "projective: 6*P/P/P", "projective: 2*P/P/P + 6*a/a/a",
          "projective: 2*Pab/Pab/Pab + Pabc/Pabc/Pabc + a/a/a"}) {
        CAPTURE(problem);
        SyntheticScene scene = scene_of(problem, 2);
        const Eigen::Matrix3d K = scene.images.calibration[0]; // of all views
        for (std::size_t v = 0; v < scene.images.calibration.size(); ++v) {
            scene.images.calibration[v].setIdentity();
            for (FeatureSightings& sightings : scene.images.observation) {
                Sighting& seen = sightings[v];
                if (seen.point) seen.point = K * *seen.point;
                for (auto& line : seen.lines)
                    if (line) line = (K.inverse().transpose() * *line).eval();
            }
        }
        const Answer answer = answer_for(scene);
        CHECK(answer.found == answer.degree);
        const Pose<double>& second = scene.cameras[1];
        const Eigen::Matrix3d truth = fundamental(K * second.R * K.inverse(), K * second.t);
        double nearest = 1;
        for (const Solution& solution : answer.solutions) {
            CHECK(solution.cameras[0].R.isIdentity(1e-9));
            CHECK(solution.in_front == 0);
            CHECK(solution.residual < 1e-3);
            if (!solution.real) continue;
            const Eigen::Matrix3d M = solution.cameras[1].R.real();
            const Eigen::Vector3d t = solution.cameras[1].t.real();
            nearest = std::min(nearest, distance_up_to_sign(fundamental(M, t), truth));
        }
        CHECK(nearest < 1e-6);
    }
}

TEST_CASE("points of a line are moved onto one, and their pins with them") {
    const SyntheticScene scene = scene_of("2*PL/PL/PL + PLa/PLa/PLa + a/a/a", 1);
    GivenImages images = read_images(images_file(scene), "f", std::nullopt);
    images.features[2][1].point->at(1) += 3;
    const ConsistentImages moved = consistent(images);
    CHECK(moved.moved > 0.1);
    CHECK(moved.moved < 3);
    const SeenImages seen = rounded(images, moved);
    for (std::size_t v = 0; v < 3; ++v) {
        Eigen::Matrix3d points;
        for (Eigen::Index p = 0; p < 3; ++p)
            points.col(p) = *seen.observation[static_cast<std::size_t>(p)][v].point;
        CHECK(std::abs(points.determinant()) < 1e-12);
        const Sighting& third = seen.observation[2][v];
        CHECK(std::abs(third.lines[1]->normalized().dot(*third.point)) < 1e-12);
        CHECK_FALSE(third.lines[0]);
    }
}

TEST_CASE("problems that have no degree on file are not solved, and it is said which are") {
    for (const char* problem :
         {"P/P/P/- + 6*P/P/-/P", "shared-focal: 6*P/P", "projective: 5*P/P + 2*P/-"})
        CHECK_THROWS_AS(degree_to_solve(parse_problem(problem)), BadInput);
    CHECK(degree_to_solve(parse_problem("projective: 7*P/P")) == 3);
}
