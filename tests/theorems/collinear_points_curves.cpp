// The curves of Theorem M (proofs/collinear_points_curves.md, sections 7 and 8) by second methods:
// scenes with known cameras are on them, and they have the degrees and double points of the page.
#include "proofs/computations/plane_curves.h"
#include "proofs/computations/three_pin_curves.h"

#include <doctest/doctest.h>

#include <array>
#include <functional>
#include <vector>

using namespace proofs;

TEST_CASE("collinear points, four views: the center of a scene is on four curves of degree 7") {
    Numbers random(9);
    const auto pins = eight_pins(random);
    std::vector<EightImages> views(4);
    for (EightImages& t : views) {
        const Camera camera = random_camera(random);
        for (std::size_t j = 0; j < t.size(); ++j)
            t[j] = camera.image(pins[j]);
    }
    for (const Residue value : curves_at(views, center_of(pins)))
        CHECK(value == Residue{});
    // They have degree 7: values at 46 points fit with monomials at most in the four known ways.
    Matrix values;
    for (int n = 0; n < 46; ++n) {
        const Pair o = random.pair();
        values.push_back(ternary_monomials({o[0], o[1], Residue{1}}, 7));
        for (const Residue value : curves_at(views, o))
            values.back().push_back(value);
    }
    CHECK(kernel_of(values, 36 + 4).size() == 4);
    // All conditions of the scene, too, leave 33: it has nine solutions and eight double points.
    for (const std::size_t degree : std::array<std::size_t, 2>{11, 13})
        CHECK(rank_of_multiples(views, degree, random) == (degree + 1) * (degree + 2) / 2 - 33);
}

TEST_CASE("collinear points, four views and a free line: a scene is on four curves") {
    Numbers random(10);
    const Residue zero{}, one{1};
    std::vector<Pin> pins{
        {2, random(), {one, zero}}, {2, random(), {zero, one}}, {2, random(), {one, one}}};
    for (int n = 0; n < 3; ++n)
        pins.push_back({1, random(), {random(), one}});
    std::vector<ThreePinImage> views;
    for (int view = 0; view < 4; ++view) {
        const Pair a = random.pair();
        const Camera camera = random_camera_of_line(a, random);
        std::array<Residue, 6> t{};
        for (std::size_t j = 0; j < t.size(); ++j)
            t[j] = camera.image(pins[j]);
        views.push_back(three_pin_image(a, t));
    }
    const Pair x{pins[3].w[0], pins[4].w[0]};
    for (const Residue value : three_pin_curves(views, x))
        CHECK(value == Residue{});
    // The unknowns of the scene solve the equations: s_1, s_2, sigma, and s_4, s_5.
    const Matrix rows = equations(views, x);
    const Vector k = kernel_of(rows, 9).at(0); // with s_5 = 1
    const Residue scale = pins[4].s;
    CHECK(scale * k[0] == pins[0].s);
    CHECK(scale * k[1] == pins[1].s);
    CHECK(scale * k[2] == pins[0].s + pins[1].s - pins[2].s);
    CHECK(scale * k[7] == pins[3].s);
    // The curves have bidegree (5, 5), and with this scene, too, 37 conditions are left.
    Matrix values;
    for (int n = 0; n < 48; ++n) {
        const Pair point = random.pair();
        values.push_back(box_monomials(point, 5, 5));
        for (const Residue value : three_pin_curves(views, point))
            values.back().push_back(value);
    }
    CHECK(kernel_of(values, 36 + 4).size() == 4);
    for (const std::size_t degree : std::array<std::size_t, 2>{8, 10})
        CHECK(rank_with(views, degree, 2, random) == (degree + 1) * (degree + 1) - 37);
}

namespace {

/// Whether a function on a line is a polynomial of at most this degree, and has exactly this order
/// at the parameter 1.
bool has_order(std::size_t order, std::size_t degree,
               const std::function<Residue(Residue)>& on_line) {
    const Polynomial f = interpolate(degree, on_line); // takes no value at 1
    if (!(value(f, Residue{1000}) == on_line(Residue{1000}))) return false;
    Polynomial power(Residue{1});
    for (std::size_t n = 0; n < order; ++n)
        power = power * Polynomial(std::vector{-Residue{1}, Residue{1}});
    if (!trimmed(remainder(f, power)).coefficients.empty()) return false;
    power = power * Polynomial(std::vector{-Residue{1}, Residue{1}});
    return !trimmed(remainder(f, power)).coefficients.empty();
}

Residue power(Residue x, std::size_t exponent) {
    Residue result{1};
    for (std::size_t n = 0; n < exponent; ++n)
        result = result * x;
    return result;
}

/// The order of curve n at (x : 1), or at (1 : x) for x at infinity, as a form of bidegree (5, 5).
bool has_order(std::size_t order, const std::vector<ThreePinImage>& views, std::size_t n,
               const Pair& x, bool at_infinity, Numbers& random) {
    const Pair direction = random.pair();
    return has_order(order, 10, [&](Residue s) {
        const Residue step = s - Residue{1};
        const Pair y{x[0] + step * direction[0], x[1] + step * direction[1]};
        if (!at_infinity) return three_pin_curves(views, y)[n];
        const Pair inverse{y[0].inverse(), y[1].inverse()};
        return three_pin_curves(views, inverse)[n] * power(y[0] * y[1], 5);
    });
}

} // namespace

TEST_CASE("collinear points, four views: the four curves have order 2 at the eight points") {
    Numbers random(11);
    std::vector<EightImages> views(4);
    const Residue zero{}, one{1};
    std::vector<std::array<Residue, 3>> points{
        {one, zero, zero}, {zero, one, zero}, {zero, zero, one}, {one, one, one}};
    for (EightImages& t : views) {
        for (Residue& number : t)
            number = random();
        points.push_back({t[0] - t[3], t[1] - t[3], t[2] - t[3]});
    }
    for (const auto& point : points) {
        const std::array<Residue, 3> direction{random(), random(), random()};
        for (std::size_t n = 0; n < 4; ++n)
            CHECK(has_order(2, 7, [&](Residue s) {
                std::array<Residue, 3> x = point;
                for (std::size_t i = 0; i < 3; ++i)
                    x[i] = x[i] + (s - one) * direction[i];
                const Residue scale = x[2].inverse();
                return curves_at(views, {x[0] * scale, x[1] * scale})[n] * power(x[2], 7);
            }));
    }
}

TEST_CASE("collinear points, four views and a free line: the orders of the four curves") {
    Numbers random(12);
    const Residue zero{}, one{1};
    std::vector<ThreePinImage> views;
    for (int view = 0; view < 4; ++view)
        views.push_back(three_pin_image(
            random.pair(), {random(), random(), random(), random(), random(), random()}));
    for (std::size_t n = 0; n < 4; ++n) {
        CHECK(has_order(2, views, n, {zero, zero}, false, random));
        CHECK(has_order(2, views, n, {one, one}, false, random));
        CHECK(has_order(2, views, n, {zero, zero}, true, random));
        for (std::size_t v = 0; v < 4; ++v) // curve n leaves out view n
            CHECK(has_order(v == n ? 2 : 1, views, n, zero_of_view(views[v]), false, random));
    }
}
