// The library by its public headers alone: what programs get that link it.
#include <pointline/problem.h>
#include <pointline/solver.h>

#include <cmath>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <limits>

namespace {

using Vector = std::array<double, 3>;

constexpr pointline::Intrinsics K{700, 710, 300, 200};

/// The second and third camera: turned about the vertical axis, at these centres.
const std::array<pointline::Camera, 3> cameras = [] {
    std::array<pointline::Camera, 3> result;
    const std::array<double, 3> angles{0, -0.2, 0.3};
    const std::array<Vector, 3> centres{{{0, 0, 0}, {0.8, 0.6, 0}, {-1.1, 0.2, 0.4}}};
    for (std::size_t v = 0; v < 3; ++v) {
        const double c = std::cos(angles[v]), s = std::sin(angles[v]);
        result[v].R = {c, 0, s, 0, 1, 0, -s, 0, c};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                result[v].t[i] -= result[v].R[3 * i + j] * centres[v][j];
    }
    return result;
}();

pointline::Point pixel(const Vector& point, std::size_t view) {
    Vector x = cameras[view].t;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            x[i] += cameras[view].R[3 * i + j] * point[j];
    return {K.fx * x[0] / x[2] + K.cx, K.fy * x[1] / x[2] + K.cy};
}

Vector between(const Vector& a, const Vector& b, double s) {
    return {a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), a[2] + s * (b[2] - a[2])};
}

const std::array<Vector, 5> points{
    {{-1, -0.8, 5}, {0.9, -0.5, 4.2}, {0.2, 0.9, 5.5}, {-0.6, 0.7, 3.9}, {0.5, 0.3, 6.1}}};

/// Of 3*P/P/P + a/a/a: three of the points, and the line of the others.
pointline::Images cleveland() {
    pointline::Images images{{K, K, K}, {}};
    for (std::size_t f = 0; f < 4; ++f) {
        auto& views = images.features.emplace_back();
        for (std::size_t v = 0; v < 3; ++v) {
            pointline::Sighting& sighting = views.emplace_back();
            if (f < 3)
                sighting.point = pixel(points[f], v);
            else
                sighting.lines['a'] = pointline::line_through(
                    pixel(points[3], v), pixel(between(points[3], points[4], 0.4), v));
        }
    }
    return images;
}

pointline::Images five_points() {
    pointline::Images images{{K, K}, {}};
    for (const Vector& point : points)
        images.features.push_back({{pixel(point, 0), {}}, {pixel(point, 1), {}}});
    return images;
}

double distance(const pointline::Solution& solution) {
    double largest = 0;
    for (std::size_t v = 0; v < solution.cameras.size(); ++v) {
        for (std::size_t i = 0; i < 9; ++i)
            largest = std::max(largest, std::abs(solution.cameras[v].R[i] - cameras[v].R[i]));
        for (std::size_t i = 0; i < 3; ++i)
            largest = std::max(largest, std::abs(solution.cameras[v].t[i] - cameras[v].t[i]));
    }
    return largest;
}

double distance(const pointline::Answer& answer) {
    double least = std::numeric_limits<double>::infinity();
    for (const pointline::Solution& solution : answer.solutions)
        least = std::min(least, distance(solution));
    return least;
}

/// The one solver for all tests here.
const pointline::Solver& cleveland_solver() {
    static const auto solver = pointline::Solver::make("3*P/P/P + a/a/a");
    REQUIRE(solver);
    return *solver;
}

pointline::Failure failure_of(const pointline::Images& images) {
    const auto answer = cleveland_solver().solve(images);
    REQUIRE(!answer);
    CHECK(!answer.error().message.empty());
    return answer.error().failure;
}

} // namespace

TEST_CASE("the true cameras are among the answers, in three views and in two") {
    CHECK(cleveland_solver().degree() == 216);
    CHECK(cleveland_solver().problem() == "3*P/P/P + a/a/a");
    const auto answer = cleveland_solver().solve(cleveland());
    REQUIRE(answer);
    CHECK(answer->found == 216);
    CHECK(answer->complete == pointline::Complete::certified);
    CHECK(distance(*answer) < 1e-8);
    const auto five = pointline::Solver::make("5*P/P");
    REQUIRE(five);
    const auto pose = five->solve(five_points(), {.quick = false, .conditions = true});
    REQUIRE(pose);
    CHECK(pose->found == 20);
    CHECK(distance(*pose) < 1e-8);
    for (const pointline::Solution& solution : pose->solutions)
        CHECK(solution.condition > 1);
}

TEST_CASE("the scene of the true cameras is the true one") {
    const auto answer = cleveland_solver().solve(cleveland());
    REQUIRE(answer);
    for (const pointline::Solution& solution : answer->solutions) {
        if (distance(solution) > 1e-6) continue;
        CHECK(solution.in_front == 3);
        CHECK(solution.residual < 1e-6);
        for (std::size_t f = 0; f < 3; ++f)
            for (std::size_t i = 0; i < 3; ++i)
                CHECK((*solution.points[f])[i] == doctest::Approx(points[f][i]));
        CHECK(!solution.points[3]);
        CHECK(solution.lines[3].at('a'));
    }
}

TEST_CASE("a quick solver finds the true cameras, too") {
    const auto answer = cleveland_solver().solve(cleveland(), {.quick = true});
    REQUIRE(answer);
    CHECK(answer->found > 150);
    CHECK(distance(*answer) < 1e-8);
}

TEST_CASE("several threads find what one finds") {
    std::vector<pointline::Images> instances(6, cleveland());
    for (std::size_t i = 0; i < instances.size(); ++i)
        (*instances[i].features[0][1].point)[0] += 0.01 * static_cast<double>(i);
    (*instances[4].features[0][0].point)[0] = std::numeric_limits<double>::quiet_NaN();
    const auto answers = cleveland_solver().solve(instances, {.quick = true}, 3);
    REQUIRE(answers.size() == instances.size());
    CHECK(!answers[4]);
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const auto alone = cleveland_solver().solve(instances[i], {.quick = true});
        REQUIRE(static_cast<bool>(alone) == static_cast<bool>(answers[i]));
        if (!alone) continue;
        REQUIRE(alone->solutions.size() == answers[i]->solutions.size());
        for (std::size_t k = 0; k < alone->solutions.size(); ++k)
            CHECK(alone->solutions[k].cameras[1].R == answers[i]->solutions[k].cameras[1].R);
    }
}

TEST_CASE("a line that misses its point is moved") {
    auto solver = pointline::Solver::make("5*P/P + Pa/Pa");
    CHECK(!solver); // six points
    solver = pointline::Solver::make("4*P/P + Pa/Pa");
    REQUIRE(solver);
    pointline::Images images = five_points();
    for (std::size_t v = 0; v < 2; ++v) {
        const pointline::Point at = *images.features[4][v].point;
        images.features[4][v].lines['a'] =
            pointline::line_through({at[0] + 3, at[1] + 4}, {at[0] + 60, at[1] - 80});
    }
    const auto answer = solver->solve(images);
    REQUIRE(answer);
    CHECK(answer->moved > 0.1);
    CHECK(answer->moved < 5);
}

TEST_CASE("what goes wrong is a value, not an exception") {
    using pointline::Failure;
    CHECK(pointline::Solver::make("what").error().failure == Failure::bad_problem);
    CHECK(pointline::Solver::make("P/P/P").error().failure == Failure::bad_problem);
    CHECK(pointline::Solver::load("2394", "/no/such/file").error().failure == Failure::system);
    const auto file = std::filesystem::temp_directory_path() / "pointline-no-start";
    std::ofstream(file) << "no start\n";
    CHECK(pointline::Solver::load("2394", file).error().failure == Failure::bad_start);
    std::filesystem::remove(file);
    const pointline::Images good = cleveland();
    pointline::Images bad = good;
    bad.features.pop_back();
    CHECK(failure_of(bad) == Failure::bad_images);
    bad = good;
    bad.features[1].pop_back();
    CHECK(failure_of(bad) == Failure::bad_images);
    bad = good;
    bad.features[1][2].point.reset();
    CHECK(failure_of(bad) == Failure::bad_images);
    bad = good;
    bad.features[3][0].point = {1, 2};
    CHECK(failure_of(bad) == Failure::bad_images);
    bad = good;
    bad.features[3][0].lines['b'] = {{1, 2, 3}, {}};
    CHECK(failure_of(bad) == Failure::bad_images);
    bad = good;
    bad.features[3][0].lines['a'] = {{0, 0, 3}, {}};
    CHECK(failure_of(bad) == Failure::bad_images);
    bad = good;
    bad.features[0][0].point = bad.features[1][0].point;
    CHECK(failure_of(bad) == Failure::bad_images);
    bad = good;
    bad.cameras[1].fy = 0;
    CHECK(failure_of(bad) == Failure::bad_images);
    bad = good;
    bad.cameras.pop_back();
    CHECK(failure_of(bad) == Failure::bad_images);
}

TEST_CASE("a problem is described") {
    const auto chicago = pointline::problem("2394");
    REQUIRE(chicago);
    CHECK(chicago->notation == "2*Pa/Pa/Pa + P/P/P");
    CHECK(chicago->verdict == "minimal");
    CHECK(chicago->degree == 312);
    CHECK(chicago->views == 3);
    CHECK(chicago->picture.find("<svg") != std::string::npos);
    CHECK(chicago->lines == std::vector<std::string>{"a", "a", ""});
    CHECK(pointline::problem("5*P/P")->degree == 20);
    CHECK(!pointline::problem("P/P/P")->degree);
    CHECK(!pointline::problem("nothing"));
}

TEST_CASE("problems in general are solved as others are: a line through three points") {
    const auto described = pointline::problem("3*PL/PL/PL + P/P/P");
    REQUIRE(described);
    CHECK(described->verdict == "minimal");
    CHECK(described->degree == 64);
    CHECK(described->calibrated);
    CHECK(described->lines == std::vector<std::string>{"", "", "", ""});
    const auto solver = pointline::Solver::make("3*PL/PL/PL + P/P/P");
    REQUIRE(solver);
    CHECK(solver->degree() == 64);
    pointline::Images images{{K, K, K}, {}};
    for (const Vector& point :
         {points[0], points[1], between(points[0], points[1], 0.3), points[2]}) {
        auto& views = images.features.emplace_back();
        for (std::size_t v = 0; v < 3; ++v)
            views.push_back({pixel(point, v), {}});
    }
    const auto answer = solver->solve(images);
    REQUIRE(answer);
    CHECK(answer->found == 64);
    CHECK(answer->complete == pointline::Complete::certified);
    CHECK(answer->moved < 1e-9);
    double least = 1;
    for (const pointline::Solution& solution : answer->solutions)
        least = std::min(least, distance(solution));
    CHECK(least < 1e-6);
    // What the points show must not be given.
    images.features[0][1].lines['a'] = pointline::line_through({1, 2}, {3, 4});
    const auto refused = solver->solve(images);
    REQUIRE(!refused);
    CHECK(refused.error().message == "feature 1, view 2: there is no line a: leave it out");
}
