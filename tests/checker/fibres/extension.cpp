// Arithmetic modulo q and g, by other means than those of the checker.
#include "checker/fibres/extension.h"

#include "checker/fibres/frobenius.h"

#include <doctest/doctest.h>

#include <random>

using namespace checker;

namespace {
class RandomPolynomials {
public:
    Residue residue() { return Residue::of(engine_()); }
    Polynomial polynomial(std::size_t coefficients) {
        Polynomial result(coefficients);
        for (Residue& coefficient : result)
            coefficient = residue();
        return result;
    }

private:
    std::mt19937_64 engine_{61};
};

/// The product, term by term.
Polynomial by_terms(const Polynomial& a, const Polynomial& b) {
    Polynomial result(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < b.size(); ++k)
            result[i + k] = result[i + k] + a[i] * b[k];
    return result;
}

Polynomial with_degree(Polynomial a, std::size_t degree) {
    a.resize(degree);
    return a;
}

/// g without its highest term, for g the product of these.
Polynomial lower_of_product(const std::vector<Polynomial>& factors) {
    Polynomial g{{1}};
    for (const Polynomial& factor : factors)
        g = by_terms(g, factor);
    g.pop_back();
    return g;
}

/// t^l - c.
Polynomial pure(std::size_t degree, Residue c) {
    Polynomial result(degree + 1);
    result[0] = -c;
    result[degree] = {1};
    return result;
}

/// Whether c is an l-th power modulo q, for a prime l that divides q - 1.
bool is_power(Residue c, std::uint64_t l) {
    return power(c, (modulus - 1) / l) == Residue{1};
}
} // namespace

TEST_CASE("a product modulo g is the remainder of the product term by term") {
    RandomPolynomials random;
    for (const std::size_t degree : {1U, 2U, 3U, 17U, 99U, 100U, 101U, 130U}) {
        const Extension extension(random.polynomial(degree));
        const Polynomial a = random.polynomial(degree), b = random.polynomial(degree);
        Polynomial expected = by_terms(a, b);
        while (!expected.empty() && expected.back() == Residue{})
            expected.pop_back();
        expected = with_degree(remainder(expected, extension.modulus_polynomial()), degree);
        CHECK(extension.multiply(a, b) == expected);
        const auto inverse = extension.inverse(a);
        REQUIRE(inverse);
        CHECK(extension.multiply(a, *inverse) == extension.constant({1}));
    }
}

TEST_CASE("the largest coefficients do not run over") {
    const std::size_t degree = 140;
    const Polynomial largest(degree, Residue{modulus - 1});
    const Extension extension(largest);
    const Polynomial expected =
        remainder(by_terms(largest, largest), extension.modulus_polynomial());
    CHECK(extension.multiply(largest, largest) == with_degree(expected, degree));
}

TEST_CASE("what has a root in common with g has no inverse") {
    RandomPolynomials random;
    const Polynomial common = pure(1, random.residue());
    const Extension extension(
        lower_of_product({common, pure(1, random.residue()), pure(1, random.residue())}));
    const Polynomial a = with_degree(by_terms(common, random.polynomial(2)), 3);
    CHECK_FALSE(extension.inverse(a));
    CHECK_FALSE(extension.is_unit(a));
    CHECK(extension.is_unit(random.polynomial(3)));
}

TEST_CASE("t^l - c is irreducible if c is no l-th power, else a product of factors of degree 1") {
    RandomPolynomials random;
    int irreducible = 0, reducible = 0;
    for (const std::size_t l : {2U, 3U, 5U, 7U, 11U, 13U, 31U}) {
        REQUIRE((modulus - 1) % l == 0);
        for (int n = 0; n < 4; ++n) {
            const Residue c = n == 0 ? power(random.residue(), l) : random.residue();
            Polynomial lower = pure(l, c);
            lower.pop_back();
            CHECK(cycle_type_of(lower) == (is_power(c, l) ? CycleType(l, 1) : CycleType{l}));
            ++(is_power(c, l) ? reducible : irreducible);
        }
    }
    CHECK(irreducible > 0);
    CHECK(reducible > 0);
}

TEST_CASE("the cycles of a product are those of its factors") {
    RandomPolynomials random;
    for (std::size_t linear = 0; linear < 4; ++linear)
        for (std::size_t quadratic = 0; quadratic < 4; ++quadratic)
            for (std::size_t cubic = 0; cubic < 3; ++cubic) {
                if (linear + quadratic + cubic == 0) continue;
                std::vector<Polynomial> factors;
                CycleType lengths;
                const auto add = [&](std::size_t l) {
                    Residue c = random.residue();
                    while (l > 1 && is_power(c, l))
                        c = random.residue();
                    factors.push_back(pure(l, c));
                    lengths.push_back(l);
                };
                for (std::size_t n = 0; n < linear; ++n)
                    add(1);
                for (std::size_t n = 0; n < quadratic; ++n)
                    add(2);
                for (std::size_t n = 0; n < cubic; ++n)
                    add(3);
                CHECK(cycle_type_of(lower_of_product(factors)) == lengths);
            }
}
