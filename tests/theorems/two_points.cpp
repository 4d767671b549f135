// Two points that all views see, and a line (proofs/two_points.md): the bounds of Theorem U17
// beside the degrees by monodromy, and the frames of its proof at random images. What the proof
// needs computed is a program of its own, proofs/computations/two_points.cpp, which is a test, too.
#include "checker/algebra/vector3.h"
#include "proofs/computations/intersection_numbers.h"
#include "prover/degree/degree.h"
#include "tests/support/class_with_bound.h"

#include <doctest/doctest.h>

#include <complex>
#include <random>

using namespace plprove;

TEST_CASE("two points: the bounds are intersection numbers less zeros that are no elements") {
    const auto [pin, by_two, by_one] = proofs::intersection_numbers();
    CHECK(pin == 672);
    CHECK(by_two == 704);
    CHECK(by_one == 800);
    const auto degree = [](const Features& features, int bound) {
        return compute_degree(class_with_bound(features, bound), {}).degree;
    };
    constexpr int escaping = 8 * 12, centred = 8 * 6, coplanar = 8 * 4;
    const int with_pin = (pin - escaping - centred) / 2;
    const int with_two = (by_two - escaping - 2 * centred) / 2;
    const int with_one = (by_one - escaping - 2 * centred) / 2;
    const int with_pinned = (by_two - escaping - 2 * centred - coplanar) / 2;
    CHECK(degree({{"Pa/Pa/Pa", 1}, {"P/P/P", 1}, {"a/a/a", 2}}, with_pin) == with_pin);
    CHECK(degree({{"P/P/P", 2}, {"a/a/a", 2}, {"-/P/P", 1}}, with_two) == with_two);
    CHECK(degree({{"P/P/P", 2}, {"a/a/a", 2}, {"P/a/a", 1}}, with_one) == with_one);
    CHECK(degree({{"P/P/P", 2}, {"a/Pa/Pa", 1}, {"a/a/a", 1}}, with_pinned) == with_pinned);
    class_with_bound({{"P/P/P", 2}, {"a/a/a", 2}, {"Pab/b/a", 1}}, with_one); // exchanged
}

TEST_CASE("two points: frames of the plane that their images span") {
    using Complex = std::complex<double>;
    using Vector = checker::Vector3<Complex>;
    using checker::cross, checker::dot, checker::minus, checker::times;
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    const auto number = [&] { return Complex(normal(random), normal(random)); };
    const auto near = [](Complex a, double b) { return std::abs(a - b) < 1e-9; };
    for (int trial = 0; trial < 20; ++trial) {
        const Vector x{number(), number(), number()}, y{number(), number(), number()};
        const Complex root =
            std::sqrt(dot(x, y) * dot(x, y) - dot(x, x) * dot(y, y)); // of x + r y isotropic
        const Vector first = minus(x, times((dot(x, y) + root) / dot(y, y), y));
        const Vector second = minus(x, times((dot(x, y) - root) / dot(y, y), y));
        const Vector beta = times(0.5 / dot(first, second), second);
        const Vector n = times(Complex(0, 2), cross(first, beta));
        const Complex t = number();
        const Vector e = minus(times(t, first), times(-1.0 / t, beta));
        const Vector f = minus(times(t, first), times(1.0 / t, beta));
        const Vector plus = minus(f, times(Complex(-1), n)), less = minus(f, n);
        CHECK(near(dot(e, e), 1));
        for (const Vector& isotropic : {plus, less}) {
            CHECK(near(dot(isotropic, isotropic), 0));
            CHECK(near(dot(isotropic, e), 0));
        }
        CHECK(near(dot(plus, less), -2));
        CHECK(near(dot(e, cross(plus, less)) * Complex(0, 1), 2));
        const Vector l{number(), number(), number()};
        CHECK(near(dot(l, l) - dot(l, e) * dot(l, e) + dot(l, plus) * dot(l, less), 0)); // (7)
    }
}
