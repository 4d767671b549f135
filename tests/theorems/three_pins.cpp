// Lemmas V11 and V12 of proofs/stars_in_several_views.md by second methods: a scene that is seen,
// and polynomials that are known by their values. The program
// proofs/computations/four_and_five_views.cpp, which is a test, too, works with coefficients.
#include "proofs/computations/star_of_three.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <vector>

using namespace proofs;

namespace {

constexpr Residue one{1};

/// The numbers of all views: alpha_{v,i} at place 3 v + i.
Residue value(const Exponents& monomial, const ResidueRow& alpha) {
    Residue result{1};
    for (std::size_t n = 0; n < monomial.size(); ++n)
        for (int power = 0; power < monomial[n]; ++power)
            result = result * alpha[n];
    return result;
}

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

/// The codimension in F of every third product, by values at as many points as F has dimension.
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

/// The numbers of cameras with one kernel.
ResidueRow spurious_zero(const FiveViews& images) {
    ResidueRow kappa;
    for (const ImageOfThreePins& image : images)
        for (std::size_t i = 0; i < 3; ++i)
            kappa.push_back(bracket(image.pins[(i + 1) % 3], image.pins[(i + 2) % 3]));
    return kappa;
}

} // namespace

TEST_CASE("Lemma V11: a scene that is seen, and cameras with one kernel, are zeros") {
    Residues random(8);
    const Scene seen = scene(random);
    const FiveViews& images = seen.images;
    const ResidueRow& alpha = seen.alpha;
    const ResidueRow kappa = spurious_zero(images), other = random.row(15);
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
    Residues random(9);
    const Scene seen = scene(random);
    const FiveViews& images = seen.images;
    const ResidueRow& alpha = seen.alpha;
    const ResidueRow kappa = spurious_zero(images), other = random.row(15);
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
    const FiveViews images = scene(random).images;
    CHECK(codimension_by_values(images, random) == 36);
    const QuotientOfThreePins quotient(ThreePinEquations(images).all());
    CHECK(quotient.dimension() == 36);
    for (const Multidegree& degree : degrees_of_e)
        CHECK(quotient.spanned_by_multiples(degree, random));
}
