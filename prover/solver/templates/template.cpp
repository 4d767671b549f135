#include "prover/solver/templates/template.h"

#include <algorithm>
#include <numeric>

namespace plprove::templates {

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

/// Multiples of equations.
struct Multiples {
    std::vector<std::pair<std::size_t, std::size_t>> names; // equation, monomial
    std::vector<Polynomial> polynomials;
};

/// All multiples by these monomials up to the degree.
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

/// Whether a basis may have the monomial: the products with entries of R are columns, too.
bool fits_basis(const RotationRing& ring, const Monomial& monomial, const BiDegree& degree) {
    return at_most(sum(ring.degree(monomial), ring.unit()), degree);
}

/// The indices of the monomials in the order in which they are eliminated: those that cannot be in
/// the basis first, then the larger degrees first.
std::vector<std::size_t> order_of_elimination(const RotationRing& ring,
                                              const std::vector<Monomial>& monomials,
                                              const BiDegree& degree) {
    std::vector<std::size_t> order(monomials.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
        const BiDegree d = ring.degree(monomials[i]);
        return std::pair(fits_basis(ring, monomials[i], degree), -(d[0] + d[1]));
    });
    return order;
}

/// The multiples as rows; column k is that of the monomial order[k].
ResidueMatrix matrix_of(const Multiples& all, const std::vector<Monomial>& monomials,
                        const std::vector<std::size_t>& order) {
    std::map<Monomial, int> column;
    for (std::size_t k = 0; k < order.size(); ++k)
        column[monomials[order[k]]] = static_cast<int>(k);
    const int rows = static_cast<int>(all.polynomials.size());
    ResidueMatrix matrix(rows, static_cast<int>(order.size()));
    for (int row = 0; row < rows; ++row)
        for (const auto& [m, x] : all.polynomials[static_cast<std::size_t>(row)])
            matrix.at(row, column.at(m)) = x;
    return matrix;
}

ResidueMatrix transposed(const ResidueMatrix& matrix) {
    ResidueMatrix result(matrix.columns(), matrix.rows());
    nmod_mat_transpose(result.get(), matrix.get());
    return result;
}

/// The indices of the monomials that elimination leaves, ascending.
std::vector<std::size_t> basis_left_by(const ResidueMatrix& matrix,
                                       const std::vector<std::size_t>& order) {
    const std::vector<int> eliminated = pivots(matrix);
    std::vector<std::size_t> basis;
    for (std::size_t k = 0; k < order.size(); ++k)
        if (!std::ranges::binary_search(eliminated, static_cast<int>(k))) basis.push_back(order[k]);
    std::ranges::sort(basis);
    return basis;
}

/// Makes the chosen multiples the rows of the template.
void add_rows(Template& found, const Multiples& all, const std::vector<int>& chosen) {
    for (const int index : chosen) {
        const auto& [equation, monomial] = all.names[static_cast<std::size_t>(index)];
        if (found.rows.empty() || found.rows.back().first != equation)
            found.rows.push_back({equation, {}});
        found.rows.back().second.push_back(monomial);
    }
}

/// The template of this degree, if there is one with a smaller basis.
std::optional<Template> find_template(const RotationRing& ring,
                                      const std::vector<Equation>& equations,
                                      const BiDegree& degree, std::size_t smaller_than) {
    const std::vector<Monomial> monomials = ring.monomials(degree);
    const Multiples all = multiples(ring, equations, monomials, degree);
    const std::vector<std::size_t> order = order_of_elimination(ring, monomials, degree);
    const ResidueMatrix matrix = matrix_of(all, monomials, order);
    Template found;
    found.degree = degree;
    found.basis = basis_left_by(matrix, order);
    if (found.basis.empty() || found.basis.size() >= smaller_than) return {};
    const auto fits = [&](std::size_t i) { return fits_basis(ring, monomials[i], degree); };
    if (!std::ranges::all_of(found.basis, fits)) return {};
    // The pivots of the transposed matrix are the first rows that are independent.
    add_rows(found, all, pivots(transposed(matrix)));
    return found;
}

} // namespace

std::optional<Template> find_template(const RegistrationData& data, Frame frame) {
    const RotationRing ring(frame);
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

} // namespace plprove::templates
