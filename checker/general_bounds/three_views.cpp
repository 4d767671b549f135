#include "checker/general_bounds/three_views.h"

#include "checker/general_bounds/small_field.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace checker {
/// The coordinate in row a and column j of the camera of view v has the weight h_v - x_j +
/// u[v][j][a] of the torus.
using Shifts = std::array<std::array<Row3, 4>, 3>;

/// The Chern roots of V and those of the line bundles, where the torus fixes a point.
struct ChernRoots {
    std::array<Small, 4> x{};
    std::array<Small, 3> h{}; // h_1 = 0
};

/// Bit 3 j + v is the edge between x_j and h_v.
using Graph = unsigned;

/// An edge of a tree, which yields one of its ends from the other.
struct Edge {
    std::size_t j = 0, v = 0;
    bool yields_x = false; // else h_v
};

using Tree = std::vector<Edge>; // from h_1 to the leaves

/// The classes of features: of a free line, and of points with 0 to 4 pins.
constexpr std::size_t most_pins = 4;
constexpr std::size_t of_free_line = 0;
constexpr std::size_t of_point = 1; // add the number of its pins
using ChernClasses = std::array<Small, of_point + most_pins + 1>;

/// What a fixed point adds to an integral is the weight times the values of the classes.
struct TorusFixedPoint {
    Small weight{};
    ChernClasses classes{};
};

/// The edges at x_j, if the vertex is j < 4, or at h_v, if it is 4 + v.
static Graph edges_at(std::size_t vertex) {
    return vertex < 4 ? 0b111U << (3 * vertex) : 0b001'001'001'001U << (vertex - 4);
}

static std::optional<std::size_t> leaf_of(Graph graph) {
    constexpr std::size_t h_1 = 4;
    for (std::size_t vertex = 0; vertex < 7; ++vertex)
        if (vertex != h_1 && std::has_single_bit(graph & edges_at(vertex))) return vertex;
    return std::nullopt;
}

/// A graph of six edges as a tree; none if it has a cycle or is not stable. A tree is stable if
/// something flows along each edge when each x_j sends 3, and each h_v takes 4.
static std::optional<Tree> stable_tree(Graph graph) {
    std::array<int, 7> supply{3, 3, 3, 3, -4, -4, -4};
    Tree tree;
    while (graph != 0) {
        const std::optional<std::size_t> leaf = leaf_of(graph);
        if (!leaf) return std::nullopt;
        const auto edge = static_cast<std::size_t>(std::countr_zero(graph & edges_at(*leaf)));
        const std::size_t j = edge / 3, v = edge % 3;
        const bool is_x = *leaf < 4;
        if ((supply[*leaf] > 0) != is_x) return std::nullopt;
        supply[is_x ? 4 + v : j] += supply[*leaf];
        tree.push_back({j, v, is_x});
        graph &= ~(Graph{1} << edge);
    }
    std::ranges::reverse(tree);
    return tree;
}

/// The point where one coordinate for each edge, in this row, has weight 0.
static ChernRoots roots_at(const Tree& tree, const std::array<std::size_t, 6>& rows,
                           const Shifts& u) {
    ChernRoots roots;
    for (std::size_t i = 0; i < tree.size(); ++i) {
        const auto [j, v, yields_x] = tree[i];
        const Small shift = u[v][j][rows[i]];
        if (yields_x)
            roots.x[j] = roots.h[v] + shift;
        else
            roots.h[v] = roots.x[j] - shift;
    }
    return roots;
}

/// The product of x_l - x_j over the l that are not j.
static Small differences(const ChernRoots& roots, std::size_t j) {
    Small product{1};
    for (std::size_t l = 0; l < 4; ++l)
        if (l != j) product = product * (roots.x[l] - roots.x[j]);
    return product;
}

/// The inverse of a number that generic shifts do not let vanish.
static Small inverse(Small number) {
    if (number == Small{}) throw std::logic_error("the shifts are not generic");
    return number.inverse();
}

/// The product of all x_i - x_j by that of all weights but six, those of the tree, which are 0.
static Small weight_at(const ChernRoots& roots, const Shifts& u) {
    Small above{1}, below{1};
    std::size_t zeros = 0;
    for (std::size_t j = 0; j < 4; ++j) {
        above = above * differences(roots, j);
        for (std::size_t v = 0; v < 3; ++v)
            for (const Small shift : u[v][j]) {
                const Small weight = roots.h[v] - roots.x[j] + shift;
                if (weight == Small{})
                    ++zeros;
                else
                    below = below * weight;
            }
    }
    if (zeros != 6) throw std::logic_error("the shifts are not generic");
    return above * below.inverse();
}

/// c_1^2 - c_2 of L_1 + L_2 + L_3 - V.
static Small class_of_free_line(const ChernRoots& roots) {
    Small c1, c2;
    for (const Small h : roots.h) {
        c2 = c2 + c1 * h;
        c1 = c1 + h;
    }
    for (const Small x : roots.x) {
        c1 = c1 - x;
        c2 = c2 - c1 * x;
    }
    return c1 * c1 - c2;
}

static ChernClasses classes_at(const ChernRoots& roots) {
    const auto& [x, h] = roots;
    ChernClasses classes;
    classes[of_free_line] = class_of_free_line(roots);
    for (std::size_t j = 0; j < 4; ++j) {
        const Small at_point = (h[0] - x[j]) * (h[1] - x[j]) * (h[2] - x[j]);
        const Small pin = h[0] + h[1] + h[2] - (x[0] + x[1] + x[2] + x[3] - x[j]);
        Small term = at_point * at_point * inverse(differences(roots, j));
        for (std::size_t pins = 0; pins <= most_pins; ++pins) {
            classes[of_point + pins] = classes[of_point + pins] + term;
            term = term * pin;
        }
    }
    return classes;
}

static Shifts generic_shifts() {
    Choices choices;
    Shifts shifts;
    for (auto& view : shifts)
        for (Row3& column : view)
            for (Small& shift : column)
                shift = choices.next();
    return shifts;
}

/// Those of a tree: one for each choice of a row for each edge.
static void append_fixed_points(std::vector<TorusFixedPoint>& points, const Tree& tree,
                                const Shifts& shifts) {
    constexpr unsigned choices_of_rows = 729;
    for (unsigned choice = 0; choice < choices_of_rows; ++choice) {
        std::array<std::size_t, 6> rows{};
        unsigned digits = choice;
        for (std::size_t& row : rows) {
            row = digits % 3;
            digits /= 3;
        }
        const ChernRoots roots = roots_at(tree, rows, shifts);
        points.push_back({weight_at(roots, shifts), classes_at(roots)});
    }
}

static std::vector<TorusFixedPoint> fixed_points() {
    const Shifts shifts = generic_shifts();
    std::vector<TorusFixedPoint> points;
    for (Graph graph = 0; graph < 1U << 12; ++graph) {
        if (std::popcount(graph) != 6) continue;
        if (const auto tree = stable_tree(graph)) append_fixed_points(points, *tree, shifts);
    }
    return points;
}

/// The place of the class of each feature; none if the theorem does not speak of one of them.
static std::optional<Indices> features_of(const Problem& problem) {
    Indices list;
    for (const Line& line : problem.lines) {
        if (line.points.size() > 1) return std::nullopt;
        if (line.points.empty()) list.push_back(of_free_line);
    }
    for (const Point& point : problem.points) {
        if (point.lines.size() > most_pins) return std::nullopt;
        list.push_back(of_point + point.lines.size());
    }
    return list;
}

/// The integral of a product of classes. By Martin's theorem it is one over a toric variety, by the
/// order of the Weyl group.
static Small integral(const Indices& list) {
    static const std::vector<TorusFixedPoint> points = fixed_points();
    constexpr Small order{24};
    Small sum;
    for (const TorusFixedPoint& point : points) {
        Small product = point.weight;
        for (const std::size_t feature : list)
            product = product * point.classes[feature];
        sum = sum + product;
    }
    return sum * order.inverse();
}

std::optional<std::size_t> degree_in_three_views(const Problem& problem) {
    const bool applies = problem.cameras->all_matrices && std::popcount(problem.views) == 3 &&
                         all_views_see_all(problem) && surplus(problem) == 0;
    if (!applies) return std::nullopt;
    const std::optional<Indices> list = features_of(problem);
    if (!list) return std::nullopt;
    return integral(*list).value; // itself, as it is at most 3^14
}
} // namespace checker
