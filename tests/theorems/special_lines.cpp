// The special lines of Theorem M (proofs/special_lines.md) by second methods: scenes with known
// cameras, eliminants, and fixed points of a torus.
#include "proofs/computations/special_lines.h"

#include <doctest/doctest.h>

#include <array>
#include <vector>

using namespace proofs;

namespace {

std::vector<PointOfK> random_points(Numbers& random) {
    Matrix seen(4, Vector(8));
    for (Vector& t : seen)
        for (Residue& number : t)
            number = random();
    return ten_points(seen);
}

/// The polynomial q(z, y, 1) in y, by values.
Polynomial quartic(const BilinearMap& map, Residue z) {
    return interpolate(4, [&](Residue y) { return star(map, {z, y, Residue{1}}).q; });
}

/// Where both quartics vanish: the first coordinates of these points, for y_2 = 1.
Polynomial eliminant(const std::array<BilinearMap, 2>& maps) {
    return interpolate(
        16, [&](Residue z) { return resultant(quartic(maps[0], z), quartic(maps[1], z), 4); });
}

/// The quotient by a root, and whether it is one.
bool divide(Polynomial& f, Residue x) {
    const bool is_root = value(f, x) == Residue{};
    Polynomial quotient(std::vector<Residue>(degree(f)));
    Residue carry;
    for (std::size_t i = degree(f); i > 0; --i)
        quotient.coefficients[i - 1] = carry = carry * x + f[i];
    f = quotient;
    return is_root;
}

/// The sum over the fixed points of P(K'/S) x P(K'/S) over those of the Grassmannian: maps of rank
/// 1 at most have their images in a line of K'/S, which is a point of P(K'/S).
Residue sum_over_fixed_points(const std::array<Residue, 4>& w) {
    Residue sum;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j) {
            std::array<std::size_t, 2> rest{};
            for (std::size_t n = 0, m = 0; n < 4; ++n)
                if (n != i && n != j) rest[m++] = n;
            const auto pushed = [&](std::size_t image, std::size_t other) {
                Residue product = (w[other] - w[image]).inverse();
                for (const Residue weight : {w[i] + w[i], w[i] + w[j], w[j] + w[j]})
                    product = product * (w[other] - weight);
                return product;
            };
            const Residue both = pushed(rest[0], rest[1]) + pushed(rest[1], rest[0]);
            Residue tangent{1};
            for (const std::size_t n : rest)
                tangent = tangent * (w[n] - w[i]) * (w[n] - w[j]);
            sum = sum + both * both * tangent.inverse();
        }
    return sum;
}

} // namespace

TEST_CASE("special lines: there are 125 by a sum over fixed points of a torus") {
    Numbers random(31);
    for (int n = 0; n < 3; ++n)
        CHECK(sum_over_fixed_points({random(), random(), random(), random()}) == Residue{125});
}

TEST_CASE("special lines: the maps of the ten points have them as eigenvectors") {
    Numbers random(32);
    const auto points = random_points(random);
    REQUIRE(rank(squares(points)) == 10);
    const auto maps = maps_of_points(points);
    for (std::size_t h = 0; h < 2; ++h)
        for (const PointOfK& x : points) {
            const Vector y = projected(x), image = value(maps[h], y, y);
            for (std::size_t n = 0; n < 4; ++n)
                CHECK(image[n] == x[h] * y[n]);
        }
}

TEST_CASE("special lines: on the line of a scene the maps have the images w_1 and w_2") {
    Numbers random(33);
    const auto pins = random_pins({2, 3, 3}, random);
    Matrix seen;
    for (int view = 0; view < 4; ++view) {
        const Camera camera = random_camera(random);
        seen.emplace_back();
        for (const Pin& pin : pins)
            seen.back().push_back(camera.image(pin));
    }
    const auto points = ten_points(seen);
    REQUIRE(rank(squares(points)) == 10); // else the maps are not defined
    const auto maps = maps_of_points(points);
    const Matrix xi = projection_of_scene(pins), line = kernel_of(xi, 4);
    REQUIRE(line.size() == 2);
    for (std::size_t h = 0; h < 2; ++h) {
        const Matrix restricted = on_line(maps[h], line, xi);
        CHECK(rank(restricted) == 1); // not 0
        for (std::size_t n = 0; n < 3; ++n)
            CHECK(area({restricted[0][n], restricted[1][n]}, pins[h].w) == Residue{});
    }
}

TEST_CASE("special lines: 16 different ones through a t_v, 12 and one fourfold through an e_j") {
    Numbers random(34);
    const auto points = random_points(random);
    for (const std::size_t center : std::array<std::size_t, 4>{0, 5, 6, 9}) {
        const auto moved = centered_at(points, center, random);
        const auto maps = maps_of_points(moved);
        Polynomial f = eliminant(maps);
        CHECK(degree(f) == 16);
        const auto root = [&](std::size_t n) { return moved[n][3] * moved[n][5].inverse(); };
        const bool is_pin = center < 6;
        const std::size_t first = center < 3 ? 0 : 3; // of the triple
        if (is_pin) {
            const std::size_t other = center == first ? first + 1 : first;
            for (int n = 0; n < 4; ++n)
                CHECK(divide(f, root(other)));
            CHECK(!(value(f, root(other)) == Residue{}));
        }
        CHECK(has_simple_roots(f));
        for (std::size_t n = 0; n < 10; ++n)
            if (n != center && !(is_pin && n >= first && n < first + 3)) CHECK(divide(f, root(n)));
        CHECK(degree(f) == (is_pin ? 5 : 7));
    }
}
