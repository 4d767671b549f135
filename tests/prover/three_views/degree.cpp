// Degrees: known ones as laws, relations between them, and what a run reports.
#include "prover/three_views/degree.h"
#include "prover/three_views/integer_vectors.h"
#include "prover/three_views/scene.h"
#include "tests/support/solved_class.h"

#include <algorithm>
#include <doctest/doctest.h>

using namespace plprove;

namespace {

DegreeOptions at_least(int solutions, std::uint64_t seed = 0) {
    DegreeOptions options;
    options.at_least = solutions;
    options.seed = seed;
    return options;
}

DegreeOptions of_degree(int degree, int target = 0) {
    DegreeOptions options;
    options.degree = degree;
    options.target = target;
    return options;
}

} // namespace

TEST_CASE("published degrees are reached, with a certificate for all solutions") {
    for (const auto& [notation, degree] :
         {std::pair("2*Pa/Pa/Pa + P/P/P", 312), std::pair("3*P/P/P + a/a/a", 216)}) {
        CAPTURE(notation);
        const DegreeRun result = compute_degree(number_of(notation), of_degree(degree));
        CHECK(result.degree == degree);
        CHECK(result.complete);
        REQUIRE(result.certificate);
        CHECK(result.certificate->degree() == degree);
    }
}

TEST_CASE(
    "five points in two views leave 20 relative poses, each with equally many third cameras") {
    // Views 2 and 3 share exactly five points.
    const Solved solved(number_of("2*P/P/P + a/P/Pa + 2*-/P/P + P/-/P"));
    const SolutionSet<CameraPoint>& solutions = solved.monodromy.solutions();
    CHECK(solutions.size() % 20 == 0);
    // The relative rotation R_3 R_2^T, which is the quaternion q_3 q_2^* up to scale.
    std::vector<std::pair<std::array<Complex, 3>, int>> poses;
    for (const CameraPoint& point : solutions.points()) {
        const QuaternionCameras cameras = solved.loops().chart().cameras(point);
        const auto& [a, b, c, d] = cameras.quaternion[1];
        const auto& [e, f, g, h] = cameras.quaternion[0];
        const Complex scale = a * e + b * f + c * g + d * h;
        const std::array<Complex, 3> pose{(b * e - a * f + d * g - c * h) / scale,
                                          (c * e - a * g + b * h - d * f) / scale,
                                          (d * e - a * h + c * f - b * g) / scale};
        const auto known = std::ranges::find_if(poses, [&](const auto& other) {
            double distance = 0, size = 1;
            for (std::size_t k = 0; k < 3; ++k) {
                distance += std::abs(other.first[k] - pose[k]);
                size += std::abs(pose[k]);
            }
            return distance < 1e-5 * size;
        });
        if (known == poses.end())
            poses.emplace_back(pose, 1);
        else
            ++known->second;
    }
    CHECK(poses.size() == 20);
    for (const auto& pose : poses)
        CHECK(pose.second == solutions.size() / 20);
}

TEST_CASE("degrees are reached under swap, exchange and relabeling, tracked from other equations") {
    const std::string base = "2*P/P/P + a/P/Pa + 2*-/P/P + P/-/P";
    const Signature signature = *signature_of(parse_spec(base));
    Signature swapped = signature;
    std::swap(swapped[12], swapped[13]);
    for (const Signature& one : {signature, swapped})
        CHECK(compute_degree(class_number(label_classes(), representative(one)), of_degree(240))
                  .complete);

    // The views in another order.
    const CameraSystem system = camera_system(relabelings(signature)[3]);
    auto monodromy = camera_monodromy(CameraLoops(system, 2, 0));
    monodromy.reach(240, 6);
    CHECK(monodromy.solutions().size() == 240);
}

TEST_CASE("there are no more solutions than the degree, however long one looks for them") {
    Solved solved(number_of("3*P/P/P + a/a/a"), 217);
    CHECK(solved.solutions().size() == 216);
    CHECK(solved.monodromy.graph().edges() == 10);
    for (int edge = 0; edge < 10; ++edge)
        CHECK(solved.monodromy.graph().matched(edge) == 216);
}

TEST_CASE("the same class and seed give the same certificate, another seed another one") {
    const std::size_t number = number_of("3*P/P/P + a/a/a");
    const auto values = [&](std::uint64_t seed) {
        const DegreeRun found = compute_degree(number, at_least(216, seed));
        std::vector<std::vector<std::int64_t>> result;
        for (const auto& solution : found.certificate->solutions)
            result.push_back(solution.values);
        return result;
    };
    CHECK(values(0) == values(0));
    CHECK(values(0) != values(1));
}

TEST_CASE("a run stops at its target") {
    const std::size_t number = number_of("3*P/P/P + a/a/a");
    const DegreeRun part = compute_degree(number, of_degree(216, 100));
    CHECK(part.degree >= 100);
    CHECK(part.degree < 216);
    CHECK_FALSE(part.complete);
    CHECK(part.certificate->degree() == part.degree);
    CHECK(compute_degree(number, of_degree(216, 300)).complete);
}

TEST_CASE("a lower bound of N is a certificate of N different solutions, and no more is claimed") {
    for (const int wanted : {50, 312}) {
        const DegreeRun found = compute_degree(number_of("2*Pa/Pa/Pa + P/P/P"), at_least(wanted));
        CHECK(found.degree >= wanted);
        CHECK(found.degree <= 312);
        CHECK_FALSE(found.complete);
        REQUIRE(found.certificate);
        CHECK(found.certificate->degree() == found.degree);
        CHECK(found.certificate->solutions.size() <= static_cast<std::size_t>(found.degree));
    }
}

TEST_CASE("where there are fewer solutions than a lower bound asks for, all of them are found") {
    const DegreeRun found = compute_degree(number_of("3*P/P/P + a/a/a"), at_least(217));
    CHECK(found.degree == 216);
    CHECK(found.certificate->degree() == 216);
}

TEST_CASE("the images of a lower bound are integers near those of a scene, and generic") {
    const CameraSystem system = camera_system(label_classes()[2394]);
    std::vector<IntegerVector> vectors;
    const CameraLoops loops(system, 0, 2394, [&](const Images& scene, Random& random) {
        for (const Complex3& image : scene)
            for (const Complex& x : image)
                CHECK(x.imag() == 0);
        vectors = vectors_near(system, scene, random);
        return unit_images(vectors);
    });
    CHECK(loops.start_node() == 1); // the images of the other node are integers
    REQUIRE(vectors.size() == system.free.size());
    for (const IntegerVector& vector : vectors)
        for (const std::int64_t x : vector) {
            CHECK(x != 0);
            CHECK(std::abs(x) <= 90);
        }
}

TEST_CASE("of the solutions for real images the conjugates are solutions, too") {
    const CameraSystem system = camera_system(label_classes()[number_of("3*P/P/P + a/a/a")]);
    auto monodromy =
        camera_monodromy(CameraLoops(system, 0, 7, [&](const Images& scene, Random& random) {
            return unit_images(vectors_near(system, scene, random));
        }));
    monodromy.reach(216, 6);
    const CameraLoops& loops = monodromy.loops();
    const SolutionSet<CameraPoint>& solutions = monodromy.solutions();
    REQUIRE(solutions.size() == 216);
    const std::vector<Complex3> vectors = image_vectors(system, loops.constants(), loops.images());
    for (const CameraPoint& point : solutions.points()) {
        const QuaternionCameras cameras = loops.chart().cameras(point);
        CHECK(solutions.find(loops.chart().point(conjugate(cameras))));
        CHECK(nondegeneracy(system, vectors, cameras) > 1e-9);
    }
}
