// Theorem M (proofs/collinear_points_more_views.md, and section 6 of collinear_points_curves.md) by
// second methods: scenes with known cameras are zeros of its equations, and eliminants count the
// zeros of random images. Modulo 2^61 - 1.
#include "proofs/computations/scroll_quadrics.h"
#include "proofs/computations/star_equations.h"

#include <doctest/doctest.h>

#include <array>
#include <functional>
#include <vector>

using namespace proofs;

namespace {

const Residue one{1};

/// Pins of X_3 at (1, 0), (0, 1), (1, 1) and, if asked for, (z, 1).
std::vector<Pin> star(bool with_fourth, Numbers& random) {
    std::vector<Pin> pins{{2, random(), {one, Residue{}}},
                          {2, random(), {Residue{}, one}},
                          {2, random(), {one, one}}};
    if (with_fourth) pins.push_back({2, random(), {random(), one}});
    return pins;
}

Residue sigma(const std::vector<Pin>& pins) {
    return pins[0].s + pins[1].s - pins[2].s;
}

StarPoint<Residue> star_point(const std::vector<Pin>& pins) {
    const Residue z = pins[3].w[0];
    return {{z, one}, {sigma(pins), z * pins[0].s + pins[1].s - pins[3].s}};
}

/// What a row gives for a vector.
Residue times(const std::vector<Residue>& row, const std::vector<Residue>& vector) {
    Residue sum;
    for (std::size_t i = 0; i < row.size(); ++i)
        sum = sum + row[i] * vector[i];
    return sum;
}

std::array<Residue, 4> images(const std::vector<Pin>& pins, const Camera& camera) {
    std::array<Residue, 4> t{};
    for (std::size_t j = 0; j < pins.size(); ++j)
        t[j] = camera.image(pins[j]);
    return t;
}

/// r of section 4.
Residue r(const std::vector<Pin>& pins, const Pin& other) {
    return other.w[0] * pins[0].s + pins[1].s;
}

const Polynomial variable(std::vector{Residue{}, one});

/// f without the root x, which has to be simple.
Polynomial without(const Polynomial& f, Residue x) {
    CHECK(value(f, x) == Residue{});
    Polynomial quotient(std::vector<Residue>(degree(f)));
    Residue carry;
    for (std::size_t i = degree(f); i > 0; --i)
        quotient.coefficients[i - 1] = carry = carry * x + f[i];
    CHECK(!(value(quotient, x) == Residue{}));
    return quotient;
}

using Rows = std::vector<std::vector<Polynomial>>;

/// The minor without row `left_out`.
Polynomial minor(Rows rows, std::size_t left_out) {
    rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(left_out));
    return laplace(rows);
}

/// Where a matrix has not full rank: the first coordinates of these points of P^1 x P^1, by the
/// resultants of minors in the second coordinate.
Polynomial eliminant(const std::function<Rows(Residue)>& rows, std::size_t first,
                     std::size_t second, std::size_t views) {
    const auto common = [&](std::size_t a, std::size_t b) {
        return interpolate(2 * first * second, [&](Residue x) {
            return resultant(minor(rows(x), a), minor(rows(x), b), second);
        });
    };
    // No row is in all six minors: a point where it is 0 would be a zero of all.
    return gcd(gcd(common(0, 1), common(2, 3)), common(views - 2, views - 1));
}

StarPoint<Polynomial> at_z(Residue z) {
    return {{Polynomial(z), Polynomial(one)}, {variable, Polynomial(one)}};
}

std::array<Residue, 4> four(Numbers& random) {
    return {random(), random(), random(), random()};
}

} // namespace

TEST_CASE("collinear points, four views: scenes are zeros of both determinants") {
    Numbers random(1);
    for (const std::size_t last : std::array<std::size_t, 2>{0, 1}) {
        const auto pins = star(true, random);
        const std::array others{Pin{1, random(), {random(), one}},
                                Pin{last, random(), {random(), one}}};
        for (int view = 0; view < 4; ++view) {
            const Pair a = random.pair();
            const Camera camera = random_camera_of_line(a, random);
            for (const Pin& pin : others) {
                const StarImage y =
                    with_pin(images(pins, camera), other_pin(a, pin.point, camera.image(pin)));
                CHECK(!(delta(y, star_point(pins)) == Residue{}));
                CHECK(times(row(y, star_point(pins)), {pin.s, -r(pins, pin), pin.w[0], one}) ==
                      Residue{});
            }
        }
    }
}

TEST_CASE("collinear points, five views: scenes have a matrix of small rank") {
    Numbers random(2);
    auto pins = star(true, random);
    pins[3].s = {};
    const Pin fifth{1, {}, {random(), one}};
    const Pair direction = random.pair(); // of the pin of P: (direction, w_5)
    for (int view = 0; view < 5; ++view) {
        const Camera camera = random_camera(random);
        const Pair image = camera.apply(pins[3].w), ray = camera.apply(fifth.w);
        const Residue scale = dot(camera.c, pins[3].w).inverse();
        const Pair xi{image[0] * scale, image[1] * scale};
        std::array<Residue, 2> incidences{}; // of phi_2 and phi_3 in place of eta
        for (const std::size_t n : std::array<std::size_t, 2>{0, 1})
            incidences[n] = dot(form(n + 1), direction) + dot(form(n + 1), ray) -
                            dot(form(n + 1), xi) * dot(camera.c, fifth.w);
        const Residue q = -incidences[1] * incidences[0].inverse();
        const StarImage y =
            with_point(images(pins, camera), camera.image(fifth), dot(form(1), xi), q);
        CHECK(!(delta(y, star_point(pins)) == Residue{}));
        CHECK(times(row(y, star_point(pins)), {dot(form(2), direction) - r(pins, fifth),
                                               dot(form(1), direction), fifth.w[0], one}) ==
              Residue{});
    }
}

TEST_CASE("collinear points, six views and a free line: scenes have a matrix of small rank") {
    Numbers random(3);
    for (const std::size_t last : std::array<std::size_t, 2>{0, 1}) {
        const auto pins = star(false, random);
        const std::array others{Pin{1, random(), {random(), one}},
                                Pin{last, random(), {random(), one}}};
        for (int view = 0; view < 6; ++view) {
            const Pair a = random.pair();
            const Camera camera = random_camera_of_line(a, random);
            const auto t = images(pins, camera);
            TwoPinImage y{{t[0], t[1], t[2]}, {}, {}};
            for (const std::size_t j : std::array<std::size_t, 2>{0, 1}) {
                const Pair other = other_pin(a, others[j].point, camera.image(others[j]));
                y.beta[j] = other[0];
                y.gamma[j] = other[1];
            }
            const auto entries = row(y, std::array{others[0].w, others[1].w});
            CHECK(times(entries, {others[0].s, -r(pins, others[0]), -others[1].s,
                                  r(pins, others[1]), sigma(pins)}) == Residue{});
        }
    }
}

TEST_CASE("collinear points: the map of a scene has rank one at what its views see") {
    Numbers random(4);
    for (const PinCounts& counts : {PinCounts{0, 3, 4}, PinCounts{1, 2, 4}, PinCounts{1, 3, 3},
                                    PinCounts{2, 2, 3}, PinCounts{0, 3, 5}, PinCounts{1, 2, 5}}) {
        const auto pins = random_pins(counts, random);
        const Matrix map = map_of_scene(pins);
        Matrix points;
        for (std::size_t j = 0; j < pins.size(); ++j)
            points.push_back(unit(pins.size(), j));
        for (int view = 0; view < 6; ++view) {
            const Camera camera = random_camera(random);
            points.emplace_back();
            for (const Pin& pin : pins)
                points.back().push_back(camera.image(pin));
        }
        for (const Vector& t : points)
            for (std::size_t i = 0; i + 2 < map.size(); i += 2)
                CHECK(times(map[i], t) * times(map[i + 3], t) ==
                      times(map[i + 1], t) * times(map[i + 2], t));
        for (std::size_t n = 0; n < 2; ++n) { // it vanishes on phi(L)
            Vector forms;
            for (const Pin& pin : pins)
                forms.push_back(form(pin.point)[n]);
            for (const Vector& row : map)
                CHECK(times(row, forms) == Residue{});
        }
    }
}

TEST_CASE("collinear points, six views: a pencil of quadrics has five singular members") {
    Numbers random(5);
    for (const PinCounts& counts :
         {PinCounts{0, 3, 4}, PinCounts{1, 2, 4}, PinCounts{1, 3, 3}, PinCounts{2, 2, 3}}) {
        const auto places = points_of_pins(counts);
        Matrix points;
        for (std::size_t j = 0; j < 7; ++j)
            points.push_back(modulo_forms(unit(7, j), places));
        for (int view = 0; view < 6; ++view) {
            Vector t(7);
            for (Residue& entry : t)
                entry = random();
            points.push_back(modulo_forms(t, places));
        }
        const Matrix pencil = quadrics(points, 5);
        REQUIRE(pencil.size() == 2);
        const Polynomial discriminant = interpolate(5, [&](Residue x) {
            Vector member = pencil[0];
            for (std::size_t i = 0; i < member.size(); ++i)
                member[i] = member[i] + x * pencil[1][i];
            return checker::determinant(symmetric(member, 5));
        });
        CHECK(degree(discriminant) == 5);
        CHECK(has_simple_roots(discriminant)); // so the singular members have rank 4
    }
}

TEST_CASE("collinear points, four views: besides seven points the curves have five in common") {
    Numbers random(6);
    for (const std::size_t last : std::array<std::size_t, 2>{0, 1}) {
        std::array<std::vector<StarImage>, 2> views;
        std::vector<Residue> known{Residue{}, one}; // and infinity
        for (int view = 0; view < 4; ++view) {
            const Pair a = random.pair();
            const auto t = four(random);
            views[0].push_back(with_pin(t, other_pin(a, 1, random())));
            views[1].push_back(with_pin(t, other_pin(a, last, random())));
            known.push_back((t[0] - t[2]) * (t[1] - t[3]) *
                            ((t[1] - t[2]) * (t[0] - t[3])).inverse());
        }
        Polynomial rest = interpolate(12, [&](Residue z) {
            std::array<Rows, 2> rows;
            for (const std::size_t j : std::array<std::size_t, 2>{0, 1})
                for (const StarImage& y : views[j])
                    rows[j].push_back(row(y, at_z(z)));
            return resultant(laplace(rows[0]), laplace(rows[1]), 2);
        });
        CHECK(degree(rest) == 11); // one zero at infinity
        for (const Residue z : known)
            rest = without(rest, z);
        CHECK(degree(rest) == 5);
        CHECK(has_simple_roots(rest));
    }
}

TEST_CASE("collinear points, five views: besides three points there are four") {
    Numbers random(7);
    std::vector<StarImage> views;
    for (int view = 0; view < 5; ++view)
        views.push_back(with_point(four(random), random(), random(), random()));
    const auto rows = [&](Residue z) {
        Rows all;
        for (const StarImage& y : views)
            all.push_back(row(y, at_z(z)));
        return all;
    };
    const Polynomial rest = without(without(eliminant(rows, 3, 2, 5), Residue{}), one);
    CHECK(degree(rest) == 4); // without infinity
    CHECK(has_simple_roots(rest));
}

TEST_CASE("collinear points, six views and a free line: besides three points there are seven") {
    Numbers random(8);
    for (const std::size_t last : std::array<std::size_t, 2>{0, 1}) {
        std::vector<TwoPinImage> views;
        for (int view = 0; view < 6; ++view) {
            const Pair a = random.pair();
            const Pair first = other_pin(a, 1, random()), second = other_pin(a, last, random());
            views.push_back(
                {{random(), random(), random()}, {first[0], second[0]}, {first[1], second[1]}});
        }
        const auto rows = [&](Residue x) {
            Rows all;
            for (const TwoPinImage& y : views)
                all.push_back(row(y, std::array{std::array{Polynomial(x), Polynomial(one)},
                                                std::array{variable, Polynomial(one)}}));
            return all;
        };
        const Polynomial rest = without(without(eliminant(rows, 3, 3, 6), Residue{}), one);
        CHECK(degree(rest) == 7); // without infinity
        CHECK(has_simple_roots(rest));
    }
}
