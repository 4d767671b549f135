// Resultants of proofs/calibrated_six_views.md, section 7, along curves of scenes, modulo a prime.
#include "tests/theorems/number_modulo_prime.h"

#include <algorithm>
#include <array>
#include <doctest/doctest.h>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace {

using theorems::Number;
using theorems::prime;

constexpr unsigned terms = 20;
using Series = std::array<Number, terms>;

std::mt19937_64 generator(7); // NOLINT(cert-msc51-cpp)

Number at_random() {
    return Number(static_cast<std::int64_t>(generator() % (prime - 1) + 1));
}

/// A general series of this order; `terms` for 0.
Series series(unsigned order) {
    Series result{};
    for (unsigned k = order; k < terms; ++k)
        result[k] = at_random();
    return result;
}

unsigned order_of(const Series& x) {
    unsigned k = 0;
    while (k < terms && x[k].value == 0)
        ++k;
    return k;
}

/// x minus f y, both divided by t^shift before: f y is.
void subtract(Series& x, const Series& f, const Series& y) {
    for (unsigned i = 0; i < terms; ++i)
        if (f[i].value != 0)
            for (unsigned k = 0; i + k < terms; ++k)
                x[i + k] = x[i + k] - f[i] * y[k];
}

/// x y plus a general series of this order.
Series near_product(const Series& x, const Series& y, unsigned order) {
    Series minus_x{}, result = series(order);
    subtract(minus_x, {Number(1)}, x);
    subtract(result, minus_x, y);
    return result;
}

Series quotient(const Series& x, const Series& y, unsigned order) {
    Series result{};
    for (unsigned k = 0; k + order < terms; ++k) {
        Number rest = x[k + order];
        for (unsigned i = 0; i < k; ++i)
            rest = rest - result[i] * y[k - i + order];
        result[k] = rest / y[order];
    }
    return result;
}

using Matrix = std::vector<std::vector<Series>>;

unsigned order_of_determinant(Matrix m) {
    unsigned sum = 0;
    for (std::size_t c = 0; c < m.size(); ++c) {
        std::size_t row = c, column = c;
        unsigned least = terms;
        for (std::size_t i = c; i < m.size(); ++i)
            for (std::size_t k = c; k < m.size(); ++k)
                if (order_of(m[i][k]) < least) {
                    least = order_of(m[i][k]);
                    row = i;
                    column = k;
                }
        REQUIRE(least + 6 < terms);
        sum += least;
        std::swap(m[c], m[row]);
        for (auto& r : m)
            std::swap(r[c], r[column]);
        for (std::size_t i = c + 1; i < m.size(); ++i) {
            if (order_of(m[i][c]) == terms) continue;
            const Series factor = quotient(m[i][c], m[c][c], least);
            for (std::size_t k = c + 1; k < m.size(); ++k)
                subtract(m[i][k], factor, m[c][k]);
        }
    }
    return sum;
}

using Monomial = std::array<unsigned, 4>;
using Form = std::map<Monomial, Series>;
using Vector = std::array<Series, 3>; // u, m, z

void add(Form& form, const Monomial& monomial, Number factor, const Series& x) {
    Series& sum = form.try_emplace(monomial).first->second;
    for (unsigned k = 0; k < terms; ++k)
        sum[k] = sum[k] + factor * x[k];
}

/// l . R d as a form in q: formula (2), with kappa and delta kappa' of two coordinates each.
Form form_of(const std::array<Number, 3>& l, const Vector& d) {
    Form form;
    for (unsigned a = 0; a < 4; ++a)
        for (unsigned b = 0; b < 4; ++b) {
            Monomial monomial{};
            ++monomial[a];
            ++monomial[b];
            add(form, monomial, l[a % 2 + b % 2], d[a / 2 + b / 2]);
        }
    return form;
}

Form moved(const Form& form, const std::array<std::array<Number, 4>, 4>& change) {
    Form result;
    for (const auto& [monomial, x] : form) {
        std::vector<unsigned> variables;
        for (unsigned i = 0; i < 4; ++i)
            variables.insert(variables.end(), monomial[i], i);
        for (unsigned a = 0; a < 4; ++a)
            for (unsigned b = 0; b < 4; ++b) {
                Monomial other{};
                ++other[a];
                ++other[b];
                add(result, other, change[variables[0]][a] * change[variables[1]][b], x);
            }
    }
    return result;
}

/// Macaulay's quotient of determinants, for four quadrics.
unsigned order_of_resultant(const std::vector<Form>& forms) {
    std::vector<Monomial> monomials;
    std::map<Monomial, std::size_t> index;
    for (unsigned i = 0; i <= 5; ++i)
        for (unsigned j = 0; i + j <= 5; ++j)
            for (unsigned k = 0; i + j + k <= 5; ++k) {
                index[{i, j, k, 5 - i - j - k}] = monomials.size();
                monomials.push_back({i, j, k, 5 - i - j - k});
            }
    Matrix matrix(monomials.size(), std::vector<Series>(monomials.size(), Series{}));
    std::vector<std::size_t> not_reduced;
    for (std::size_t row = 0; row < monomials.size(); ++row) {
        Monomial rest = monomials[row];
        const auto first =
            std::ranges::find_if(rest, [](unsigned exponent) { return exponent >= 2; });
        if (std::ranges::count_if(rest, [](unsigned exponent) { return exponent >= 2; }) > 1)
            not_reduced.push_back(row);
        *first -= 2;
        for (const auto& [quadratic, x] : forms[static_cast<std::size_t>(first - rest.begin())]) {
            Monomial monomial = quadratic;
            for (unsigned i = 0; i < 4; ++i)
                monomial[i] += rest[i];
            matrix[row][index.at(monomial)] = x;
        }
    }
    Matrix extraneous;
    for (const std::size_t row : not_reduced) {
        extraneous.emplace_back();
        for (const std::size_t column : not_reduced)
            extraneous.back().push_back(matrix[row][column]);
    }
    return order_of_determinant(matrix) - order_of_determinant(extraneous);
}

struct Curve {
    std::array<Vector, 3> d;
    Vector p1, p2;
};

/// The order for an image at random.
unsigned order_along(const Curve& curve) {
    std::array<std::array<Number, 3>, 3> l;
    for (auto& line : l)
        std::ranges::generate(line, at_random);
    std::array<std::array<Number, 4>, 4> change;
    for (auto& row : change)
        std::ranges::generate(row, at_random);
    std::vector<Form> forms;
    for (unsigned i = 0; i < 3; ++i)
        forms.push_back(moved(form_of(l[i], curve.d[i]), change));
    const Number y1 = at_random(), y2 = at_random();
    Form last;
    for (const auto& [monomial, x] : form_of(l[1], curve.p1))
        add(last, monomial, y2, x);
    for (const auto& [monomial, x] : form_of(l[2], curve.p2))
        add(last, monomial, Number(0) - y1, x);
    forms.push_back(moved(last, change));
    return order_of_resultant(forms);
}

Vector general(unsigned u = 0, unsigned m = 0, unsigned z = 0) {
    return {series(u), series(m), series(z)};
}

} // namespace

TEST_CASE("resultants vanish twice for each exceptional divisor, for images at random") {
    constexpr unsigned zero = terms;
    const auto order = [](const std::array<Vector, 3>& d, const Vector& p1, const Vector& p2) {
        return order_along({d, p1, p2});
    };
    const Vector in_plane = general(1);
    CHECK(order({general(), general(), general()}, general(), general()) == 0);
    CHECK(order({general(), in_plane, general(1)}, general(), general()) == 0);
    CHECK(order({in_plane, general(1), general(1)}, general(), general()) == 2);       // A
    CHECK(order({in_plane, general(), general(1)}, general(), general(1)) == 2);       // G_1
    CHECK(order({in_plane, general(1), general()}, general(1), general()) == 2);       // G_2
    CHECK(order({general(zero), general(1), general(2)}, general(), general(1)) == 4); // A, G_1
    CHECK(order({general(2, 1), general(1), general(1)}, general(), general()) == 4);  // A, R
    CHECK(order({general(zero), general(), general(1)}, general(1, 1), general(2, zero)) ==
          4); // G, S
    CHECK(order({general(zero), general(1), general()}, general(2, zero), general(1, 1)) ==
          4); // G_2, S_2
    CHECK(order({general(2, 1), general(), general(zero)}, general(), general(1, zero)) ==
          4); // G_1, S_10
    CHECK(order({general(2, 1), general(zero), general()}, general(1, zero), general()) ==
          4); // G_2, S_20
    CHECK(order({general(4, 2), general(1), general(zero)}, general(), general(1, zero)) ==
          8); // and A, R
    CHECK(order({general(zero), general(), general(2, 1)}, general(), general(1, 0, zero)) ==
          4); // G_1, S_12
    CHECK(order({general(4, 2), general(zero), general(1)}, general(1, zero), general()) ==
          8); // and A, R
    // On G_2 but not on S_2, and twice as near to S_2.
    CHECK(order({general(zero), general(1), general()}, general(2, zero), general(1)) == 2);
    CHECK(order({general(zero), general(2), general()}, general(4, zero), general(2, 2)) == 8);
    // S_12 after S_1, whose equations are nu and x, y with m_2 = t v' + nu x, s = nu y; and G_1,
    // where s = 0, contains both.
    const Series s = series(2), t = series(0), ratio = series(1);
    const Vector d2{near_product(s, ratio, zero), near_product(t, ratio, 2), series(0)};
    CHECK(order({Vector{series(zero), series(0), series(zero)}, general(), d2}, general(1, 1),
                {s, t, series(zero)}) == 8);
}
