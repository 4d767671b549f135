// Theorem X (proofs/upright_focal_depths.md): three cameras modulo a prime that know the vertical
// direction see points and lines, and depths and heights meet the relations.
#include "tests/theorems/upright_view.h"

#include <array>
#include <doctest/doctest.h>

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
    explicit Scene(Residues& random)
        : stations{Station(random), Station(random), Station(random)} {}

    std::array<Station, 3> stations;

    const Pair& column(std::size_t i) const {
        const Station& station = stations[i / 2];
        return i % 2 == 0 ? station.x : station.y;
    }
};

} // namespace

TEST_CASE("heights and depths of a point meet the relations of Theorem X") {
    Residues random(1);
    const Scene scene(random);
    const Vector point = random_vector(random);
    for (const bool true_height : {true, false}) {
        const Residue h = true_height ? point[1] : random.next();
        std::array<Residue, 6> e;
        for (std::size_t i = 0; i < e.size(); ++i) {
            const Station& station = scene.stations[i / 2];
            const Vector q = times(random.next(), station.image(point)); // up to a factor
            const std::size_t entry = i % 2 == 0 ? 0 : 2;
            e[i] = station.depth *
                       (station.view.q[1] * q[1].inverse() * q[entry] - station.view.q[entry]) +
                   h * q[entry] * q[1].inverse();
        }
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

TEST_CASE("directions and distances of a line meet the relations of Theorem X") {
    Residues random(2);
    const Scene scene(random);
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
