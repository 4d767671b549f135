// The pencil of the trace test in six views, on some of the solutions. The whole test, on all of
// them, is tests/families/six_views_trace.cpp.
#include "tests/families/pencil_trace.h"

#include "prover/many_views/monodromy.h"
#include "prover/many_views/path.h"
#include "prover/problem/notation.h"

#include <Eigen/LU>
#include <doctest/doctest.h>

using namespace plprove;
using namespace plprove::many_views;

namespace {

using Vector3 = Eigen::Vector3cd;

const Complex later(0.3, -0.4);

/// Some solutions of 1021_1.
const MonodromyResult& some_solutions() {
    static const MonodromyResult result = [] {
        MonodromySettings settings;
        settings.most_solutions = 40;
        return run_monodromy(parse_problem("Pa/Pa/Pa/Pa/Pa/Pa + 2*a/a/a/a/a/a"), 1, settings);
    }();
    return result;
}

ImagesInPencil pencil_of(const MonodromyResult& found) {
    Random random(1, 1);
    return {found.system, found.images, random};
}

Vector3 vector(const Vector<Complex>& x) {
    return {x[0], x[1], x[2]};
}

Complex determinant(const Vector3& a, const Vector3& b, const Vector3& c) {
    Eigen::Matrix3cd matrix;
    matrix << a, b, c;
    return matrix.determinant();
}

/// m·x : n·x, where m and n are the free lines that the last view sees.
Complex ratio(const MonodromyResult& found, const Images<Complex>& images) {
    const ViewImages<Complex>& view = images.back();
    std::vector<Complex> products;
    for (std::size_t line = 0; line < view.lines.size(); ++line)
        if (found.system.problem().lines[line].points.empty())
            products.push_back(determinant(vector(view.lines[line][0]), vector(view.lines[line][1]),
                                           vector(view.points[0])));
    REQUIRE(products.size() == 2);
    return products[0] / products[1];
}

} // namespace

TEST_CASE("the images of the pencil start at those given, and keep the ratio of the heights") {
    const MonodromyResult& found = some_solutions();
    const ImagesInPencil pencil = pencil_of(found);
    const Complex at_start = ratio(found, found.images);
    for (const Complex& t : {Complex(0), later, Complex(-5, 2)}) {
        CHECK(std::abs(ratio(found, pencil.at(t)) - at_start) < 1e-9 * std::abs(at_start));
        const Vector3 x = vector(pencil.at(t).back().points[0]);
        CHECK(std::abs((pencil.line_at(t).transpose() * x).value()) < 1e-12 * x.norm());
    }
    const Vector3 x = vector(found.images.back().points[0]);
    const Vector3 same = vector(pencil.at(0).back().points[0]); // up to a factor
    CHECK((x * (same[0] / x[0]) - same).norm() < 1e-9 * same.norm());
}

TEST_CASE("at any time the view sees the direction of the line on the line of the pencil") {
    const MonodromyResult& found = some_solutions();
    const ImagesInPencil pencil = pencil_of(found);
    const auto ends =
        follow_all(found.system, pencil.at(0), pencil.at(later), found.points, Care::careful, 2);
    int followed = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (!ends[i]) continue;
        ++followed;
        const Vector3 before = pencil.direction(found.points[i]),
                      after = pencil.direction(*ends[i]);
        const auto height = [](const Vector3& line, const Vector3& z) {
            return std::abs((line.transpose() * z).value()) / (line.norm() * z.norm());
        };
        CHECK(height(pencil.line_at(0), before) < 1e-7);
        CHECK(height(pencil.line_at(later), after) < 1e-7);
        CHECK(height(pencil.line_at(later), before) > 1e-5);
    }
    CHECK(followed >= 40);
}

TEST_CASE("the sum over some of the solutions is not linear") {
    const MonodromyResult& found = some_solutions();
    const PencilTrace trace = trace_in_pencil(found.system, found.images, found.points, 1, 2);
    CHECK(trace.solutions + trace.lost == static_cast<int>(found.points.size()));
    CHECK(trace.solutions >= 40);
    CHECK(trace.if_one_missing > 0);
    CHECK(trace.difference > trace.if_one_missing / 1000);
}
