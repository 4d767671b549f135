// The integrals of Theorem N (proofs/five_pins.md) by a second method: fixed points of a torus on
// the whole space N, modulo q = 2^61 - 1, instead of the surface M_5. And the two camera triples
// that see the same lines.
#include "checker/algebra/modular.h"
#include "proofs/computations/star_cameras.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <optional>
#include <random>

using checker::Residue;
using proofs::star::ManyPins;

namespace {

constexpr Residue zero{0}, one{1};

Residue residue_of(int x) {
    return x < 0 ? -Residue::of(static_cast<std::uint64_t>(-x))
                 : Residue::of(static_cast<std::uint64_t>(x));
}

Residue power(Residue x, unsigned exponent) {
    Residue product = one;
    for (unsigned i = 0; i < exponent; ++i)
        product = product * x;
    return product;
}

/// The weights of the views in the stability, ten times.
using Weights = std::array<int, 3>;

struct Edge {
    std::size_t j = 0, v = 0;
    bool yields_x = false; // else h_v
};

/// Bit 3 j + v is the edge from x_j to h_v. Vertices are the three x_j and the three h_v.
unsigned edges_at(std::size_t vertex) {
    return vertex < 3 ? 0b111U << (3 * vertex) : 0b001'001'001U << (vertex - 3);
}

std::optional<std::size_t> leaf_of(unsigned graph) {
    for (const std::size_t vertex : {0U, 1U, 2U, 4U, 5U}) // not h_1
        if (std::has_single_bit(graph & edges_at(vertex))) return vertex;
    return std::nullopt;
}

/// Five edges as a tree, from h_1 to the leaves; none if it has a cycle or is not stable: each x_j
/// sends 10, each h_v takes its weight, and something has to flow along each edge.
std::optional<std::vector<Edge>> stable_tree(unsigned graph, const Weights& weights) {
    std::array<int, 6> supply{10, 10, 10, -weights[0], -weights[1], -weights[2]};
    std::vector<Edge> tree;
    while (graph != 0) {
        const auto leaf = leaf_of(graph);
        if (!leaf) return std::nullopt;
        const auto edge = static_cast<std::size_t>(std::countr_zero(graph & edges_at(*leaf)));
        const std::size_t j = edge / 3, v = edge % 3;
        const bool is_x = *leaf < 3;
        if ((supply[*leaf] > 0) != is_x || supply[*leaf] == 0) return std::nullopt;
        supply[is_x ? 3 + v : j] += supply[*leaf];
        tree.push_back({j, v, is_x});
        graph &= ~(1U << edge);
    }
    std::ranges::reverse(tree);
    return tree;
}

/// The Chern roots x of Q, h of the line bundles, and y of H, and the weight, at a fixed point of
/// M_1.
struct FixedPoint {
    Residue weight{};
    std::array<Residue, 3> x{}, h{};
    std::array<Residue, 6> y{};
};

/// The torus multiplies the coordinate in row a and column j of A_v by one number, and the summand
/// L_v of H by another.
struct Shifts {
    std::array<std::array<std::array<Residue, 2>, 3>, 3> of_coordinate{}; // [v][j][a]
    std::array<Residue, 3> of_summand{};
};

Shifts generic_shifts(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Shifts shifts;
    for (auto& view : shifts.of_coordinate)
        for (auto& column : view)
            for (Residue& shift : column)
                shift = Residue::of(random());
    for (Residue& shift : shifts.of_summand)
        shift = Residue::of(random());
    return shifts;
}

/// The product of x_i - x_j over all i, j that differ.
Residue roots_of_the_group(const std::array<Residue, 3>& x) {
    Residue product = one;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            if (i != j) product = product * (x[i] - x[j]);
    return product;
}

/// The product of the weights of all coordinates but those of the tree, which are 0.
Residue normal_weight(const FixedPoint& point, const Shifts& shifts) {
    Residue product = one;
    int zeros = 0;
    for (std::size_t v = 0; v < 3; ++v) {
        for (std::size_t j = 0; j < 3; ++j) {
            for (const Residue shift : shifts.of_coordinate[v][j]) {
                const Residue weight = point.h[v] - point.x[j] + shift;
                if (weight == zero)
                    ++zeros;
                else
                    product = product * weight;
            }
        }
    }
    REQUIRE(zeros == 5);
    return product;
}

/// Bit i of the rows is the row of the i-th edge.
FixedPoint fixed_point(const std::vector<Edge>& tree, unsigned rows, const Shifts& shifts) {
    FixedPoint point;
    for (std::size_t i = 0; i < tree.size(); ++i) {
        const auto& [j, v, yields_x] = tree[i];
        const Residue shift = shifts.of_coordinate[v][j][rows >> i & 1U];
        if (yields_x)
            point.x[j] = point.h[v] + shift;
        else
            point.h[v] = point.x[j] - shift;
    }
    const Residue order{6};
    point.weight = roots_of_the_group(point.x) * (order * normal_weight(point, shifts)).inverse();
    for (std::size_t i = 0; i < 3; ++i) {
        point.y[i] = point.x[i];
        point.y[3 + i] = point.h[i] + shifts.of_summand[i];
    }
    return point;
}

std::vector<FixedPoint> fixed_points(const Weights& weights, std::uint64_t seed) {
    const Shifts shifts = generic_shifts(seed);
    std::vector<FixedPoint> points;
    for (unsigned graph = 0; graph < 1U << 9; ++graph) {
        if (std::popcount(graph) != 5) continue;
        const auto tree = stable_tree(graph, weights);
        if (!tree) continue;
        for (unsigned rows = 0; rows < 1U << 5; ++rows)
            points.push_back(fixed_point(*tree, rows, shifts));
    }
    return points;
}

Residue sum_of(const std::array<Residue, 3>& all) {
    return all[0] + all[1] + all[2];
}

/// c_1^2 - c_2 of L_1 + L_2 + L_3 - V, with the roots of V.
Residue free_line(const FixedPoint& point, const std::vector<Residue>& roots) {
    Residue c1, c2;
    for (const Residue h : point.h) {
        c2 = c2 + c1 * h;
        c1 = c1 + h;
    }
    for (const Residue x : roots) {
        c1 = c1 - x;
        c2 = c2 - c1 * x;
    }
    return c1 * c1 - c2;
}

/// Section 4 of proofs/moduli.md.
Residue point_with(unsigned pins, const FixedPoint& point, const std::vector<Residue>& roots) {
    Residue sum;
    for (const Residue x : roots) {
        Residue above = one, below = one, pin = sum_of(point.h) + x;
        for (const Residue h : point.h)
            above = above * (h - x) * (h - x);
        for (const Residue other : roots) {
            pin = pin - other;
            if (!(other == x)) below = below * (other - x);
        }
        sum = sum + above * power(pin, pins) * below.inverse();
    }
    return sum;
}

/// Over the fibre of N: its fixed points are the sets of four roots of H, those of V.
Residue integral_over_fibre(const FixedPoint& point, const ManyPins& features) {
    Residue sum;
    for (unsigned chosen = 0; chosen < 1U << 6; ++chosen) {
        if (std::popcount(chosen) != 4) continue;
        std::vector<Residue> roots, others;
        for (std::size_t i = 0; i < 6; ++i)
            (chosen >> i & 1U ? roots : others).push_back(point.y[i]);
        Residue below = one, product = one;
        for (const Residue in : roots)
            for (const Residue out : others)
                below = below * (out - in);
        for (const unsigned pins : features.others)
            product = product * point_with(pins, point, roots);
        product = product * power(free_line(point, roots), features.lines);
        sum = sum + product * below.inverse();
    }
    return sum;
}

Residue integral(const std::vector<FixedPoint>& points, const ManyPins& features) {
    Residue sum;
    for (const FixedPoint& point : points) {
        const Residue tau = sum_of(point.h) - sum_of(point.x);
        sum = sum + point.weight * power(tau, features.pins) * integral_over_fibre(point, features);
    }
    return sum;
}

/// The degree of the integrand, which is 15 for balanced problems.
unsigned degree_of(const ManyPins& features) {
    unsigned degree = features.pins + 2 * features.lines;
    for (const unsigned pins : features.others)
        degree += 3 + pins;
    return degree;
}

/// All with five to seven pins at a point, and no more at others, up to this degree.
std::vector<ManyPins> features_up_to(unsigned most) {
    std::vector<ManyPins> all{{5, {}, 0}, {6, {}, 0}, {7, {}, 0}};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const unsigned last = all[i].others.empty() ? all[i].pins : all[i].others.back();
        for (unsigned pins = 0; pins <= last; ++pins) {
            ManyPins more = all[i];
            more.others.push_back(pins);
            if (degree_of(more) <= most) all.push_back(more);
        }
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        ManyPins more = all[i];
        ++more.lines;
        if (degree_of(more) <= most) all.push_back(more);
    }
    return all;
}

/// The images A_u a_v of the kernels of the other cameras, which are a basis of Q; A_u a_u = 0.
using Kernels = std::array<std::array<std::array<Residue, 2>, 3>, 3>;

/// A linear form of each R_v.
using Line = std::array<std::array<Residue, 2>, 3>;

Residue product(const std::array<Residue, 2>& form, const std::array<Residue, 2>& at) {
    return form[0] * at[0] + form[1] * at[1];
}

/// The two products in T_A at this line, of forms at A_1 a_2, A_2 a_3, A_3 a_1 and at the others,
/// if the kernels a_v are the basis of Q.
std::array<Residue, 2> terms(const Kernels& at, const Line& line) {
    std::array<Residue, 2> both{one, one};
    for (std::size_t u = 0; u < 3; ++u) {
        const std::size_t v = (u + 1) % 3, w = (u + 2) % 3;
        both[0] = both[0] * product(line[u], at[u][v]);
        both[1] = both[1] * product(line[u], at[u][w]);
    }
    return both;
}

/// Whether cameras with these images of kernels see all lines, for one ratio of the two terms.
bool some_cameras_see(const std::vector<Line>& lines, const Kernels& at) {
    const auto first = terms(at, lines.front());
    return std::ranges::all_of(lines, [&](const Line& line) {
        const auto here = terms(at, line);
        return first[0] * here[1] == first[1] * here[0];
    });
}

/// The image of a random point of Q by the cameras that take the basis of Q to these vectors.
Line random_line(const Kernels& at, std::mt19937_64& random) {
    Line line{};
    for (std::size_t v = 0; v < 3; ++v) {
        const Residue coordinate = Residue::of(random());
        for (std::size_t u = 0; u < 3; ++u) {
            line[u][0] = line[u][0] + coordinate * at[u][v][1];
            line[u][1] = line[u][1] - coordinate * at[u][v][0];
        }
    }
    return line;
}

} // namespace

TEST_CASE("Theorem N: integrals over the whole space of star cameras") {
    const auto points = fixed_points({8, 11, 11}, 1);
    int balanced = 0;
    for (const ManyPins& features : features_up_to(15)) {
        if (degree_of(features) < 15) {
            CHECK(integral(points, features) == zero);
        } else {
            ++balanced;
            CHECK(integral(points, features) == residue_of(static_cast<int>(zeros(features))));
        }
    }
    CHECK(balanced >= 15);
}

TEST_CASE("Theorem N: no choice of stability and torus matters") {
    const std::vector<ManyPins> some{{5, {}, 5}, {5, {5}, 1}, {5, {1}, 3}, {6, {6}, 0}};
    for (const Weights& weights : {Weights{11, 8, 11}, Weights{9, 9, 12}}) {
        const auto points = fixed_points(weights, 7);
        for (const ManyPins& features : some)
            CHECK(integral(points, features) == residue_of(static_cast<int>(zeros(features))));
    }
}

TEST_CASE("Lemma N1: two camera triples have a generic tensor") {
    Residue sum;
    for (const FixedPoint& point : fixed_points({8, 11, 11}, 3))
        sum = sum + point.weight * power(sum_of(point.h) - sum_of(point.x), 7);
    CHECK(sum == Residue{2});
}

TEST_CASE("Lemma N1: which two triples see the same lines") {
    std::mt19937_64 random(11);
    Kernels images{}, swapped{};
    for (std::size_t u = 0; u < 3; ++u)
        for (const std::size_t v : {(u + 1) % 3, (u + 2) % 3})
            images[u][v] = swapped[u][3 - u - v] = {Residue::of(random()), Residue::of(random())};
    std::vector<Line> lines;
    for (int i = 0; i < 7; ++i)
        lines.push_back(random_line(images, random));
    CHECK(some_cameras_see(lines, images));
    CHECK(some_cameras_see(lines, swapped));
    swapped[0] = images[0];
    CHECK_FALSE(some_cameras_see(lines, swapped));
}
