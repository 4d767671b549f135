// Theorem X (proofs/upright_focal_depths.md): three or four cameras modulo a prime that know the
// vertical direction see points and lines, and depths and heights meet the relations.
#include "tests/theorems/upright_view.h"

#include <array>
#include <doctest/doctest.h>
#include <vector>

using namespace checker;
using namespace residue_vectors;
using namespace upright_view;

namespace {

using Pair = std::array<Residue, 2>;

Residue bracket(const Pair& a, const Pair& b) {
    return a[0] * b[1] - a[1] * b[0];
}

Pair combination(Residue s, const Pair& a, Residue t, const Pair& b) {
    return {s * a[0] + t * b[0], s * a[1] + t * b[1]};
}

/// A camera at a place, that sees the origin at q.
struct Station {
    explicit Station(Residues& random) : view(random), depth(random.next()) {
        const Residue zero, one{1};
        const Vector first = view.image({one, zero, zero}), third = view.image({zero, zero, one});
        x = {first[0], third[0]};
        y = {first[2], third[2]};
    }

    Vector image(const Vector& point) const {
        return plus(view.image(point), times(depth, view.q));
    }

    View view;
    Residue depth;
    Pair x, y; // the columns
};

struct Scene {
    Scene(std::size_t views, Residues& random) {
        for (std::size_t v = 0; v < views; ++v)
            stations.emplace_back(random);
    }

    std::vector<Station> stations;

    const Pair& column(std::size_t i) const {
        const Station& station = stations[i / 2];
        return i % 2 == 0 ? station.x : station.y;
    }

    std::size_t columns() const { return 2 * stations.size(); }

    /// e_a of a point for all columns, by its images, depths and this height.
    std::vector<Residue> products(const Vector& point, Residue height, Residues& random) const {
        std::vector<Residue> e;
        for (const Station& station : stations) {
            const Vector q = times(random.next(), station.image(point)); // up to a factor
            for (const std::size_t entry : {0U, 2U})
                e.push_back(station.depth * (station.view.q[1] * q[1].inverse() * q[entry] -
                                             station.view.q[entry]) +
                            height * q[entry] * q[1].inverse());
        }
        return e;
    }
};

} // namespace

TEST_CASE("heights and depths of a point meet the relations of Theorem X") {
    Residues random(1);
    const Scene scene(3, random);
    const Vector point = random_vector(random);
    for (const bool true_height : {true, false}) {
        const Residue h = true_height ? point[1] : random.next();
        const std::vector<Residue> e = scene.products(point, h, random);
        for (std::size_t a = 0; a < e.size(); ++a)
            for (std::size_t b = a + 1; b < e.size(); ++b)
                for (std::size_t c = b + 1; c < e.size(); ++c) {
                    const Pair &first = scene.column(a), &second = scene.column(b),
                               &third = scene.column(c);
                    const Residue sum = e[a] * bracket(second, third) +
                                        e[b] * bracket(third, first) +
                                        e[c] * bracket(first, second);
                    CHECK((sum == Residue{}) == true_height); // (3)
                }
    }
}

TEST_CASE("depths and heights of two points tell the columns of four cameras") {
    Residues random(3);
    const Scene scene(4, random);
    const Vector q = random_vector(random), r = random_vector(random);
    const Residue determinant = q[0] * r[2] - q[2] * r[0];
    for (const bool true_height : {true, false}) {
        const std::vector<Residue> first = scene.products(q, q[1], random);
        const std::vector<Residue> second =
            scene.products(r, true_height ? r[1] : random.next(), random);
        const auto form = [&](std::size_t a, std::size_t b) {
            return first[a] * second[b] - first[b] * second[a];
        };
        for (std::size_t a = 0; a < scene.columns(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                CHECK((form(a, b) == determinant * bracket(scene.column(a), scene.column(b))) ==
                      true_height); // (7)
        for (std::size_t x = 0; x < scene.columns(); x += 2)
            for (std::size_t other_x = 0; other_x < x; other_x += 2) {
                const std::size_t y = x + 1, other_y = other_x + 1;
                const Residue term = form(x, y) * form(x, other_y);
                CHECK((term + form(other_x, other_y) * form(y, other_x) == Residue{}) ==
                      true_height); // (8)
                CHECK(term != Residue{});
            }
    }
}

TEST_CASE("directions and distances of a line meet the relations of Theorem X") {
    Residues random(2);
    const Scene scene(3, random);
    const Vector a = random_vector(random), b = random_vector(random);
    std::array<Vector, 3> l;
    std::array<Pair, 3> c;
    std::array<Residue, 3> d;
    for (std::size_t v = 0; v < 3; ++v) {
        const Station& station = scene.stations[v];
        l[v] = cross(station.image(a), station.image(b));
        c[v] = combination(l[v][0], station.x, l[v][2], station.y);
        d[v] = dot(l[v], station.view.q) * station.depth;
    }
    const auto sum = [&](auto&& term) { return term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1); };
    using Size = std::size_t;
    CHECK(sum([&](Size v, Size s, Size t) { return l[v][1] * bracket(c[s], c[t]); }) ==
          Residue{}); // (2)
    CHECK(sum([&](Size v, Size s, Size t) { return d[v] * bracket(c[s], c[t]); }) ==
          Residue{}); // (4)
    for (Size i = 0; i < 6; ++i) {
        const Pair& e = scene.column(i);
        const auto term = [&](Size v, Size s, Size t) {
            return d[v] * (l[t][1] * bracket(c[s], e) - l[s][1] * bracket(c[t], e));
        };
        CHECK(sum(term) == Residue{});     // (4)
        CHECK(term(0, 1, 2) != Residue{}); // and not term by term
    }
    const Pair &x = scene.column(0), &y = scene.column(1), &p = scene.column(2),
               &r = scene.column(4);
    CHECK(bracket(x, y) * bracket(p, r) ==
          bracket(x, p) * bracket(y, r) - bracket(x, r) * bracket(y, p)); // (1)
    CHECK(bracket(x, y) == scene.stations[0].view.g);
}
