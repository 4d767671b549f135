// Theorem R (proofs/focal_stars.md): three cameras modulo a prime, with a focal length each, that
// see a point; an example in general position; and intersection numbers.
#include "checker/general_bounds/proved_degrees.h"
#include "checker/problem/notation.h"
#include "tests/theorems/residue_vectors.h"

#include <doctest/doctest.h>
#include <map>

using namespace checker;
using proofs::ResidueMatrix;
using proofs::ResidueRow;
using proofs::Residues;
using residue_vectors::random_vector;
using residue_vectors::Vector;

namespace {

using Matrix = std::array<Vector, 3>;

Vector times_matrix(const Vector& row, const Matrix& m) {
    return plus(plus(times(row[0], m[0]), times(row[1], m[1])), times(row[2], m[2]));
}

/// By rows, as the matrix of cofactors.
Matrix cofactors(const Matrix& m) {
    return {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
}

Matrix transpose(const Matrix& m) {
    return {Vector{m[0][0], m[1][0], m[2][0]}, Vector{m[0][1], m[1][1], m[2][1]},
            Vector{m[0][2], m[1][2], m[2][2]}};
}

/// A matrix times its transpose.
Matrix times_transpose(const Matrix& m) {
    Matrix result;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            result[i][j] = dot(m[i], m[j]);
    return result;
}

/// The rows of a rotation.
Matrix rotation(Residues& random) {
    const Residue a = random.next(), two{2};
    const Vector b = random_vector(random);
    const Residue scale = (a * a + dot(b, b)).inverse();
    Matrix result;
    for (std::size_t i = 0; i < 3; ++i) {
        Vector unit{};
        unit[i] = {1};
        result[i] = times(scale, plus(plus(times(a * a - dot(b, b), unit), times(two * b[i], b)),
                                      times(two * a, cross(unit, b))));
    }
    return result;
}

/// A polynomial in three unknowns, by the exponents of its terms.
using Polynomial = std::map<std::array<unsigned, 3>, Residue>;

Polynomial product(const Polynomial& a, const Polynomial& b) {
    Polynomial result;
    for (const auto& [x, coefficient] : a)
        for (const auto& [y, other] : b) {
            Residue& sum = result[{x[0] + y[0], x[1] + y[1], x[2] + y[2]}];
            sum = sum + coefficient * other;
        }
    return result;
}

void add(Polynomial& sum, const Polynomial& a, Residue factor) {
    for (const auto& [exponents, coefficient] : a)
        sum[exponents] = sum[exponents] + factor * coefficient;
}

Polynomial determinant(const std::array<std::array<Polynomial, 3>, 3>& m) {
    Polynomial sum;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        add(sum, product(m[0][i], product(m[1][j], m[2][k])), {1});
        add(sum, product(m[0][i], product(m[1][k], m[2][j])), -Residue{1});
    }
    return sum;
}

Polynomial derivative(const Polynomial& a, std::size_t unknown) {
    Polynomial result;
    for (const auto& [exponents, coefficient] : a) {
        if (exponents[unknown] == 0) continue;
        auto less = exponents;
        --less[unknown];
        result[less] = Residue{exponents[unknown]} * coefficient;
    }
    return result;
}

std::vector<std::array<unsigned, 3>> monomials(unsigned degree) {
    std::vector<std::array<unsigned, 3>> result;
    for (unsigned i = 0; i <= degree; ++i)
        for (unsigned j = 0; i + j <= degree; ++j)
            result.push_back({i, j, degree - i - j});
    return result;
}

/// Whether three forms of a degree have no common zero: whether they generate all forms of degree
/// 3 (degree - 1) + 1 (F. S. Macaulay).
bool have_no_common_zero(const std::array<Polynomial, 3>& forms, unsigned degree) {
    const auto all = monomials(3 * (degree - 1) + 1);
    ResidueMatrix rows;
    for (const Polynomial& form : forms)
        for (const auto& factor : monomials(2 * (degree - 1))) {
            Polynomial multiple = product(form, {{factor, Residue{1}}});
            ResidueRow& row = rows.emplace_back();
            for (const auto& exponents : all)
                row.push_back(multiple[exponents]);
        }
    return proofs::rank_of(rows) == all.size();
}

/// A covector a, applied to a symmetric matrix and b, as a linear form in its six entries.
ResidueRow entries(const Vector& a, const Vector& b) {
    return {a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[0] * b[2] + a[2] * b[0],
            a[1] * b[1], a[1] * b[2] + a[2] * b[1], a[2] * b[2]};
}

/// What section 2 says of random A and xi, with linear forms on the plane Π.
struct Example {
    std::array<ResidueRow, 3> lambda, alpha, beta; ///< in coordinates of a basis of Π
    ResidueMatrix basis;                           ///< of matrices ω, by their six entries

    explicit Example(Residues& random) {
        std::array<Vector, 3> a, b;
        ResidueMatrix conditions;
        for (std::size_t v = 0; v < 3; ++v) {
            a[v] = random_vector(random);
            b[v] = random_vector(random);
            conditions.push_back(entries(a[v], b[v]));
        }
        basis = proofs::kernel_of(conditions, 6);
        for (std::size_t v = 0; v < 3; ++v) {
            const Residue xi = random.next(), inverse = (xi * xi).inverse();
            for (const ResidueRow& omega : basis) {
                alpha[v].push_back(proofs::product(entries(a[v], a[v]), omega));
                beta[v].push_back(proofs::product(entries(b[v], b[v]), omega));
                lambda[v].push_back(inverse * (beta[v].back() - alpha[v].back()));
            }
        }
    }

    /// The sextic of z: det ω, where λ_v is the square of z_v.
    Polynomial sextic() const {
        // The coordinates of the basis are linear forms in λ.
        std::array<Polynomial, 3> coordinates;
        const Matrix rows{vector(lambda[0]), vector(lambda[1]), vector(lambda[2])};
        const Matrix adjugate = cofactors(rows); // transposed
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t v = 0; v < 3; ++v) {
                std::array<unsigned, 3> squares{};
                squares[v] = 2;
                coordinates[i][squares] = adjugate[v][i];
            }
        constexpr std::array<std::array<std::size_t, 3>, 3> place{
            {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};
        std::array<std::array<Polynomial, 3>, 3> omega;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                for (std::size_t n = 0; n < 3; ++n)
                    add(omega[i][j], coordinates[n], basis[n][place[i][j]]);
        return determinant(omega);
    }

    static Vector vector(const ResidueRow& row) { return {row[0], row[1], row[2]}; }
};

std::size_t bound_of(const std::string& notation) {
    const std::string text = notation + '\n';
    Reader reader(text);
    return proved_degree(read_notation(reader).problem).value().at_most;
}

} // namespace

TEST_CASE("the third row of a camera is what the conic and two square roots say") {
    Residues random(1);
    Matrix turn; // of coordinates of directions, so that the conic is not I
    for (Vector& row : turn)
        row = random_vector(random);
    // Up to det², ω = G⁻¹ G⁻ᵀ: so λ = det² for a camera K R G.
    const Matrix omega = times_transpose(transpose(cofactors(turn)));
    const Residue z = dot(turn[0], cofactors(turn)[0]), y = z * z, lambda = z * z;
    for (int view = 0; view < 3; ++view) {
        const Residue f = random.next(), xi = random.next();
        const Matrix q = rotation(random);
        const Vector n = times_matrix(q[2], turn), a = times(f, times_matrix(q[0], turn));
        const Vector b = minus(times(f, times_matrix(q[1], turn)), times(xi, n));
        const auto form = [&](const Vector& left, const Vector& right) {
            return dot(left, times_matrix(right, omega));
        };
        const Residue alpha = form(a, a), beta = form(b, b);
        CHECK(form(a, b) == Residue{});
        CHECK(beta - alpha == xi * xi * lambda);
        CHECK(alpha == f * f * lambda);
        CHECK(form(n, a) == Residue{});
        CHECK(form(n, b) == -xi * lambda);
        CHECK(form(n, n) == lambda);
        const Vector r = cross(a, b), polar = times_matrix(r, cofactors(omega));
        CHECK(dot(r, polar) == alpha * beta);
        CHECK(times(y * beta, n) == plus(times(-xi * z * z * y, b), times(z, polar)));
    }
}

TEST_CASE("an example is in general position") {
    Residues random(2);
    const Example example(random);
    REQUIRE(example.basis.size() == 3);
    const auto& [lambda, alpha, beta, basis] = example;
    for (unsigned choice = 0; choice < 8; ++choice) {
        ResidueMatrix lines;
        for (std::size_t v = 0; v < 3; ++v)
            lines.push_back(choice >> v & 1 ? lambda[v] : alpha[v]);
        CHECK(proofs::rank_of(lines) == 3); // λ alone, too
    }
    for (std::size_t v = 0; v < 3; ++v) {
        const Vector meet =
            cross(Example::vector(lambda[v]), Example::vector(alpha[v])); // a point of Π
        for (std::size_t w = 0; w < 3; ++w) {
            // A coefficient of β_v in coordinates λ: its value where the others are 0.
            const Vector vertex =
                cross(Example::vector(lambda[(w + 1) % 3]), Example::vector(lambda[(w + 2) % 3]));
            CHECK(dot(Example::vector(beta[v]), vertex) != Residue{});
            if (w == v) continue;
            for (const auto* forms : {&lambda, &alpha, &beta})
                CHECK(dot(Example::vector((*forms)[w]), meet) != Residue{});
        }
    }
    const Polynomial sextic = example.sextic();
    CHECK(have_no_common_zero({derivative(sextic, 0), derivative(sextic, 1), derivative(sextic, 2)},
                              5));
}

TEST_CASE("three forms with a common zero are told") {
    // x^2, xy + z^2 and y^2 have none, without z^2 they have one.
    const Residue one{1};
    CHECK(have_no_common_zero(
        {Polynomial{{{2, 0, 0}, one}}, {{{1, 1, 0}, one}, {{0, 0, 2}, one}}, {{{0, 2, 0}, one}}},
        2));
    CHECK(!have_no_common_zero(
        {Polynomial{{{2, 0, 0}, one}}, {{{1, 1, 0}, one}}, {{{0, 2, 0}, one}}}, 2));
}

TEST_CASE("intersection numbers on the surface are half of the bounds") {
    // Of R, D_1, D_2, D_3.
    constexpr long products[4][4] = {{18, 6, 6, 6}, {6, -2, 2, 2}, {6, 2, -2, 2}, {6, 2, 2, -2}};
    long square_of_e = 0;
    for (const auto& row : products)
        for (const long number : row)
            square_of_e += number;
    const long degree_of_lambda = -12 + products[0][0];
    const long twice_ch_of_g = products[1][1] + products[2][2] + products[3][3];
    const long twice_ch = twice_ch_of_g - (2 * degree_of_lambda - products[0][0]);
    const long second_class = (square_of_e - twice_ch) / 2, base_points = 6;
    const auto bound = [](const std::string& features) {
        return static_cast<long>(bound_of("focal: " + features));
    };
    CHECK(2 * (square_of_e - base_points) == bound("Pabcdefg/Pabcdefg/Pabcdefg + 2*a/a/a"));
    CHECK(2 * (square_of_e - base_points) == bound("Pab/Pab/Pab + Pabcdef/Pabcdef/Pabcdef"));
    CHECK(2 * (square_of_e - second_class - base_points) ==
          bound("P/P/P + Pabcdef/Pabcdef/Pabcdef + a/a/a"));
    CHECK(2 * second_class == bound("2*P/P/P + Pabcde/Pabcde/Pabcde"));
    CHECK(2 * second_class == bound("2*PL/PL/PL + PLabcdef/PLabcdef/PLabcdef"));
}
