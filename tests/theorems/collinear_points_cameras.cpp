// Section 1 of proofs/collinear_points_more_views.md (Theorem M): cameras are arbitrary matrices,
// in arbitrary coordinates of space, and images vectors up to factors. From these alone come the
// numbers t and a (of section 4). Modulo 2^61 - 1.
#include "proofs/computations/plane_curves.h"
#include "proofs/computations/star_equations.h"
#include "proofs/computations/three_pin_curves.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <vector>

using namespace proofs;

namespace {

const Residue zero{}, one{1};

using Image = std::array<Residue, 3>; // of a point or of a line

Residue dot(const Image& a, const Image& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Image cross(const Image& a, const Image& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Image times(Residue factor, const Image& a) {
    return {factor * a[0], factor * a[1], factor * a[2]};
}

Vector random_vector(std::size_t size, Numbers& random) {
    Vector vector(size);
    for (Residue& entry : vector)
        entry = random();
    return vector;
}

/// Bases of L and of W in coordinates of space: (r, w) is the sum of r_i basis_i + w_i basis_{2+i}.
struct Space {
    Matrix basis;

    explicit Space(Numbers& random) {
        for (int n = 0; n < 4; ++n)
            basis.push_back(random_vector(4, random));
    }
    Vector place(const Pair& r, const Pair& w) const {
        Vector sum(4);
        for (std::size_t i = 0; i < 4; ++i)
            sum[i] =
                r[0] * basis[0][i] + r[1] * basis[1][i] + w[0] * basis[2][i] + w[1] * basis[3][i];
        return sum;
    }
};

/// The kernel of phi_point.
Pair kernel_of(std::size_t point) {
    const Pair phi = form(point);
    return {phi[1], -phi[0]};
}

/// What a camera shows, each up to a random factor: the points X_1, X_2, X_3, the lines of the
/// pins, and the free line W.
struct View {
    std::array<Image, 3> points;
    std::vector<Image> pins;
    Image free_line;
};

View view_of(const Space& space, const std::vector<Pin>& pins, const Matrix& camera,
             Numbers& random) {
    const auto see = [&](const Pair& r, const Pair& w) {
        const Vector place = space.place(r, w);
        Image image;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < 4; ++k)
                image[i] = image[i] + camera[i][k] * place[k];
        return image;
    };
    View view;
    for (std::size_t point = 0; point < 3; ++point)
        view.points[point] = times(random(), see(kernel_of(point), {}));
    for (const Pin& pin : pins) {
        const Pair phi = form(pin.point); // r with phi(r) = s; phi(r) is r_0, r_1 or their sum
        const Pair r{pin.s * phi[0], phi[0] == zero ? pin.s : zero};
        const Image line = cross(see(kernel_of(pin.point), {}), see(r, pin.w));
        view.pins.push_back(times(random(), line));
    }
    view.free_line = times(random(), cross(see({}, {one, zero}), see({}, {zero, one})));
    return view;
}

/// Coordinates of the image as in section 1, computed from the image alone.
class Normal {
public:
    Normal(const View& view, Numbers& random) {
        // x_1, x_2, x_3 are dependent; with factors they become (0, 1), (1, 0) and (1, -1) in L.
        Matrix rows(3);
        for (std::size_t i = 0; i < 3; ++i)
            for (const Image& x : view.points)
                rows[i].push_back(x[i]);
        const Vector relation = proofs::kernel_of(rows, 3).at(0);
        frame[0] = times(relation[1], view.points[1]);
        frame[1] = times(-relation[0], view.points[0]);
        frame[2] = {random(), random(), random()}; // any vector off the image of L
    }
    /// A line in these coordinates.
    Image line(const Image& l) const {
        return {dot(l, frame[0]), dot(l, frame[1]), dot(l, frame[2])};
    }
    /// t, for a pin of this point: the line is phi - t (last coordinate), up to a factor.
    Residue t(std::size_t point, const Image& pin) const {
        const Image l = line(pin);
        const std::size_t place = point == 1 ? 1 : 0;
        CHECK(l[0] * form(point)[1] == l[1] * form(point)[0]);
        return -l[2] * l[place].inverse();
    }
    /// a, for the free line: it is a - (last coordinate), up to a factor.
    Pair a(const Image& free_line) const {
        const Image l = line(free_line);
        const Residue factor = -l[2].inverse();
        return {factor * l[0], factor * l[1]};
    }

private:
    std::array<Image, 3> frame;
};

struct Seen {
    Vector t;
    Pair a;
};

std::vector<Seen> views_of(const std::vector<Pin>& pins, std::size_t views, Numbers& random) {
    const Space space(random);
    std::vector<Seen> all;
    for (std::size_t v = 0; v < views; ++v) {
        const Matrix camera{random_vector(4, random), random_vector(4, random),
                            random_vector(4, random)};
        const View view = view_of(space, pins, camera, random);
        const Normal normal(view, random);
        all.push_back({{}, normal.a(view.free_line)});
        for (std::size_t j = 0; j < pins.size(); ++j)
            all.back().t.push_back(normal.t(pins[j].point, view.pins[j]));
    }
    return all;
}

Residue times(const Vector& row, const Vector& vector) {
    Residue sum;
    for (std::size_t i = 0; i < row.size(); ++i)
        sum = sum + row[i] * vector[i];
    return sum;
}

/// Pins of X_3 at (1, 0), (0, 1), (1, 1) and (z, 1), the first `count` of them; then others.
std::vector<Pin> star(std::size_t count, const std::vector<std::size_t>& others, Numbers& random) {
    std::vector<Pin> pins{{2, random(), {one, zero}},
                          {2, random(), {zero, one}},
                          {2, random(), {one, one}},
                          {2, random(), {random(), one}}};
    pins.resize(count);
    for (const std::size_t point : others)
        pins.push_back({point, random(), {random(), one}});
    return pins;
}

} // namespace

TEST_CASE("collinear points, any cameras: the map of a scene has rank one at its images") {
    Numbers random(21);
    for (const PinCounts& counts :
         {PinCounts{0, 3, 4}, PinCounts{1, 2, 4}, PinCounts{1, 3, 3}, PinCounts{2, 2, 3},
          PinCounts{0, 3, 5}, PinCounts{1, 2, 5}, PinCounts{1, 3, 4}}) {
        const auto pins = random_pins(counts, random);
        const Matrix map = map_of_scene(pins);
        for (const Seen& view : views_of(pins, 6, random))
            for (std::size_t i = 0; i + 2 < map.size(); i += 2)
                CHECK(times(map[i], view.t) * times(map[i + 3], view.t) ==
                      times(map[i + 1], view.t) * times(map[i + 2], view.t));
    }
}

TEST_CASE("collinear points, any cameras: four pins at a point and a free line") {
    Numbers random(22);
    for (const std::size_t last : std::array<std::size_t, 2>{0, 1}) {
        const auto pins = star(4, {1, last}, random);
        const Residue z = pins[3].w[0];
        const StarPoint<Residue> point{
            {z, one}, {pins[0].s + pins[1].s - pins[2].s, z * pins[0].s + pins[1].s - pins[3].s}};
        for (const std::size_t j : std::array<std::size_t, 2>{4, 5}) {
            std::vector<Vector> rows;
            for (const Seen& view : views_of(pins, 4, random))
                rows.push_back(row(with_pin({view.t[0], view.t[1], view.t[2], view.t[3]},
                                            other_pin(view.a, pins[j].point, view.t[j])),
                                   point));
            CHECK(laplace(rows) == zero);
            rows.pop_back();
            CHECK(rank(rows) == 3);
        }
    }
}

TEST_CASE("collinear points, any cameras: three pins at a point and a free line in six views") {
    Numbers random(23);
    for (const std::size_t last : std::array<std::size_t, 2>{0, 1}) {
        const auto pins = star(3, {1, last}, random);
        Matrix rows;
        for (const Seen& view : views_of(pins, 6, random)) {
            TwoPinImage y{{view.t[0], view.t[1], view.t[2]}, {}, {}};
            for (const std::size_t j : std::array<std::size_t, 2>{0, 1}) {
                const Pair other = other_pin(view.a, pins[3 + j].point, view.t[3 + j]);
                y.beta[j] = other[0];
                y.gamma[j] = other[1];
            }
            rows.push_back(row(y, std::array{pins[3].w, pins[4].w}));
        }
        CHECK(rank(rows) == 4);
    }
}

TEST_CASE("collinear points, any cameras: the curves of degree 7 and of bidegree (5, 5)") {
    Numbers random(24);
    const auto eight = eight_pins(random);
    std::vector<EightImages> images;
    for (const Seen& view : views_of(eight, 4, random)) {
        images.emplace_back();
        std::ranges::copy(view.t, images.back().begin());
    }
    for (const Residue value : curves_at(images, center_of(eight)))
        CHECK(value == zero);

    const auto six = star(3, {1, 1, 1}, random);
    std::vector<ThreePinImage> views;
    for (const Seen& view : views_of(six, 4, random)) {
        std::array<Residue, 6> t{};
        std::ranges::copy(view.t, t.begin());
        views.push_back(three_pin_image(view.a, t));
    }
    for (const Residue value : three_pin_curves(views, {six[3].w[0], six[4].w[0]}))
        CHECK(value == zero);
}
