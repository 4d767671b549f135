// What the proof of Theorem M (proofs/collinear_points_more_views.md, from section 6 on
// proofs/collinear_points_curves.md, and proofs/special_lines.md) needs computed: examples modulo
// the prime 2^61 - 1, each for a statement on generic images or generic scenes. From the folder
// that holds checker/ and proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/collinear_points_more_views.cpp -lgmp -o collinear
//
// Each line of the output is a fact. Exit status 1 if one fails.
#include "proofs/computations/plane_curves.h"
#include "proofs/computations/report.h"
#include "proofs/computations/scroll_quadrics.h"
#include "proofs/computations/special_lines.h"
#include "proofs/computations/star_equations.h"
#include "proofs/computations/three_pin_curves.h"

#include <algorithm>
#include <string>

namespace {

using namespace proofs;

Report report;

std::string name(const PinCounts& counts) {
    return std::to_string(counts[0]) + ", " + std::to_string(counts[1]) + ", " +
           std::to_string(counts[2]) + " pins: ";
}

/// The points e_j of K, and those of random views.
Matrix points_in_K(const PinCounts& counts, std::size_t views, Numbers& random) {
    const auto points = points_of_pins(counts);
    Matrix result;
    for (std::size_t j = 0; j < points.size(); ++j)
        result.push_back(modulo_forms(unit(points.size(), j), points));
    for (std::size_t v = 0; v < views; ++v) {
        Vector t(points.size());
        for (Residue& entry : t)
            entry = random();
        result.push_back(modulo_forms(t, points));
    }
    return result;
}

void six_views(const PinCounts& counts, Numbers& random) {
    const Matrix basis = quadrics(points_in_K(counts, 6, random), 5);
    report(basis.size() == 2, name(counts) + "Lemma M4, 13 points lie on a pencil of quadrics");
    report(!(checker::determinant(symmetric(basis[0], 5)) == Residue{}),
           name(counts) + "Lemma M4, one of them is smooth");
}

void general_scene(const PinCounts& counts, Numbers& random) {
    const auto pins = random_pins(counts, random);
    const std::size_t k = pins.size();
    report(rank(rows_of_H(pins)) == 5, name(counts) + "section 1, H has dimension 5");
    const Matrix map = map_of_scene(pins);
    report(rank(map) == std::min(k - 2, 2 * (k - 5)), name(counts) + "section 1, A has full rank");
    bool none_is_zero = true;
    for (std::size_t j = 0; j < k; ++j)
        none_is_zero = none_is_zero && std::ranges::any_of(map, [&](const Vector& row) {
                           return !(row[j] == Residue{});
                       });
    report(none_is_zero, name(counts) + "section 1, no A(e_j) is 0");
}

/// Points of P^3: coordinates of K modulo e_1, e_2, e_3, whose span is a plane.
void five_pins(const PinCounts& counts, Numbers& random) {
    const Matrix points = points_in_K(counts, 4, random);
    const Matrix plane(points.begin(), points.begin() + 3);
    report(rank(plane) == 2, name(counts) + "section 3, e_1, e_2, e_3 span a plane");
    const Matrix forms = kernel_of(plane, 6); // that vanish on it
    Matrix projected;
    for (std::size_t n = 3; n < points.size(); ++n) {
        projected.emplace_back();
        for (const Vector& f : forms) {
            Residue value;
            for (std::size_t i = 0; i < f.size(); ++i)
                value = value + f[i] * points[n][i];
            projected.back().push_back(value);
        }
    }
    report(quadrics(projected, 4).size() == 1,
           name(counts) + "Lemma M6, nine points lie on one quadric");
}

Polynomial linear(Numbers& random) {
    return Polynomial(std::vector{random(), random()});
}

/// A random curve of bidegree (1, 1).
StarPoint<Polynomial> star_curve(Numbers& random) {
    const Polynomial one(Residue{1}), variable(std::vector{Residue{}, Residue{1}});
    return {{variable, one}, {linear(random), linear(random)}};
}

std::array<Residue, 4> four(Numbers& random) {
    return {random(), random(), random(), random()};
}

void four_pins(const std::array<std::size_t, 2>& others, const std::string& problem,
               Numbers& random) {
    const auto curve = star_curve(random);
    std::array<std::vector<std::vector<Polynomial>>, 2> matrices;
    for (std::size_t v = 0; v < 4; ++v) {
        const Pair a = random.pair();
        const auto t = four(random);
        for (std::size_t j = 0; j < 2; ++j)
            matrices[j].push_back(row(with_pin(t, other_pin(a, others[j], random())), curve));
    }
    report(!(resultant(laplace(matrices[0]), laplace(matrices[1]), 5) == Residue{}),
           problem + "Lemma M8, the curves have no component in common");
}

/// Whether two maximal minors of rows one more than columns have no common zero.
bool minors_have_no_common_zero(std::vector<std::vector<Polynomial>> rows, std::size_t degree) {
    const std::vector last(rows.begin() + 1, rows.end());
    rows.pop_back();
    return !(resultant(laplace(rows), laplace(last), degree) == Residue{});
}

void five_views(Numbers& random) {
    const auto curve = star_curve(random);
    std::vector<std::vector<Polynomial>> rows;
    for (std::size_t v = 0; v < 5; ++v)
        rows.push_back(row(with_point(four(random), random(), random(), random()), curve));
    report(minors_have_no_common_zero(rows, 5), "0, 1, 3 pins, Pa: Lemma M10, finitely many zeros");
}

void three_pins(const std::array<std::size_t, 2>& others, const std::string& problem,
                Numbers& random) {
    const auto curve = star_curve(random);
    std::vector<std::vector<Polynomial>> rows;
    for (std::size_t v = 0; v < 6; ++v) {
        const Pair a = random.pair();
        TwoPinImage y{{random(), random(), random()}, {}, {}};
        for (std::size_t j = 0; j < 2; ++j) {
            const Pair other = other_pin(a, others[j], random());
            y.beta[j] = other[0];
            y.gamma[j] = other[1];
        }
        rows.push_back(row(y, std::array{curve.z, curve.sigma}));
    }
    report(minors_have_no_common_zero(rows, 6), problem + "Lemma M12, finitely many zeros");
}

std::vector<EightImages> images(const std::vector<Pin>& pins, std::size_t views, Numbers& random) {
    std::vector<EightImages> all(views);
    for (EightImages& t : all) {
        const Camera camera = random_camera(random);
        for (std::size_t j = 0; j < t.size(); ++j)
            t[j] = camera.image(pins[j]);
    }
    return all;
}

void curves_of_degree_7(Numbers& random) {
    const auto pins = eight_pins(random);
    const auto seen = images(pins, 4, random);
    const Pair o = center_of(pins);
    bool is_other_point = true;
    for (const Pair& w : frame(o))
        is_other_point = is_other_point && !(w[0] == Residue{} && w[1] == Residue{});
    for (const EightImages& t : seen)
        is_other_point = is_other_point && !(ray(t, o)[0] == Residue{});
    report(is_other_point, "1, 3, 4 pins: section 7, O is none of the eight points");
    report(rank(conditions(seen, o)) == 4, "1, 3, 4 pins: section 7, B has dimension 3");
    std::vector<EightImages> views(4);
    for (EightImages& t : views)
        for (Residue& number : t)
            number = random();
    report(rank_of_multiples(views, 25, random) == 26 * 27 / 2 - 33,
           "1, 3, 4 pins: Lemma M17, the multiples have codimension 33");
}

std::array<Residue, 6> six(Numbers& random) {
    return {random(), random(), random(), random(), random(), random()};
}

void curves_of_bidegree_5(Numbers& random) {
    const std::string problem = "0, 3, 3 pins, a: ";
    std::vector<ThreePinImage> views;
    for (std::size_t v = 0; v < 4; ++v)
        views.push_back(three_pin_image(random.pair(), six(random)));
    const std::size_t degree = 9, all = (degree + 1) * (degree + 1);
    report(rank_with(views, degree, 2, random) == all - 37,
           problem + "Lemma M22, the multiples have codimension 37");
    report(rank_with(views, degree, 0, random) == all && rank_with(views, degree, 1, random) == all,
           problem + "Lemma M22, so they have in higher degrees");
    const Polynomial first = eliminant(views, random); // of degree 18, with a zero at infinity
    const Polynomial common = gcd(first, eliminant(views, random));
    report(proofs::degree(first) == 17 && proofs::degree(common) == 8 && has_simple_roots(common),
           problem + "Lemma M19, T consists of nine simple points");
    report(rank(equations(views, {})) == 7, problem + "Lemma M20, N has rank 7 at (0, 0)");
    bool has_full_rank = true;
    for (const ThreePinImage& y : views)
        has_full_rank = has_full_rank && rank(equations(views, zero_of_view(y))) == 8;
    report(has_full_rank, problem + "Lemma M21, N has rank 8 at the R_v");
}

void scene_of_three_pins(Numbers& random) {
    std::vector<Pin> star = random_pins({0, 0, 3}, random);
    star[0].w = {Residue{1}, Residue{}};
    star[1].w = {Residue{}, Residue{1}};
    star[2].w = {Residue{1}, Residue{1}};
    const auto others = random_pins({0, 3, 0}, random);
    star.insert(star.end(), others.begin(), others.end());
    std::vector<ThreePinImage> views;
    for (std::size_t v = 0; v < 4; ++v) {
        const Pair a = random.pair();
        const Camera camera = random_camera_of_line(a, random);
        std::array<Residue, 6> t;
        for (std::size_t j = 0; j < 6; ++j)
            t[j] = camera.image(star[j]);
        views.push_back(three_pin_image(a, t));
    }
    const Pair x{others[0].w[0] * others[0].w[1].inverse(),
                 others[1].w[0] * others[1].w[1].inverse()};
    report(rank(equations(views, x)) == 8, "0, 3, 3 pins, a: section 8, N has rank 8");
}

bool is_zero(const Vector& v) {
    return std::ranges::all_of(v, [](Residue x) { return x == Residue{}; });
}

void scene_of_special_line(Numbers& random) {
    const std::string problem = "2, 3, 3 pins: special lines, ";
    const auto pins = random_pins({2, 3, 3}, random);
    Matrix first_two;
    for (const Vector& coordinate : kernel_of(rows_of_H(pins), 8))
        first_two.push_back({coordinate[0], coordinate[1]});
    report(rank(first_two) == 2, problem + "u_1 and u_2 are independent");
    Matrix seen;
    for (const EightImages& t : images(pins, 4, random))
        seen.emplace_back(t.begin(), t.end());
    const auto points = ten_points(seen);
    report(rank(squares(points)) == 10, problem + "the ten squares of a scene are a basis");
    const Matrix xi = projection_of_scene(pins), line = kernel_of(xi, 4);
    bool avoids = line.size() == 2;
    for (const PointOfK& x : points)
        avoids = avoids && rank({line[0], line[1], projected(x)}) == 3;
    report(avoids, problem + "the line of a scene contains none of the ten points");
    bool nonzero = true;
    for (const BilinearMap& map : maps_of_points(points)) {
        const Matrix restricted = on_line(map, line, xi);
        nonzero = nonzero && !(is_zero(restricted[0]) && is_zero(restricted[1]));
    }
    report(nonzero, problem + "Lambda_1 and Lambda_2 are not 0 on it");
}

void special_lines(Numbers& random) {
    const std::string problem = "2, 3, 3 pins: ";
    Matrix seen(4, Vector(8));
    for (Vector& t : seen)
        for (Residue& number : t)
            number = random();
    const auto points = ten_points(seen);
    report(rank(squares(points)) == 10, problem + "Lemma M25, ten squares are a basis");
    std::array<bool, 2> holds{true, true}; // for the t_v, for the e_j
    for (std::size_t n = 0; n < 10; ++n) {
        const auto maps = maps_of_points(centered_at(points, n, random));
        const bool is_pin = n < 6;
        for (const Third third : {Third::jacobian, Third::normal})
            if (codimension(maps, third, 12, random) > (is_pin ? 3 : 0)) holds[is_pin] = false;
    }
    report(holds[0], problem + "Lemma M29, at the t_v the multiples are all forms");
    report(holds[1], problem + "Lemma M29, at the e_j the multiples have codimension 3");
    const auto maps = maps_of_points(points);
    report(rank_of_cubics(maps, {0, 1}, {2, 3}, random) == 20 &&
               rank_of_cubics(maps, {2, 3}, {0, 1}, random) == 20,
           problem + "Lemma M30, the multiples of the minors are all cubic forms");
}

} // namespace

int main() {
    Numbers random(2026);
    for (const PinCounts& counts :
         {PinCounts{0, 3, 4}, PinCounts{1, 2, 4}, PinCounts{1, 3, 3}, PinCounts{2, 2, 3}}) {
        general_scene(counts, random);
        six_views(counts, random);
    }
    for (const PinCounts& counts : {PinCounts{0, 3, 5}, PinCounts{1, 2, 5}}) {
        general_scene(counts, random);
        five_pins(counts, random);
    }
    four_pins({1, 1}, "0, 2, 4 pins, a: ", random);
    four_pins({0, 1}, "1, 1, 4 pins, a: ", random);
    five_views(random);
    three_pins({1, 1}, "0, 2, 3 pins, a: ", random);
    three_pins({0, 1}, "1, 1, 3 pins, a: ", random);
    general_scene({1, 3, 4}, random);
    curves_of_degree_7(random);
    scene_of_three_pins(random);
    curves_of_bidegree_5(random);
    general_scene({2, 3, 3}, random);
    scene_of_special_line(random);
    special_lines(random);
    return report.status();
}
