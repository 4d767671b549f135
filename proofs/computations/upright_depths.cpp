// What Theorem X needs computed (proofs/upright_focal_depths.md): how many dimensions the relations
// of a problem with few lines leave, and how many of them belong to the boundary. Modulo
// q = 2^61 - 1. From the folder that holds checker/ and proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/upright_depths.cpp -lgmp -o upright_depths
//
// Each line of the output is a fact; exit status 1 if one fails.
#include "proofs/computations/report.h"
#include "proofs/computations/upright_directions.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace {

using namespace proofs;

constexpr std::size_t views = 3, degree = 4;
constexpr std::size_t columns = 2 * views; // x_v, y_v are those with the numbers 2 v and 2 v + 1

using Images = std::array<ResidueRow, views>; // of a point or of a line

ResidueRow cross(const ResidueRow& a, const ResidueRow& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Images line_through(const Images& a, const Images& b) {
    Images line;
    for (std::size_t v = 0; v < views; ++v)
        line[v] = cross(a[v], b[v]);
    return line;
}

std::size_t next(std::size_t v) {
    return (v + 1) % views;
}

/// The place in the list of pairs of the one without this view: its coordinates are Lambda_v.
std::size_t pair_without(std::size_t v) {
    return next(v);
}

bool is_in_lambda(const Monomial& monomial, std::size_t v) {
    return std::ranges::any_of(monomial, [&](std::size_t i) { return i / 4 == pair_without(v); });
}

/// The product [a, b] of two columns of different views, from the coordinates.
Residue bracket(const ResidueRow& values, std::size_t a, std::size_t b) {
    if (next(a / 2) != b / 2) return -bracket(values, b, a);
    const Residue value = values[2 * a + b % 2];
    return a % 2 == 1 && b % 2 == 0 ? -value : value;
}

/// A factor of relations: 1, or a combination of the four [p, r] in Lambda_v, for columns p, r of
/// the next two views. It makes [x_v, y_v] a form.
struct Factor {
    std::optional<std::size_t> view{};
    std::array<Residue, 4> combination{};

    /// [a, b] times the factor.
    Residue times(const ResidueRow& values, std::size_t a, std::size_t b) const {
        if (a == b) return {};
        if (!view) return bracket(values, a, b);
        Residue sum;
        for (std::size_t i = 0; i < combination.size(); ++i) {
            const std::size_t p = 2 * next(*view) + i / 2, r = 2 * next(next(*view)) + i % 2;
            sum = sum + combination[i] * (a / 2 == b / 2
                                              ? bracket(values, a, p) * bracket(values, b, r) -
                                                    bracket(values, a, r) * bracket(values, b, p)
                                              : bracket(values, a, b) * bracket(values, p, r));
        }
        return sum;
    }
};

/// A relation of the unknowns m_1, m_2, m_3, and a height for each point but the first one: its
/// coefficients are forms, times those of the factor.
struct Relation {
    std::optional<std::size_t> factor_without_view{};
    std::function<ResidueRow(const ResidueRow& values, const Factor& factor)> coefficients{};
};

/// A problem for random images. The first point is the origin.
struct Problem {
    std::string name{};
    std::vector<std::size_t> pins{}; // of each point
    std::size_t free_lines = 0;
    std::size_t solutions = 0;   // at most
    std::size_t on_curve = 0;    // zeros where rays to a point are parallel (section 4)
    std::size_t at_boundary = 0; // zeros of section 5

    std::size_t zeros() const { return solutions + on_curve + at_boundary; }
};

class Example {
public:
    Example(const Problem& problem, Residues& random) {
        for (std::size_t i = 0; i < problem.pins.size(); ++i)
            points_.push_back(random_images(random));
        for (std::size_t i = 0; i < points_.size(); ++i)
            for (std::size_t j = i + 1; j < points_.size(); ++j)
                lines.push_back(line_through(points_[i], points_[j]));
        for (std::size_t i = 0; i < points_.size(); ++i)
            for (std::size_t pin = 0; pin < problem.pins[i]; ++pin)
                lines.push_back(line_through(points_[i], random_images(random)));
        for (std::size_t i = 0; i < problem.free_lines; ++i)
            free_lines_.push_back(random_images(random));
        lines.insert(lines.end(), free_lines_.begin(), free_lines_.end());
        for (const Images& line : lines)
            forms.push_back(direction_form(line));
        for (std::size_t i = 1; i < points_.size(); ++i)
            add_point(i);
        for (const Images& line : free_lines_)
            add_line(line);
    }

    std::vector<Images> lines{}; // those without points come last
    ResidueMatrix forms{};       // F of each, (2)
    std::vector<Relation> relations{};

    std::size_t unknowns() const { return views + points_.size() - 1; }
    const std::vector<Images>& points() const { return points_; }

private:
    static Images random_images(Residues& random) {
        return {random.row(views), random.row(views), random.row(views)};
    }

    /// [c_v, e] times the factor, where c_v = l_1 x_v + l_3 y_v, and e is a column.
    static Residue seen_with(const ResidueRow& values, const Factor& factor, const Images& line,
                             std::size_t v, std::size_t e) {
        return line[v][0] * factor.times(values, 2 * v, e) +
               line[v][2] * factor.times(values, 2 * v + 1, e);
    }

    /// [c_v, c_w] times the factor.
    static Residue seen(const ResidueRow& values, const Factor& factor, const Images& line,
                        std::size_t v, std::size_t w) {
        return line[w][0] * seen_with(values, factor, line, v, 2 * w) +
               line[w][2] * seen_with(values, factor, line, v, 2 * w + 1);
    }

    /// The relations (3) of a point: triples of columns.
    void add_point(std::size_t place) {
        // A view sees the point at e = m alpha + h beta, by coordinates 1 and 3.
        ResidueRow alpha, beta;
        for (std::size_t column = 0; column < columns; ++column) {
            const ResidueRow &origin = points_[0][column / 2], &image = points_[place][column / 2];
            const std::size_t entry = column % 2 == 0 ? 0 : 2;
            beta.push_back(image[entry] * image[1].inverse());
            alpha.push_back(origin[1] * beta.back() - origin[entry]);
        }
        const std::size_t height = views + place - 1, count = unknowns();
        for (std::size_t a = 0; a < columns; ++a)
            for (std::size_t b = a + 1; b < columns; ++b)
                for (std::size_t c = b + 1; c < columns; ++c) {
                    std::optional<std::size_t> twice;
                    if (a / 2 == b / 2 || b / 2 == c / 2) twice = b / 2;
                    relations.push_back(
                        {twice, [=](const ResidueRow& values, const Factor& factor) {
                             ResidueRow row(count);
                             const std::array<std::size_t, 3> triple{a, b, c};
                             for (std::size_t i = 0; i < triple.size(); ++i) {
                                 const Residue minor =
                                     factor.times(values, triple[(i + 1) % 3], triple[(i + 2) % 3]);
                                 Residue& depth = row[triple[i] / 2];
                                 depth = depth + alpha[triple[i]] * minor;
                                 row[height] = row[height] + beta[triple[i]] * minor;
                             }
                             return row;
                         }});
                }
    }

    /// The relations (4) of a line without points.
    void add_line(const Images& line) {
        std::array<Residue, views> distance;
        for (std::size_t v = 0; v < views; ++v)
            distance[v] = product(line[v], points_[0][v]);
        const std::size_t count = unknowns();
        relations.push_back({std::nullopt, [=](const ResidueRow& values, const Factor& factor) {
                                 ResidueRow row(count);
                                 for (std::size_t v = 0; v < views; ++v)
                                     row[v] = distance[v] *
                                              seen(values, factor, line, next(v), next(next(v)));
                                 return row;
                             }});
        for (std::size_t e = 0; e < columns; ++e)
            relations.push_back({e / 2, [=](const ResidueRow& values, const Factor& factor) {
                                     ResidueRow row(count);
                                     for (std::size_t v = 0; v < views; ++v) {
                                         const std::size_t s = next(v), t = next(s);
                                         row[v] =
                                             distance[v] *
                                             (line[t][1] * seen_with(values, factor, line, s, e) -
                                              line[s][1] * seen_with(values, factor, line, t, e));
                                     }
                                     return row;
                                 }});
    }

    std::vector<Images> points_{}, free_lines_{};
};

/// The equations of degree 4, all of them, and those in products with a factor of Lambda_v.
struct Equations {
    std::vector<Equation> all;
    std::array<std::vector<Equation>, views> in_lambda;

    const std::vector<Equation>& of_unknown(std::size_t unknown) const {
        return unknown < views ? in_lambda[unknown] : all;
    }
};

/// Values of random products at points of a linear space.
class Products {
public:
    Products(const ResidueMatrix& points, Residues& random) : points_(points), random_(random) {}

    /// Of so many linear forms.
    ResidueRow of_degree(std::size_t count) {
        ResidueRow values(points_.size(), Residue{1});
        for (std::size_t i = 0; i < count; ++i)
            multiply(values, random_.row(coordinates));
        return values;
    }

    /// Of so many, one of them in Lambda_v.
    ResidueRow in_lambda(std::size_t count, std::size_t v) {
        ResidueRow values = of_degree(count - 1), form(coordinates);
        for (std::size_t i = 0; i < 4; ++i)
            form[4 * pair_without(v) + i] = random_.next();
        multiply(values, form);
        return values;
    }

private:
    void multiply(ResidueRow& values, const ResidueRow& form) const {
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = values[i] * product(form, points_[i]);
    }

    const ResidueMatrix& points_;
    Residues& random_;
};

std::size_t count_of(std::size_t things) {
    return monomials(things, degree).size();
}

/// What is left of the module of degree 4, also with multiples of one linear form; and whether the
/// linear forms of the lines are independent, with those of any Lambda_v.
struct Left {
    std::size_t dimensions = 0, with_multiples = 0;
    bool independent = false;
};

Left left_of(const Example& example, const Equations& equations, Residues& random) {
    const ResidueMatrix space = kernel_of(example.forms, coordinates);
    const std::size_t dimension = space.size(), points = count_of(dimension);
    const ResidueMatrix at = product(random.matrix(points, dimension), space);
    const std::size_t unknowns = example.unknowns();
    bool independent = true;
    for (std::size_t v = 0; v < views; ++v) {
        ResidueMatrix with_lambda = example.forms;
        for (std::size_t i = 0; i < 4; ++i)
            with_lambda.emplace_back(coordinates)[4 * pair_without(v) + i] = {1};
        independent = independent && rank_of(with_lambda) == with_lambda.size();
    }
    const auto put = [&](ResidueRow& row, std::size_t unknown, const ResidueRow& values) {
        std::ranges::copy(values, row.begin() + static_cast<std::ptrdiff_t>(unknown * points));
    };
    Products products(at, random);
    ResidueMatrix rows;
    for (std::size_t unknown = 0; unknown < unknowns; ++unknown)
        for (const Equation& equation : equations.of_unknown(unknown)) {
            ResidueRow values;
            for (const ResidueRow& point : at)
                values.push_back(equation.at(point));
            put(rows.emplace_back(unknowns * points), unknown, values);
        }
    constexpr std::size_t multiples = 40; // of each relation
    for (const Relation& relation : example.relations)
        for (std::size_t i = 0; i < multiples; ++i) {
            Factor factor{relation.factor_without_view, {}};
            for (Residue& number : factor.combination)
                number = random.next();
            const ResidueRow multiple = products.of_degree(factor.view ? degree - 2 : degree - 1);
            ResidueRow& row = rows.emplace_back(unknowns * points);
            for (std::size_t k = 0; k < points; ++k) {
                const ResidueRow coefficients = relation.coefficients(at[k], factor);
                for (std::size_t unknown = 0; unknown < unknowns; ++unknown)
                    row[unknown * points + k] = multiple[k] * coefficients[unknown];
            }
        }
    // Forms of degree 4 on the space; for the first unknowns those in the ideal of Lambda_v.
    const std::size_t all = unknowns * points - views * count_of(dimension - 4);
    Echelon reduced = echelon(std::move(rows), false);
    const std::size_t rank = reduced.pivots.size();
    const ResidueRow form = random.row(coordinates);
    for (std::size_t unknown = 0; unknown < unknowns; ++unknown)
        for (std::size_t i = 0; i < 2 * (all - rank); ++i) {
            ResidueRow values = unknown < views ? products.in_lambda(degree - 1, unknown)
                                                : products.of_degree(degree - 1);
            for (std::size_t k = 0; k < points; ++k)
                values[k] = values[k] * product(form, at[k]);
            put(reduced.rows.emplace_back(unknowns * points), unknown, values);
        }
    return {all - rank, all - rank_of(reduced.rows), independent};
}

/// The coordinates where the columns are (u_a, k_a). At the boundary (section 5) u is 0 for one
/// view, and k for the others.
ResidueRow point_of(const ResidueRow& u, const ResidueRow& k) {
    ResidueRow point(coordinates);
    for (std::size_t a = 0; a < columns; ++a)
        for (std::size_t j = 0; j < 2; ++j) {
            const std::size_t b = 2 * next(a / 2) + j;
            const Residue value = u[a] * k[b] - k[a] * u[b];
            point[2 * a + j] = a % 2 == 1 && j == 0 ? -value : value;
        }
    return point;
}

/// On the pencil of all u between two: the one where the planes of a line in two views are equally
/// far from the origin, if it is so for the second point (section 5).
ResidueRow with_distances(const Example& example, const ResidueMatrix& pencil, const Images& line,
                          std::size_t t) {
    const Images &origin = example.points()[0], &point = example.points()[1];
    const Images& join = example.lines.front();
    ResidueRow differences;
    for (const ResidueRow& u : pencil) {
        std::array<Residue, 2> distances;
        for (std::size_t i = 0; i < 2; ++i) {
            const std::size_t v = next(i == 0 ? t : next(t));
            const Residue first = u[2 * v], third = u[2 * v + 1];
            const Residue height =
                -(join[v][0] * first + join[v][2] * third) * join[v][1].inverse();
            const ResidueRow through = cross(point[v], {{1}, {}, {}});
            const Residue depth =
                -product(through, {first, height, third}) * product(through, origin[v]).inverse();
            distances[i] = product(line[v], origin[v]) * depth;
        }
        differences.push_back(line[next(t)][1] * distances[1] -
                              line[next(next(t))][1] * distances[0]);
    }
    ResidueRow u(columns);
    add_multiple(u, differences[1], pencil[0]);
    add_multiple(u, -differences[0], pencil[1]);
    return u;
}

/// The u of the boundary where view t is the other one, and lines but a special one agree (section
/// 5).
ResidueRow where_lines_agree(const Example& example, std::size_t t, std::size_t special) {
    const std::size_t v = next(t), w = next(v);
    ResidueMatrix conditions(2, ResidueRow(columns));
    conditions[0][2 * t] = conditions[1][2 * t + 1] = {1};
    for (std::size_t i = 0; i < example.lines.size(); ++i) {
        if (i == special) continue;
        const Images& line = example.lines[i];
        ResidueRow& condition = conditions.emplace_back(columns);
        condition[2 * v] = line[w][1] * line[v][0];
        condition[2 * v + 1] = line[w][1] * line[v][2];
        condition[2 * w] = -(line[v][1] * line[w][0]);
        condition[2 * w + 1] = -(line[v][1] * line[w][2]);
    }
    const ResidueMatrix solutions = kernel_of(conditions, columns);
    if (solutions.size() == 1) return solutions[0];
    const std::size_t last = example.lines.size() - 1; // this one and that before have no points
    return with_distances(example, solutions, example.lines[special == last ? last - 1 : last], t);
}

/// Whether this is a point of the variety where some unknowns, with any depth of view t, meet all
/// relations.
bool has_zero(const Example& example, const Equations& equations, const ResidueRow& point,
              std::size_t t) {
    const auto vanishes = [&](const Equation& equation) { return equation.at(point) == Residue{}; };
    const auto contains = [&](const ResidueRow& form) { return product(form, point) == Residue{}; };
    if (!std::ranges::all_of(equations.all, vanishes)) return false;
    if (!std::ranges::all_of(example.forms, contains)) return false;
    ResidueMatrix on_unknowns;
    for (const Relation& relation : example.relations)
        for (std::size_t i = 0; i < 4; ++i) {
            Factor factor{relation.factor_without_view, {}};
            factor.combination[i] = {1};
            on_unknowns.push_back(relation.coefficients(point, factor));
            on_unknowns.back()[t] = {};
        }
    return rank_of(on_unknowns) + 1 < example.unknowns();
}

/// How many points of the boundary have unknowns that meet all relations.
std::size_t at_boundary(const Example& example, const Equations& equations) {
    std::size_t count = 0;
    for (std::size_t t = 0; t < views; ++t)
        for (std::size_t special = 0; special < example.lines.size(); ++special) {
            const ResidueRow& line = example.lines[special][t];
            ResidueRow k(columns);
            k[2 * t] = line[2];
            k[2 * t + 1] = -line[0];
            const ResidueRow u = where_lines_agree(example, t, special);
            if (has_zero(example, equations, point_of(u, k), t)) ++count;
        }
    return count;
}
} // namespace

int main() {
    Report report;
    const auto everything = [](const Monomial&) { return true; };
    Equations equations{equations_of(pairs, degree, everything), {}};
    for (std::size_t v = 0; v < views; ++v)
        equations.in_lambda[v] = equations_of(
            pairs, degree, [&](const Monomial& monomial) { return is_in_lambda(monomial, v); });
    for (std::size_t unknown = 0; unknown <= views; ++unknown) {
        const std::vector<Equation>& some = equations.of_unknown(unknown);
        report(hold_over_the_integers(pairs, some),
               std::to_string(some.size()) + " equations of degree 4" +
                   (unknown < views ? ", with a factor without view " + std::to_string(unknown + 1)
                                    : ""));
    }
    Residues random(4);
    for (const Problem& problem :
         {Problem{"Pa + 3*a", {1}, 3, 60, 0, 0}, Problem{"P + Pab + a", {0, 2}, 1, 52, 7, 3},
          Problem{"2*Pa + a", {1, 1}, 1, 59, 0, 3}, Problem{"2*P + Pa", {0, 0, 1}, 0, 51, 7, 6},
          Problem{"2*P + 2*a", {0, 0}, 2, 42, 0, 6}}) {
        const Example example(problem, random);
        const Left left = left_of(example, equations, random);
        report(left.dimensions == problem.zeros(),
               problem.name + ": " + std::to_string(left.dimensions) + " dimensions are left");
        report(left.with_multiples == 0, "with the multiples of a linear form none is left");
        report(left.independent, "the forms of its lines are independent");
        const std::size_t at = at_boundary(example, equations);
        report(at == problem.at_boundary, std::to_string(at) + " of them belong to the boundary");
    }
    return report.status();
}
