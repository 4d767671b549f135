// Lemmas V11 and V12 of proofs/stars_in_several_views.md by second methods: a scene that is seen,
// and polynomials that are known by their values. The program
// proofs/computations/four_and_five_views.cpp, which is a test, too, works with coefficients.
#include "proofs/computations/star_of_three.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

using namespace proofs;

namespace {

constexpr Residue one{1};

using proofs::value; // of a monomial

Residue value(const SparsePolynomial& polynomial, const ResidueRow& alpha) {
    Residue sum;
    for (const auto& [monomial, coefficient] : polynomial)
        sum = sum + coefficient * value(monomial, alpha);
    return sum;
}

/// The forms a^{jk} of the five views.
ResidueMatrix forms_of(const FiveViews& images, const ResidueRow& alpha, std::size_t j,
                       std::size_t k) {
    ResidueMatrix result(5);
    for (std::size_t v = 0; v < 5; ++v) {
        const Direction &l = images[v].lines[j], &other = images[v].lines[k];
        for (std::size_t i = 0; i < 3; ++i) {
            const Direction& y = images[v].pins[i];
            result[v].push_back(alpha[3 * v + i] *
                                ((l[0] - other[0]) * y[0] + (l[1] - other[1]) * y[1]));
        }
    }
    return result;
}

/// The five rows (a^{ij}, a^{jk}).
ResidueMatrix side_by_side(ResidueMatrix left, const ResidueMatrix& right) {
    for (std::size_t v = 0; v < 5; ++v)
        left[v].insert(left[v].end(), right[v].begin(), right[v].end());
    return left;
}

ResidueMatrix without(ResidueMatrix rows, std::size_t omitted) {
    rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(omitted));
    return rows;
}

/// d_i^{jk} of four views: the combination with the coefficients of the relation.
ResidueRow relation_form(const ResidueMatrix& four, const ResidueMatrix& combined) {
    ResidueRow minors;
    for (std::size_t v = 0; v < 4; ++v) {
        const Residue minor = determinant_of(without(four, v));
        minors.push_back(v % 2 == 0 ? minor : -minor);
    }
    return product({minors}, combined).front();
}

/// The 15 forms of a line; the n-th one does not use view n / 3.
ResidueMatrix relation_forms(const FiveViews& images, const ResidueRow& alpha, std::size_t i) {
    ResidueMatrix result;
    for (std::size_t omitted = 0; omitted < 5; ++omitted)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = 0; k < j; ++k)
                if (i != j && i != k)
                    result.push_back(
                        relation_form(without(forms_of(images, alpha, j, k), omitted),
                                      without(forms_of(images, alpha, i, j), omitted)));
    return result;
}

struct Equation {
    Residue value{};
    Multidegree degree{};
};

void append_minors_of_triple(const FiveViews& images, const ResidueRow& alpha, std::size_t line,
                             std::vector<Equation>& result) {
    const std::size_t i = (line + 1) % 4, j = (line + 2) % 4, k = (line + 3) % 4;
    const ResidueMatrix both =
        side_by_side(forms_of(images, alpha, i, j), forms_of(images, alpha, j, k));
    for (std::size_t omitted = 0; omitted < 6; ++omitted) {
        ResidueMatrix part = both;
        for (ResidueRow& row : part)
            row.erase(row.begin() + static_cast<std::ptrdiff_t>(omitted));
        Multidegree degree{1, 1, 1, 1, 1, 2, 2, 2};
        --degree[5 + omitted % 3];
        result.push_back({determinant_of(part), degree});
    }
}

void append_minors_of_forms(const FiveViews& images, const ResidueRow& alpha, std::size_t line,
                            std::vector<Equation>& result) {
    const ResidueMatrix forms = relation_forms(images, alpha, line);
    for (std::size_t a = 0; a < forms.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            for (std::size_t n = 0; n < 3; ++n) {
                const std::size_t o = (n + 1) % 3;
                Multidegree degree{2, 2, 2, 2, 2, 2, 2, 2};
                --degree[a / 3];
                --degree[b / 3];
                ++degree[5 + n];
                ++degree[5 + o];
                result.push_back({forms[a][n] * forms[b][o] - forms[a][o] * forms[b][n], degree});
            }
}

/// All equations at given numbers.
std::vector<Equation> equations_at(const FiveViews& images, const ResidueRow& alpha) {
    std::vector<Equation> result;
    for (std::size_t line = 0; line < 4; ++line)
        append_minors_of_triple(images, alpha, line, result);
    for (std::size_t line = 0; line < 4; ++line)
        append_minors_of_forms(images, alpha, line, result);
    return result;
}

/// The codimension in F of every third product, by values at dim F points.
std::size_t codimension_by_values(const FiveViews& images, Residues& random) {
    const std::size_t dimension = monomials_of(degree_of_f).size();
    ResidueMatrix values(dimension);
    for (ResidueRow& row : values) {
        const ResidueRow alpha = random.row(15);
        std::size_t number = 0;
        for (const Equation& equation : equations_at(images, alpha))
            for (const Exponents& factor : monomials_of(difference(degree_of_f, equation.degree)))
                if (number++ % 3 == 0) row.push_back(equation.value * value(factor, alpha));
    }
    return dimension - rank_of(values);
}

struct Scene {
    FiveViews images{};
    ResidueRow alpha{}; // the numbers of its cameras
};

/// A point (1, 0, 0, 0), with the image (0, 0, 1), pins that join it to the other unit points, and
/// free lines.
Scene scene(Residues& random) {
    Scene result;
    std::array<ResidueMatrix, 4> free_lines;
    for (ResidueMatrix& line : free_lines)
        line = random.matrix(2, 4);
    result.alpha = random.row(15);
    for (std::size_t v = 0; v < 5; ++v) {
        const ResidueMatrix rest = random.matrix(3, 3);
        const ResidueMatrix camera{{{}, {}, one}, rest[0], rest[1], rest[2]};
        for (std::size_t i = 0; i < 3; ++i) {
            const Residue factor = result.alpha[3 * v + i].inverse();
            result.images[v].pins[i] = {factor * rest[i][0], factor * rest[i][1]};
        }
        for (std::size_t j = 0; j < 4; ++j) {
            const ResidueRow l = kernel_of(product(free_lines[j], camera), 3).front();
            result.images[v].lines[j] = {l[0] * l[2].inverse(), l[1] * l[2].inverse()};
        }
    }
    return result;
}

/// Polynomials of one multidegree as rows, without classes modulo K.
class RowsOfDegree {
public:
    explicit RowsOfDegree(const Multidegree& degree) {
        for (const Exponents& monomial : monomials_of(degree))
            places_.emplace(monomial, places_.size());
    }

    /// Whether the product was not in the span.
    bool insert(const SparsePolynomial& polynomial, const Exponents& factor) {
        ResidueRow row(places_.size());
        for (const auto& [monomial, coefficient] : polynomial)
            row[places_.at(product(monomial, factor))] = coefficient;
        const std::size_t before = span_.dimension();
        span_.insert(row);
        return span_.dimension() > before;
    }

    std::size_t dimension() const { return span_.dimension(); }

private:
    std::map<Exponents, std::size_t> places_{};
    RowSpace span_{};
};

/// Products of equations with monomials, a basis of K.
std::vector<SparsePolynomial> basis_of_products(const std::vector<SparsePolynomial>& equations) {
    RowsOfDegree rows(degree_of_f);
    std::vector<SparsePolynomial> basis;
    for (const SparsePolynomial& equation : equations) {
        const Multidegree degree = multidegree(equation.begin()->first);
        for (const Exponents& factor : monomials_of(difference(degree_of_f, degree))) {
            if (!rows.insert(equation, factor)) continue;
            basis.emplace_back();
            add_product(basis.back(), equation, {{factor, one}}, one);
        }
    }
    return basis;
}

Multidegree sum(Multidegree a, const Multidegree& b) {
    for (std::size_t n = 0; n < a.size(); ++n)
        a[n] += b[n];
    return a;
}

/// E K, in the space of all polynomials of its multidegree.
RowsOfDegree products_with(const std::vector<Exponents>& e, const Multidegree& degree_of_e,
                           const std::vector<SparsePolynomial>& k) {
    RowsOfDegree rows(sum(degree_of_e, degree_of_f));
    for (const Exponents& monomial : e)
        for (const SparsePolynomial& polynomial : k)
            rows.insert(polynomial, monomial);
    return rows;
}

/// The dimension of u F + E K, where the rows are E K.
std::size_t dimension_with_multiples(RowsOfDegree rows, const std::vector<Exponents>& e,
                                     const ResidueRow& u) {
    SparsePolynomial polynomial;
    for (std::size_t n = 0; n < e.size(); ++n)
        add_term(polynomial, e[n], u[n]);
    for (const Exponents& monomial : monomials_of(degree_of_f))
        rows.insert(polynomial, monomial);
    return rows.dimension();
}

/// The number of different products of monomials of E with those of F.
std::size_t dimension_of_products(const std::vector<Exponents>& e) {
    std::set<Exponents> products;
    for (const Exponents& monomial : e)
        for (const Exponents& other : monomials_of(degree_of_f))
            products.insert(product(monomial, other));
    return products.size();
}

/// Images of a scene, with its cameras, those with one kernel, and some that see nothing.
struct Example {
    FiveViews images;
    ResidueRow alpha, kappa, other;
};

Example example(unsigned seed) {
    Residues random(seed);
    const Scene seen = scene(random);
    return {seen.images, seen.alpha, common_kernel(seen.images), random.row(15)};
}

} // namespace

TEST_CASE("Lemma V11: a scene that is seen, and cameras with one kernel, are zeros") {
    const auto [images, alpha, kappa, other] = example(8);
    for (std::size_t line = 0; line < 4; ++line) {
        CHECK(rank_of(relation_forms(images, alpha, line)) == 1);
        CHECK(rank_of(relation_forms(images, kappa, line)) == 0);
        CHECK(rank_of(relation_forms(images, other, line)) == 3);
    }
    const auto two_pairs = [&](const ResidueRow& numbers) {
        return rank_of(
            side_by_side(forms_of(images, numbers, 0, 1), forms_of(images, numbers, 1, 2)));
    };
    CHECK(two_pairs(alpha) == 4);
    CHECK(two_pairs(kappa) == 4);
    CHECK(two_pairs(other) == 5);
    CHECK(rank_of(forms_of(images, alpha, 0, 1)) == 3);
    CHECK(rank_of(forms_of(images, kappa, 0, 1)) == 2);
}

TEST_CASE("Lemma V11: polynomials have the values of the determinants") {
    const auto [images, alpha, kappa, other] = example(9);
    const std::vector<SparsePolynomial> polynomials = ThreePinEquations(images).all();
    const std::vector<Equation> values = equations_at(images, other);
    REQUIRE(polynomials.size() == 24 + 1260);
    REQUIRE(values.size() == polynomials.size());
    std::size_t zeros = 0, equal = 0;
    for (std::size_t n = 0; n < polynomials.size(); ++n) {
        const SparsePolynomial& polynomial = polynomials[n];
        if (value(polynomial, alpha) == Residue{} && value(polynomial, kappa) == Residue{}) ++zeros;
        const bool same_degree =
            std::all_of(polynomial.begin(), polynomial.end(), [&](const auto& term) {
                return multidegree(term.first) == values[n].degree;
            });
        if (same_degree && value(polynomial, other) == values[n].value) ++equal;
    }
    CHECK(zeros == polynomials.size());
    CHECK(equal == polynomials.size());
}

TEST_CASE("Lemma V12: values at points give codimension 36, and so does a scene that is seen") {
    Residues random(10);
    CHECK(codimension_by_values(generic_views(random), random) == 36);
    const QuotientOfThreePins quotient(ThreePinEquations(scene(random).images).all());
    CHECK(quotient.dimension() == 36);
    for (const Multidegree& degree : degrees_of_e) {
        const ResidueRow u = random.row(6);
        CHECK(quotient.rank_with_multiples(degree, u, random) == 216);
    }
}

TEST_CASE("Lemma V12: products of polynomials show that multiples of one element suffice") {
    Residues random(11);
    const FiveViews images = generic_views(random);
    const std::vector<SparsePolynomial> k = basis_of_products(ThreePinEquations(images).all());
    CHECK(k.size() == 440 - 36);
    // For E_1 only: views in the opposite order exchange E_1 and E_2.
    const Multidegree& degree = degrees_of_e[0];
    const std::vector<Exponents> e = monomials_of(degree);
    CHECK(dimension_of_products(e) == 1387);
    const RowsOfDegree rows = products_with(e, degree, k);
    CHECK(rows.dimension() == 1387 - 36);
    CHECK(dimension_with_multiples(rows, e, random.row(e.size())) == 1387);
    const ResidueRow u = vanishing_at(common_kernel(images), e, random);
    CHECK(dimension_with_multiples(rows, e, u) == 1387 - 1);
}
