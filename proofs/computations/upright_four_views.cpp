// What Theorem X needs computed for three points in four views (proofs/upright_focal_depths.md,
// section 6): how many dimensions of a space of forms of degree 9 the equations leave, and where
// they vanish at the boundary. Modulo q = 2^61 - 1. From the folder that holds checker/ and
// proofs/:
//
//   c++ -std=c++20 -O2 -I. proofs/computations/upright_four_views.cpp -lgmp -o upright_four_views
//
// Each line of the output is a fact; exit status 1 if one fails.
#include "proofs/computations/report.h"
#include "proofs/computations/upright_directions.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace proofs;

constexpr std::size_t views = 4, degree = 4;
constexpr std::size_t columns = 2 * views; // x_v, y_v are those with the numbers 2 v and 2 v + 1
constexpr std::size_t first_height = views, unknowns = views + 2; // m_1, ..., m_4, h_Q, h_R
constexpr std::size_t dimensions = 1330;                          // of the space of forms

const Pairs pairs_of_four{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
constexpr std::size_t brackets = 6 * coordinates_of_pair; // [a, b] of different views

using Images = std::array<ResidueRow, views>; // of a point

/// Images of three points O, Q, R; and what they say of the columns.
class Scene {
public:
    explicit Scene(Residues& random) {
        for (Images& point : points_)
            for (ResidueRow& image : point)
                image = random.row(3);
    }

    /// Depths and heights on a line of section 6, through the unit vector of m_t and a point of
    /// Lemma 3: that of O, Q or R, by its number.
    ResidueRow on_line(std::size_t t, std::size_t point) const {
        ResidueRow at(unknowns);
        if (point == 0) {
            for (std::size_t v = 0; v < views; ++v)
                at[v] = -points_[0][v][1].inverse();
            at[first_height] = at[first_height + 1] = {1};
        } else {
            at[first_height + point - 1] = {1};
        }
        at[t] = at[t] + Residue{5};
        return at;
    }

    /// e_a of Q and of R, for each column a.
    std::array<ResidueRow, 2> products_at(const ResidueRow& at) const {
        std::array<ResidueRow, 2> e;
        for (std::size_t point = 0; point < 2; ++point)
            for (std::size_t column = 0; column < columns; ++column) {
                const std::size_t v = column / 2, entry = column % 2 == 0 ? 0 : 2;
                const ResidueRow &origin = points_[0][v], &image = points_[point + 1][v];
                const Residue slope = image[entry] * image[1].inverse();
                e[point].push_back(at[v] * (origin[1] * slope - origin[entry]) +
                                   at[first_height + point] * slope);
            }
        return e;
    }

private:
    std::array<Images, 3> points_;
};

/// A point of the space of unknowns, with the brackets of columns there.
class Place {
public:
    Place(const Scene& scene, ResidueRow at) : unknown(std::move(at)) {
        const auto [q, r] = scene.products_at(unknown);
        for (std::size_t a = 0; a < columns; ++a)
            for (std::size_t b = 0; b < columns; ++b)
                all_brackets_.push_back(q[a] * r[b] - q[b] * r[a]);
        for (const auto& [v, w] : pairs_of_four)
            for (std::size_t i = 0; i < coordinates_of_pair; ++i) {
                const Residue value = bracket(2 * v + i / 2, 2 * w + i % 2);
                coordinates.push_back(i == 2 ? -value : value);
            }
    }

    ResidueRow unknown{};
    ResidueRow coordinates{}; // those of the variety

    Residue bracket(std::size_t a, std::size_t b) const { return all_brackets_[columns * a + b]; }

private:
    ResidueRow all_brackets_;
};

using Places = std::vector<Place>;

bool is_without(std::size_t coordinate, std::size_t view) {
    const auto& [v, w] = pairs_of_four[coordinate / coordinates_of_pair];
    return v != view && w != view;
}

/// Values at places, times those of a random linear form: of Lambda_v if there is a view v.
void multiply(ResidueRow& values, const Places& places, Residues& random,
              std::size_t without_view = views) {
    ResidueRow form = random.row(brackets);
    for (std::size_t i = 0; without_view < views && i < form.size(); ++i)
        if (!is_without(i, without_view)) form[i] = {};
    for (std::size_t i = 0; i < places.size(); ++i)
        values[i] = values[i] * product(form, places[i].coordinates);
}

/// Values times those of so many linear forms and an unknown: one form is of Lambda_v for m_v.
void multiply_with_unknown(ResidueRow& values, std::size_t forms, std::size_t unknown,
                           const Places& places, Residues& random) {
    for (std::size_t i = 0; i < forms; ++i)
        multiply(values, places, random, i == 0 ? std::min(unknown, views) : views);
    for (std::size_t i = 0; i < places.size(); ++i)
        values[i] = values[i] * places[i].unknown[unknown];
}

/// Multiples of the cubic equations.
ResidueMatrix multiples_of(const std::vector<Equation>& cubics, const Places& places,
                           Residues& random) {
    ResidueMatrix rows;
    for (const Equation& equation : cubics) {
        ResidueRow values;
        for (const Place& place : places)
            values.push_back(equation.at(place.coordinates));
        if (values.front() == Residue{}) continue; // holds for any columns in a plane
        constexpr std::size_t multiples = 3;       // for each unknown
        for (std::size_t i = 0; i < multiples * unknowns; ++i)
            multiply_with_unknown(rows.emplace_back(values), degree - 3, i % unknowns, places,
                                  random);
    }
    return rows;
}

/// Multiples of the equation (8) of two views v and w: by Lambda_v, Lambda_w and a height.
ResidueMatrix multiples_of_pairs(const Places& places, Residues& random) {
    constexpr std::size_t multiples = 10; // for each height
    ResidueMatrix rows;
    for (const auto& [v, w] : pairs_of_four) {
        const std::size_t x = 2 * v, y = x + 1, other_x = 2 * w, other_y = other_x + 1;
        ResidueRow values;
        for (const Place& place : places)
            values.push_back(place.bracket(x, y) * place.bracket(x, other_y) +
                             place.bracket(other_x, other_y) * place.bracket(y, other_x));
        for (std::size_t i = 0; i < 2 * multiples; ++i) {
            ResidueRow& row = rows.emplace_back(values);
            multiply(row, places, random, v);
            multiply(row, places, random, w);
            multiply_with_unknown(row, 0, first_height + i % 2, places, random);
        }
    }
    return rows;
}

} // namespace

int main() {
    Report report;
    Residues random(7);
    const std::vector<Equation> cubics =
        equations_of(pairs_of_four, 3, [](const Monomial&) { return true; });
    report(hold_over_the_integers(pairs_of_four, cubics),
           std::to_string(cubics.size()) + " equations of degree 3");

    const Scene scene(random);
    Places places;
    for (std::size_t i = 0; i < dimensions; ++i)
        places.emplace_back(scene, random.row(unknowns));
    for (std::size_t t = 0; t < views; ++t)
        for (std::size_t point = 0; point < 3; ++point)
            places.emplace_back(scene, scene.on_line(t, point));

    ResidueMatrix rows = multiples_of(cubics, places, random);
    for (ResidueRow& row : multiples_of_pairs(places, random))
        rows.push_back(std::move(row));
    const auto vanishes_at_boundary = [&](const ResidueRow& row) {
        return std::all_of(row.begin() + dimensions, row.end(),
                           [](Residue value) { return value == Residue{}; });
    };
    report(std::ranges::all_of(rows, vanishes_at_boundary),
           "all equations vanish at " + std::to_string(places.size() - dimensions) + " lines");
    places.resize(dimensions, places.front());
    for (ResidueRow& row : rows)
        row.resize(dimensions);
    Echelon reduced = echelon(std::move(rows), false);
    const std::size_t left = dimensions - reduced.pivots.size();
    report(left == 247, "3*P in four views: " + std::to_string(left) + " of " +
                            std::to_string(dimensions) + " dimensions are left");

    const ResidueRow form = random.row(brackets);
    for (std::size_t i = 0; i < 2 * left + unknowns; ++i) {
        ResidueRow& row = reduced.rows.emplace_back(dimensions, Residue{1});
        multiply_with_unknown(row, degree - 1, i % unknowns, places, random);
        for (std::size_t k = 0; k < dimensions; ++k)
            row[k] = row[k] * product(form, places[k].coordinates);
    }
    report(rank_of(reduced.rows) == dimensions, "with the multiples of a linear form none is left");
    return report.status();
}
