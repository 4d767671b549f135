// Lemma V12 of proofs/stars_in_several_views.md: a point with three pins and four free lines in
// five views, as equations for three numbers in each view; one example modulo q = 2^61 - 1.
#pragma once

#include "proofs/computations/multigraded_polynomials.h"
#include "proofs/computations/star_of_four.h"

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace proofs {

/// What one view shows, modulo the image of the point: the directions of three pins, and covectors
/// of four free lines.
struct ImageOfThreePins {
    std::array<Direction, 3> pins{};
    std::array<Direction, 4> lines{};
};

using FiveViews = std::array<ImageOfThreePins, 5>;

inline FiveViews generic_views(Residues& random) {
    FiveViews images;
    for (ImageOfThreePins& image : images) {
        for (Direction& direction : image.pins)
            direction = {random.next(), random.next()};
        for (Direction& direction : image.lines)
            direction = {random.next(), random.next()};
    }
    return images;
}

/// The equations of Lemma V11.
class ThreePinEquations {
public:
    explicit ThreePinEquations(const FiveViews& images) : images_(images) {}

    /// 24 minors of size 5, then 1260 of size 2.
    std::vector<SparsePolynomial> all() const {
        std::vector<SparsePolynomial> result;
        for (std::size_t line = 0; line < 4; ++line)
            append_minors_of_triple((line + 1) % 4, (line + 2) % 4, (line + 3) % 4, result);
        for (std::size_t line = 0; line < 4; ++line)
            append_minors_of_forms(line, result);
        return result;
    }

private:
    /// For each view the difference of the covectors of two lines, composed with the camera.
    PolynomialMatrix rows(std::size_t j, std::size_t k) const {
        PolynomialMatrix result(5);
        for (std::size_t v = 0; v < 5; ++v) {
            const Direction &l = images_[v].lines[j], &other = images_[v].lines[k];
            for (std::size_t i = 0; i < 3; ++i) {
                const Direction& y = images_[v].pins[i];
                Exponents variable{};
                variable[3 * v + i] = 1;
                result[v].push_back(
                    {{variable, (l[0] - other[0]) * y[0] + (l[1] - other[1]) * y[1]}});
            }
        }
        return result;
    }

    /// The minors of size 5 of (a^{ij}, a^{jk}).
    void append_minors_of_triple(std::size_t i, std::size_t j, std::size_t k,
                                 std::vector<SparsePolynomial>& result) const {
        PolynomialMatrix both = rows(i, j);
        const PolynomialMatrix other = rows(j, k);
        for (std::size_t v = 0; v < 5; ++v)
            both[v].insert(both[v].end(), other[v].begin(), other[v].end());
        for (std::size_t omitted = 0; omitted < 6; ++omitted)
            result.push_back(determinant_of(without_column(both, omitted)));
    }

    /// The form d_i^{jk} of the four views that are not omitted: its three coefficients.
    std::vector<SparsePolynomial> form(std::size_t i, std::size_t j, std::size_t k,
                                       std::size_t omitted) const {
        const PolynomialMatrix four = without_row(rows(j, k), omitted);
        const PolynomialMatrix combined = without_row(rows(i, j), omitted);
        std::vector<SparsePolynomial> result(3);
        for (std::size_t v = 0; v < 4; ++v) {
            const SparsePolynomial minor = determinant_of(without_row(four, v));
            for (std::size_t n = 0; n < 3; ++n)
                add_product(result[n], minor, combined[v][n],
                            v % 2 == 0 ? Residue{1} : -Residue{1});
        }
        return result;
    }

    /// The minors of size 2 of the 15 forms of a line.
    void append_minors_of_forms(std::size_t i, std::vector<SparsePolynomial>& result) const {
        PolynomialMatrix forms;
        for (std::size_t omitted = 0; omitted < 5; ++omitted)
            for (std::size_t j = 0; j < 4; ++j)
                for (std::size_t k = 0; k < j; ++k)
                    if (i != j && i != k) forms.push_back(form(i, j, k, omitted));
        for (std::size_t a = 0; a < forms.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                for (std::size_t n = 0; n < 3; ++n) {
                    const std::size_t o = (n + 1) % 3;
                    SparsePolynomial minor;
                    add_product(minor, forms[a][n], forms[b][o], Residue{1});
                    add_product(minor, forms[a][o], forms[b][n], -Residue{1});
                    result.push_back(minor);
                }
            }
        }
    }

    FiveViews images_;
};

/// The zero of the equations at which all cameras have one kernel.
inline ResidueRow common_kernel(const FiveViews& images) {
    ResidueRow kappa;
    for (const ImageOfThreePins& image : images)
        for (std::size_t c = 0; c < 3; ++c)
            kappa.push_back(bracket(image.pins[(c + 1) % 3], image.pins[(c + 2) % 3]));
    return kappa;
}

/// Random coefficients of these monomials, so that their combination vanishes at a point.
inline ResidueRow vanishing_at(const ResidueRow& point, const std::vector<Exponents>& monomials,
                               Residues& random) {
    ResidueRow values;
    for (const Exponents& monomial : monomials)
        values.push_back(value(monomial, point));
    ResidueRow coefficients = random.row(monomials.size());
    coefficients[0] = coefficients[0] - product(coefficients, values) * values.front().inverse();
    return coefficients;
}

/// The multidegrees of the spaces E_1, E_2 and F of Lemma V12.
inline constexpr std::array<Multidegree, 2> degrees_of_e{
    {{1, 1, 1, 0, 0, 1, 1, 1}, {0, 0, 1, 1, 1, 1, 1, 1}}};
inline constexpr Multidegree degree_of_f{2, 2, 2, 2, 2, 4, 3, 3};

/// The space F modulo products of equations with monomials, for Lemma V12.
class QuotientOfThreePins {
public:
    explicit QuotientOfThreePins(const std::vector<SparsePolynomial>& equations)
        : f_(monomials_of(degree_of_f)) {
        for (std::size_t n = 0; n < f_.size(); ++n)
            places_.emplace(f_[n], n);
        RowSpace span;
        for (const ResidueRow& row : all_products(equations))
            span.insert(row);
        find_classes(span);
    }

    /// The codimension of the span of all products.
    std::size_t dimension() const { return dimension_; }

    std::size_t dimension_of_f() const { return f_.size(); }

    /// The number of symbols m b, for monomials m of E, the space of this multidegree, and b of a
    /// basis of F modulo K, the span of the products in F.
    std::size_t number_of_symbols(const Multidegree& degree_of_e) const {
        return monomials_of(degree_of_e).size() * dimension_;
    }

    /// The rank of the relations of the symbols with the multiples of u, an element of E by its
    /// coefficients: E F = u F + E K if it is the number of symbols. There is a relation for each
    /// m n = m' n', with monomials m, m' of E and n, n' of F.
    std::size_t rank_with_multiples(const Multidegree& degree_of_e, const ResidueRow& u,
                                    Residues& random) const {
        const std::vector<Exponents> e = monomials_of(degree_of_e);
        RowSpace span;
        for (std::size_t b = 0; b < dimension_; ++b) {
            ResidueRow row(e.size() * dimension_);
            for (std::size_t m = 0; m < e.size(); ++m)
                row[m * dimension_ + b] = u[m];
            span.insert(row);
        }
        ResidueMatrix relations = all_relations(e);
        shuffle(relations, random);
        for (const ResidueRow& row : relations)
            if (span.dimension() < row.size()) span.insert(row);
        return span.dimension();
    }

private:
    /// A random order, so that the first rows are soon as independent as all are.
    static void shuffle(ResidueMatrix& rows, Residues& random) {
        for (std::size_t n = rows.size(); n > 1; --n)
            std::swap(rows[n - 1], rows[random.next().value % n]);
    }

    ResidueMatrix all_products(const std::vector<SparsePolynomial>& equations) const {
        ResidueMatrix rows;
        for (const SparsePolynomial& equation : equations) {
            if (equation.empty()) continue;
            const Multidegree degree = multidegree(equation.begin()->first);
            for (const Exponents& factor : monomials_of(difference(degree_of_f, degree))) {
                rows.emplace_back(f_.size());
                for (const auto& [monomial, coefficient] : equation)
                    rows.back()[places_.at(product(monomial, factor))] = coefficient;
            }
        }
        return rows;
    }

    /// Each monomial of F as a combination of those at which no row of the space has its leader.
    void find_classes(const RowSpace& span) {
        std::vector<std::size_t> basis;
        for (std::size_t n = 0; n < f_.size(); ++n)
            if (!span.leads(n)) basis.push_back(n);
        dimension_ = basis.size();
        for (std::size_t n = 0; n < f_.size(); ++n) {
            ResidueRow unit(f_.size());
            unit[n] = {1};
            const ResidueRow rest = span.reduced(unit);
            classes_.emplace_back();
            for (const std::size_t place : basis)
                classes_.back().push_back(rest[place]);
        }
    }

    ResidueMatrix all_relations(const std::vector<Exponents>& e) const {
        std::map<Exponents, std::pair<std::size_t, std::size_t>> first;
        ResidueMatrix rows;
        for (std::size_t m = 0; m < e.size(); ++m) {
            for (std::size_t n = 0; n < f_.size(); ++n) {
                const auto [place, is_new] = first.emplace(product(e[m], f_[n]), std::pair{m, n});
                if (is_new) continue;
                rows.emplace_back(e.size() * dimension_);
                for (std::size_t b = 0; b < dimension_; ++b) {
                    rows.back()[m * dimension_ + b] = classes_[n][b];
                    rows.back()[place->second.first * dimension_ + b] =
                        -classes_[place->second.second][b];
                }
            }
        }
        return rows;
    }

    std::vector<Exponents> f_;
    std::map<Exponents, std::size_t> places_{};
    std::size_t dimension_ = 0;
    ResidueMatrix classes_{};
};

} // namespace proofs
