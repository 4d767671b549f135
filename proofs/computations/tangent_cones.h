// Lemma V3 of proofs/four_and_five_views.md: at the spurious point U = C^3_v the tangent cones of
// all conditions meet in 0 only, for one example modulo q = 2^61 - 1.
#pragma once

#include "proofs/computations/residue_matrices.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace proofs {

/// A problem of one point with pins, and free lines.
struct StarAndLines {
    std::size_t views = 0, pins = 0, lines = 0;
};

/// The images of one line: covectors (a, b, last), one row (a, b) for each view. All views see the
/// point at (0, 0, 1), so `last` is 0 for a pin; it is 1 for a free line.
struct ImageLines {
    ResidueMatrix rows{};
    Residue last{};
};

inline ResidueRow covector(const ImageLines& line, std::size_t view) {
    return {line.rows[view][0], line.rows[view][1], line.last};
}

/// Two vectors that span the image line of this view.
inline std::array<ResidueRow, 2> span_of(const ImageLines& line, std::size_t view) {
    const ResidueMatrix basis = kernel_of({covector(line, view)}, 3);
    return {basis[0], basis[1]};
}

/// Tangent vectors phi at the spurious point of one view: phi takes a vector of this view to one
/// for each view, 0 for the same view, modulo the images of the point. They have 9 m coordinates;
/// `gauge` are the equations of those that are meant.
struct TangentSpace {
    std::size_t views = 0, spurious = 0;

    std::size_t coordinates() const { return 9 * views; }

    /// The view whose third coordinates of phi are 0.
    std::size_t first() const { return spurious == 0 ? 1 : 0; }

    std::size_t index(std::size_t view, std::size_t to, std::size_t from) const {
        return 9 * view + 3 * to + from;
    }

    /// The linear form of phi that is the covector, in this view, of phi(e).
    ResidueRow form(const ResidueRow& covector, std::size_t view, const ResidueRow& e) const {
        ResidueRow result(coordinates());
        for (std::size_t to = 0; to < 3; ++to)
            for (std::size_t from = 0; from < 3; ++from)
                result[index(view, to, from)] = covector[to] * e[from];
        return result;
    }

    ResidueMatrix gauge() const {
        ResidueMatrix equations;
        const auto append = [&](std::size_t view, std::size_t to) {
            for (std::size_t from = 0; from < 3; ++from) {
                equations.emplace_back(coordinates());
                equations.back()[index(view, to, from)] = {1};
            }
        };
        for (std::size_t to = 0; to < 3; ++to)
            append(spurious, to);
        append(first(), 2);
        return equations;
    }

    /// The equations of a free line.
    ResidueMatrix equations(const ImageLines& line) const {
        ResidueMatrix result;
        for (const ResidueRow& e : span_of(line, spurious)) {
            const ResidueRow of_first = form(covector(line, first()), first(), e);
            for (std::size_t view = 0; view < views; ++view) {
                if (view == spurious || view == first()) continue;
                ResidueRow row = form(covector(line, view), view, e);
                add_multiple(row, -Residue{1}, of_first);
                result.push_back(row);
            }
        }
        return result;
    }
};

/// The values of the minors of size 2 of the matrix that the covectors of a pin, and two vectors
/// that span its image, make of phi.
inline ResidueRow minors_of_pin(const TangentSpace& space, const ImageLines& pin,
                                const ResidueRow& phi) {
    const auto [e, f] = span_of(pin, space.spurious);
    ResidueMatrix columns;
    for (std::size_t view = 0; view < space.views; ++view) {
        if (view == space.spurious) continue;
        const ResidueRow l = covector(pin, view);
        columns.push_back(
            {product(space.form(l, view, e), phi), product(space.form(l, view, f), phi)});
    }
    ResidueRow minors;
    for (std::size_t i = 0; i < columns.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            minors.push_back(columns[i][0] * columns[j][1] - columns[i][1] * columns[j][0]);
    return minors;
}

/// The values at this point of all monomials of this degree.
inline ResidueRow forms_of_degree(const ResidueRow& point, std::size_t degree) {
    // Products of coordinates, and the place of the last one: later factors do not come before it.
    std::vector<std::pair<Residue, std::size_t>> products{{Residue{1}, 0}};
    for (std::size_t i = 0; i < degree; ++i) {
        std::vector<std::pair<Residue, std::size_t>> longer;
        for (const auto& [value, last] : products)
            for (std::size_t n = last; n < point.size(); ++n)
                longer.emplace_back(value * point[n], n);
        products = std::move(longer);
    }
    ResidueRow values;
    for (const auto& [value, last] : products)
        values.push_back(value);
    return values;
}

/// Whether generic images, of this seed, have tangent cones at the spurious point of this view that
/// meet in 0 only. Free lines leave a linear space of phi. It suffices that there the minors of all
/// k pins generate all forms of degree k + 1; forms are known by their values at generic points.
inline bool tangent_cones_meet_in_0(const StarAndLines& problem, std::size_t spurious,
                                    unsigned seed) {
    Residues random(seed);
    const TangentSpace space{problem.views, spurious};
    ResidueMatrix equations = space.gauge();
    for (std::size_t i = 0; i < problem.lines; ++i)
        for (const ResidueRow& row : space.equations({random.matrix(problem.views, 2), {1}}))
            equations.push_back(row);
    const ResidueMatrix basis = kernel_of(equations, space.coordinates());
    if (basis.empty() || problem.pins == 0) return basis.empty();
    std::vector<ImageLines> pins;
    for (std::size_t i = 0; i < problem.pins; ++i)
        pins.push_back({random.matrix(problem.views, 2), {}});
    // The cones are Cohen-Macaulay, and if the problem is balanced, their codimensions m - 2 add up
    // to the dimension of the space. So if they meet in 0 only, the quotient has the Hilbert series
    // (1 + (m - 2) t)^k: degree k + 1 suffices, and degree k would not.
    const std::size_t degree = problem.pins + 1;
    const std::size_t forms = forms_of_degree(ResidueRow(basis.size()), degree).size();
    ResidueMatrix values; // a row for each point
    for (std::size_t i = 0; i < forms; ++i) {
        const ResidueRow point = random.row(basis.size());
        const ResidueRow phi = product({point}, basis).front();
        const ResidueRow factors = forms_of_degree(point, degree - 2);
        values.emplace_back();
        for (const ImageLines& pin : pins)
            for (const Residue minor : minors_of_pin(space, pin, phi))
                for (const Residue factor : factors)
                    values.back().push_back(minor * factor);
    }
    return rank_of(values) == forms;
}

} // namespace proofs
