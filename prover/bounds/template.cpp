#include "prover/bounds/template.h"

#include <algorithm>

namespace plprove::bounds {

namespace {

/// The columns of the pivots of the reduced row echelon form.
std::vector<int> pivots(const ResidueMatrix& matrix) {
    ResidueMatrix echelon(matrix.rows(), matrix.columns());
    nmod_mat_set(echelon.get(), matrix.get());
    const int rank = static_cast<int>(nmod_mat_rref(echelon.get()));
    std::vector<int> found;
    for (int row = 0, column = 0; row < rank; ++row, ++column) {
        while (echelon.at(row, column) == 0)
            ++column;
        found.push_back(column);
    }
    return found;
}

/// All multiples of the equations up to a degree, as rows of a matrix.
struct Multiples {
    std::vector<std::pair<std::size_t, std::size_t>> names; // equation, monomial
    std::vector<Polynomial> polynomials;
};

Multiples multiples(const RotationRing& ring, const std::vector<Equation>& equations,
                    const std::vector<Monomial>& monomials, const BiDegree& degree) {
    Multiples all;
    for (std::size_t e = 0; e < equations.size(); ++e)
        for (std::size_t m = 0; m < monomials.size() && !equations[e].polynomial.empty(); ++m)
            if (at_most(sum(equations[e].degree, ring.degree(monomials[m])), degree)) {
                all.names.emplace_back(e, m);
                all.polynomials.push_back(
                    ring.product(equations[e].polynomial, Polynomial{{monomials[m], 1}}));
            }
    return all;
}

/// The template of this degree, if there is one with a smaller basis.
std::optional<Template> find_template(const RotationRing& ring,
                                      const std::vector<Equation>& equations,
                                      const BiDegree& degree, std::size_t smaller_than) {
    const std::vector<Monomial> monomials = ring.monomials(degree);
    const Multiples all = multiples(ring, equations, monomials, degree);
    const auto is_inner = [&](const Monomial& m) {
        return at_most(sum(ring.degree(m), ring.unit()), degree);
    };
    // Monomials that cannot be in the basis come first, so that they are eliminated first.
    std::vector<std::size_t> order(monomials.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
        const BiDegree d = ring.degree(monomials[i]);
        return std::pair(is_inner(monomials[i]), -(d[0] + d[1]));
    });
    std::map<Monomial, int> column;
    for (std::size_t i = 0; i < order.size(); ++i)
        column[monomials[order[i]]] = static_cast<int>(i);
    const int rows = static_cast<int>(all.names.size());
    const int columns = static_cast<int>(monomials.size());
    ResidueMatrix matrix(rows, columns);
    ResidueMatrix transposed(columns, rows);
    for (int row = 0; row < rows; ++row)
        for (const auto& [m, x] : all.polynomials[static_cast<std::size_t>(row)])
            matrix.at(row, column.at(m)) = transposed.at(column.at(m), row) = x;

    const std::vector<int> eliminated = pivots(matrix);
    Template found;
    found.degree = degree;
    for (int i = 0; i < columns; ++i)
        if (!std::ranges::binary_search(eliminated, i))
            found.basis.push_back(order[static_cast<std::size_t>(i)]);
    std::ranges::sort(found.basis);
    if (found.basis.empty() || found.basis.size() >= smaller_than) return {};
    for (const std::size_t i : found.basis)
        if (!is_inner(monomials[i])) return {};

    // Columns in the order of the file; rows independent, the first ones.
    std::map<Monomial, int> place;
    for (std::size_t i = 0; i < monomials.size(); ++i)
        if (!std::ranges::binary_search(found.basis, i))
            place.emplace(monomials[i], static_cast<int>(place.size()));
    const int size = static_cast<int>(place.size());
    ResidueMatrix square(size, size);
    int next = 0;
    for (const int row : pivots(transposed)) {
        const auto& [equation, monomial] = all.names[static_cast<std::size_t>(row)];
        if (found.rows.empty() || found.rows.back().first != equation)
            found.rows.push_back({equation, {}});
        found.rows.back().second.push_back(monomial);
        for (const auto& [m, x] : all.polynomials[static_cast<std::size_t>(row)])
            if (const auto at = place.find(m); at != place.end()) square.at(next, at->second) = x;
        ++next;
    }
    found.minor = nmod_mat_det(square.get());
    return found;
}

} // namespace

std::optional<Template> find_template(const RegistrationData& data, Frame frame) {
    const RotationRing ring = rotation_ring(frame);
    const std::vector<Equation> all = equations(data, frame);
    std::optional<Template> best;
    std::vector<BiDegree> degrees;
    for (int a = 1; a <= (frame == Frame::general ? 5 : 6); ++a)
        for (int b = 0; b <= (frame == Frame::general ? 0 : 6); ++b)
            if (frame == Frame::general || b > 0) degrees.push_back({a, b});
    std::ranges::stable_sort(degrees, {},
                             [&](const BiDegree& d) { return ring.monomials(d).size(); });
    for (const BiDegree& degree : degrees)
        if (auto found = find_template(ring, all, degree, best ? best->basis.size() : SIZE_MAX))
            best = std::move(found);
    if (best) {
        best->frame = frame;
        best->data = data;
    }
    return best;
}

std::optional<Template> best_template(const Registration& type) {
    std::optional<Template> best;
    for (const Frame frame : {Frame::general, Frame::line, Frame::points, Frame::lines})
        if (suits(frame, type)) {
            auto found = find_template(draw_data(type, frame, 1), frame);
            if (found && (!best || found->basis.size() < best->basis.size()))
                best = std::move(found);
        }
    return best;
}

} // namespace plprove::bounds
