// Three points that all views see (proofs/upper_bounds.md, section 10): the numbers of Theorem U15
// from the special points of the surface, and what is said of the boundary, at random images.
#include "checker/algebra/vector3.h"
#include "prover/degree/degree.h"
#include "tests/support/class_with_bound.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <random>
#include <string_view>
#include <vector>

using namespace plprove;

namespace {

constexpr std::size_t curves = 4; // C_0, C_1, C_2, C_3

/// A special point of the surface, up to a common sign of its coordinates.
struct SpecialPoint {
    std::size_t over = 0;               // which p_i
    std::array<bool, 3> special{};      // in which views
    std::array<int, curves> branches{}; // how often the curves C_j meet the exceptional curve
    int degree = 0;                     // of the exceptional curve
};

/// The C_j on which signs are as these.
std::size_t curve(const std::array<int, 3>& signs) {
    for (std::size_t v = 0; v < 3; ++v)
        if (signs[v] != signs[(v + 1) % 3] && signs[v] != signs[(v + 2) % 3]) return v + 1;
    return 0;
}

/// All of them, each twice, with both common signs. Over p_i a view has two special points, and
/// four more, two of each sign.
std::vector<SpecialPoint> twice_the_special_points() {
    std::vector<SpecialPoint> points;
    for (std::size_t n = 0; n < 3 * 6 * 6 * 6; ++n) {
        SpecialPoint point{.over = n % 3};
        std::array<std::vector<int>, 3> signs; // that branches of H = 0 may have
        for (std::size_t v = 0, rest = n / 3; v < 3; ++v, rest /= 6) {
            point.special[v] = rest % 6 < 2;
            signs[v] = point.special[v] ? std::vector{1, -1} : std::vector{rest % 2 == 0 ? 1 : -1};
        }
        const auto views = std::count(point.special.begin(), point.special.end(), true);
        if (views == 0) continue;
        point.degree = 1 << (views - 1);
        for (const int a : signs[0])
            for (const int b : signs[1])
                for (const int c : signs[2])
                    ++point.branches[curve({a, b, c})];
        points.push_back(point);
    }
    return points;
}

/// A condition on cameras: how many sections of each view are in its determinant, whether it is a
/// pin, and of which point; and the curves on which it vanishes.
struct Condition {
    std::array<int, 3> sections{1, 1, 1};
    int pinned = -1;
    std::array<bool, curves> vanishes{true, false, false, false};
};

Condition pin(int point) {
    return {.pinned = point};
}

Condition seen_by_two(std::size_t other) {
    Condition condition{{2, 2, 2}, -1, {true, false, false, false}};
    condition.sections[other] = 0;
    condition.vanishes[other + 1] = true;
    return condition;
}

Condition seen_by_one(std::size_t view) {
    Condition condition;
    condition.sections[view] = 2;
    return condition;
}

/// How many of these sections, by view, are of views in which the point is special.
int special_sections(const std::array<int, 3>& sections, const SpecialPoint& point) {
    int sum = 0;
    for (std::size_t v = 0; v < 3; ++v)
        if (point.special[v]) sum += sections[v];
    return sum;
}

/// To which order the determinant vanishes on the exceptional curve, at least.
int order(const Condition& condition, const SpecialPoint& point) {
    const int sections = special_sections(condition.sections, point);
    if (condition.pinned == static_cast<int>(point.over)) return sections;
    int least = std::max(sections - 1, 0), branches = 0;
    for (std::size_t j = 0; j < curves; ++j)
        if (condition.vanishes[j]) branches += point.branches[j];
    return point.degree == 1 ? std::max(least, branches) : least;
}

/// a h - sum of b_j C_j - sum of m E
struct Divisor {
    int h = 0;
    std::array<int, curves> c{};
    std::vector<int> e{}; // by special point, twice
};

Divisor divisor(const Condition& condition, const std::vector<SpecialPoint>& points) {
    Divisor result{.h = condition.pinned < 0 ? 5 : 4};
    for (std::size_t j = 0; j < curves; ++j)
        result.c[j] = condition.vanishes[j];
    for (const SpecialPoint& point : points)
        result.e.push_back(order(condition, point));
    return result;
}

/// The intersection number. h . h = 64, h . C_j = 64, and the C_j do not meet.
int product(const Divisor& a, const Divisor& b, const std::vector<SpecialPoint>& points) {
    int number = 64 * a.h * b.h, doubled = 0;
    std::array<int, curves> met{}; // twice the sum of C_j . E
    for (std::size_t n = 0; n < points.size(); ++n) {
        doubled -= a.e[n] * b.e[n] * points[n].degree;
        for (std::size_t j = 0; j < curves; ++j) {
            doubled += (a.c[j] * b.e[n] + b.c[j] * a.e[n]) * points[n].branches[j];
            met[j] += points[n].branches[j];
        }
    }
    for (std::size_t j = 0; j < curves; ++j) {
        const int square = 4 * 64 - met[j]; // as 4 h is the sum of all C_j and of all E twice
        CHECK(square == -80);
        number += a.c[j] * b.c[j] * square - 64 * (a.h * b.c[j] + b.h * a.c[j]);
    }
    CHECK(doubled % 2 == 0);
    return number + doubled / 2;
}

} // namespace

TEST_CASE("three points: degrees are products of divisors, and found by monodromy") {
    const auto points = twice_the_special_points();
    CHECK(points.size() == 2 * 3 * (3 * 16 + 3 * 8 + 4));
    struct Problem {
        Condition first, second;
        Features features;
        int degree; // the bound of Theorem U15
    };
    const std::array problems{
        Problem{pin(0), pin(0), {{"Pab/Pab/Pab", 1}, {"P/P/P", 2}}, 224},
        Problem{pin(0), pin(1), {{"Pa/Pa/Pa", 2}, {"P/P/P", 1}}, 312},
        Problem{pin(0), seen_by_two(0), {{"Pa/Pa/Pa", 1}, {"P/P/P", 2}, {"-/P/P", 1}}, 304},
        Problem{pin(0), seen_by_one(0), {{"Pa/Pa/Pa", 1}, {"P/P/P", 2}, {"P/a/a", 1}}, 376},
        Problem{seen_by_two(0), seen_by_two(1), {{"P/P/P", 3}, {"-/P/P", 1}, {"P/-/P", 1}}, 384},
        Problem{seen_by_two(0), seen_by_one(0), {{"P/P/P", 3}, {"-/P/P", 1}, {"P/a/a", 1}}, 464},
        Problem{seen_by_two(0), seen_by_one(1), {{"P/P/P", 3}, {"-/P/P", 1}, {"a/P/a", 1}}, 368},
        Problem{seen_by_one(0), seen_by_one(0), {{"P/P/P", 3}, {"P/a/a", 2}}, 448},
        Problem{seen_by_one(0), seen_by_one(1), {{"P/P/P", 3}, {"P/a/a", 1}, {"a/P/a", 1}}, 520}};
    for (const Problem& problem : problems) {
        const std::size_t number = class_with_bound(problem.features, problem.degree);
        CAPTURE(number);
        const Divisor a = divisor(problem.first, points), b = divisor(problem.second, points);
        CHECK(product(a, b, points) == problem.degree);
        for (const Divisor& factor : {a, b}) // curves of the boundary do no harm (Lemma U16)
            for (std::size_t j = 0; j < curves; ++j) {
                Divisor boundary{.h = 0, .c = {}, .e = std::vector<int>(points.size())};
                boundary.c[j] = -1;
                CHECK(product(factor, boundary, points) >= 0);
            }
        for (const Divisor& factor : {a, b})
            for (std::size_t n = 0; n < points.size(); ++n) {
                int met = factor.e[n] * points[n].degree;
                for (std::size_t j = 0; j < curves; ++j)
                    met -= factor.c[j] * points[n].branches[j];
                CHECK(met >= 0);
            }
        const DegreeRun run = compute_degree(number, {});
        CHECK(run.degree == problem.degree);
    }
    // Features that are exchanged for P/a/a have its bound.
    class_with_bound({{"P/P/P", 3}, {"P/a/a", 1}, {"b/Pab/a", 1}}, 520);
    class_with_bound({{"Pa/Pa/Pa", 1}, {"P/P/P", 2}, {"b/a/Pab", 1}}, 376);
    // An extension of the five-point problem: 20 relative poses, 8 registrations.
    const Divisor twice = divisor(seen_by_two(0), points);
    CHECK(product(twice, twice, points) == 20 * 8);
}

TEST_CASE("three points: Chern classes of a line, and of a point with a pin") {
    int line = 2 * 384, point = 2 * 568, spurious = 2 * 128;
    for (const SpecialPoint& p : twice_the_special_points()) {
        const int c = p.branches[0], e = -p.degree;
        if (p.special[0]) spurious -= p.branches[1]; // zeros of l_1 . N_1 on C_1
        if (p.degree == 1) continue;                 // special in one view
        const int r = special_sections({1, 1, 1}, p) - 1, s = special_sections({1, 2, 2}, p) - 1;
        line += r * c + r * (r + 1) / 2 * e;
        point += s * c + s * (s - 1) / 2 * e;
    }
    CHECK(line == 2 * 216);
    CHECK(point == 2 * 304);
    CHECK(spurious == 2 * 32);
    const auto degree = [](std::string_view feature, int bound) {
        return compute_degree(class_with_bound({{"P/P/P", 3}, {feature, 1}}, bound), {}).degree;
    };
    CHECK(degree("a/a/a", 216) == 216);
    CHECK(degree("a/P/Pa", 304 - 32) == 304 - 32);
}

TEST_CASE("three points: where H = 0, N is plus or minus i (t e + s e')") {
    using Complex = std::complex<double>;
    using Vector = checker::Vector3<Complex>;
    using checker::cross, checker::dot;
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    const auto number = [&] { return Complex(normal(random), normal(random)); };
    for (int trial = 0; trial < 20; ++trial) {
        std::array<Vector, 3> x, normals;
        for (Vector& image : x)
            image = {number(), number(), number()};
        for (std::size_t i = 0; i < 3; ++i)
            normals[i] = cross(x[(i + 1) % 3], x[(i + 2) % 3]);
        // A point 1/lambda of the conic on which the sum of these is isotropic.
        const Complex first = number(), second = number();
        Vector sum{};
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] = first * normals[0][k] + second * normals[1][k];
        const Complex a = dot(normals[2], normals[2]), b = dot(sum, normals[2]);
        const Complex third = (-b + std::sqrt(b * b - a * dot(sum, sum))) / a;
        const std::array factors{1.0 / first, 1.0 / second, 1.0 / third};
        std::array<int, 2> signs{};
        for (const int turned : {0, 1}) { // for lambda and for -lambda
            std::array<Vector, 3> u = x;
            for (std::size_t i = 0; i < 3; ++i)
                for (Complex& entry : u[i])
                    entry *= turned == 0 ? factors[i] : -factors[i];
            const Vector e = checker::minus(u[1], u[0]), f = checker::minus(u[2], u[0]);
            // The same s and t for both: those of the first.
            const Complex s = std::sqrt(dot(e, e)), t = -dot(e, f) / s;
            const Vector n = cross(e, f);
            std::array<double, 2> apart{}; // from i k and from -i k
            double size = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const Complex ik = Complex(0, 1) * (t * e[k] + s * f[k]);
                apart[0] += std::abs(n[k] - ik);
                apart[1] += std::abs(n[k] + ik);
                size += std::abs(n[k]);
            }
            CHECK(std::min(apart[0], apart[1]) < 1e-8 * size);
            signs[static_cast<std::size_t>(turned)] = apart[0] < apart[1] ? 1 : -1;
        }
        CHECK(signs[0] == -signs[1]);
    }
}
