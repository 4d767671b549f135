// Solutions with many digits become exact; and unknowns in which equations are linear follow.
#include "prover/fibres/exact_solutions.h"

#include "prover/fibres/linear_unknowns.h"

#include <array>
#include <doctest/doctest.h>
#include <utility>

using namespace plprove;

namespace {

using model::BigComplex;
using model::ManyDigits;
using model::Univariate;

/// x^3 = 2 and 3 x y = 1: three solutions, one of them real.
class CubeRoots : public model::DigitEquations {
public:
    std::vector<BigComplex> values(const Point& point, const ManyDigits& digits) const override {
        const BigComplex &x = point[0], &y = point[1];
        const BigComplex cube = digits.product(x, digits.product(x, x));
        return {digits.difference(cube, digits.constant(2)),
                digits.difference(digits.scaled(digits.product(x, y), 3), digits.constant(1))};
    }
    std::vector<std::vector<BigComplex>> slopes(const Point& point,
                                                const ManyDigits& digits) const override {
        const BigComplex &x = point[0], &y = point[1];
        return {{digits.scaled(digits.product(x, x), 3), digits.constant(0)},
                {digits.scaled(y, 3), digits.scaled(x, 3)}};
    }
};

/// With ten bits after the binary point: x is 1.26 and -0.63 + 1.09 i, y is 1 / (3 x).
const std::vector<StartingValues> cube_roots{{true, 10, {1290, 271}},
                                             {false, 10, {-645, 1117, -135, -235}}};

Univariate univariate(std::initializer_list<int> coefficients) {
    std::vector<Modular> residues;
    for (const int c : coefficients)
        residues.emplace_back(c);
    return Univariate(residues);
}

Univariate divided(const Univariate& a, int divisor) {
    Univariate result;
    nmod_poly_scalar_mul_nmod(result.get(), a.get(), Modular(divisor).inverse().value());
    return result;
}

bool are_equal(const Univariate& a, const Univariate& b) {
    return nmod_poly_equal(a.get(), b.get()) != 0;
}

} // namespace

TEST_CASE("three solutions are a polynomial, and polynomials in its root") {
    const auto exact = exact_solutions(CubeRoots(), cube_roots, {{1, 0}}, {});
    REQUIRE(exact);
    CHECK(exact->form == std::vector{1, 0});
    CHECK(are_equal(exact->solutions.polynomial, univariate({-2, 0, 0, 1})));
    REQUIRE(exact->solutions.unknowns.size() == 2);
    CHECK(are_equal(exact->solutions.unknowns[0], univariate({0, 1})));
    CHECK(are_equal(exact->solutions.unknowns[1], divided(univariate({0, 0, 1}), 6)));
}

TEST_CASE("a form that has one value at two solutions is passed over; without another one there is "
          "nothing") {
    std::vector<StartingValues> twice = cube_roots;
    twice.push_back(twice.front());
    CHECK(!exact_solutions(CubeRoots(), twice, forms_of(2, 0), {}));
    const auto exact = exact_solutions(CubeRoots(), cube_roots, {{0, 0}, {0, 1}}, {});
    REQUIRE(exact);
    CHECK(exact->form == std::vector{0, 1});
    CHECK(are_equal(exact->solutions.unknowns[0], univariate({0, 0, 18}))); // y^3 = 1/54
}

namespace {

/// x is 1, 2 or 3 and 1 / large, and y = x^2.
class NearIntegers : public model::DigitEquations {
public:
    static constexpr std::int64_t large = 1'000'000'000'000'000'000;

    std::vector<BigComplex> values(const Point& point, const ManyDigits& digits) const override {
        const BigComplex& x = point[0];
        return {product(digits, {factor(x, 1, digits), factor(x, 2, digits), factor(x, 3, digits)}),
                digits.difference(point[1], digits.product(x, x))};
    }
    std::vector<std::vector<BigComplex>> slopes(const Point& point,
                                                const ManyDigits& digits) const override {
        const BigComplex& x = point[0];
        BigComplex slope = digits.constant(0);
        for (const auto& [i, k] : {std::pair(1, 2), {2, 3}, {3, 1}})
            slope = digits.sum(slope, product(digits, {digits.constant(large), factor(x, i, digits),
                                                       factor(x, k, digits)}));
        return {{slope, digits.constant(0)}, {digits.scaled(x, -2), digits.constant(1)}};
    }

private:
    static BigComplex factor(const BigComplex& x, std::int64_t n, const ManyDigits& digits) {
        return digits.difference(digits.scaled(x, large), digits.constant(n * large + 1));
    }
    static BigComplex product(const ManyDigits& digits, const std::array<BigComplex, 3>& factors) {
        return digits.product(factors[0], digits.product(factors[1], factors[2]));
    }
};

} // namespace

TEST_CASE("solutions with long denominators become exact") {
    const std::vector<StartingValues> starts{
        {true, 0, {1, 1}}, {true, 0, {2, 4}}, {true, 0, {3, 9}}};
    const auto exact = exact_solutions(NearIntegers(), starts, forms_of(2, 0), {});
    REQUIRE(exact);
    const auto at = [](const Univariate& polynomial, Modular t) {
        return Modular(nmod_poly_evaluate_nmod(polynomial.get(), t.value()));
    };
    for (const int n : {1, 2, 3}) {
        const Modular t = Modular(n) + Modular(NearIntegers::large).inverse();
        CHECK(at(exact->solutions.polynomial, t) == Modular(0));
        CHECK(at(exact->solutions.unknowns[0], t) == t);
        CHECK(at(exact->solutions.unknowns[1], t) == t * t);
    }
}

TEST_CASE("unknowns in which the equations are linear are found in the algebra") {
    const UnivariateField field(univariate({-2, 0, 0, 1}));
    const Univariate t = univariate({0, 1});
    // t y + z = 1, t z = 2 and, which these imply, t^2 y = t - 2.
    const auto equations = [&](int constant) {
        return [&field, constant](const std::vector<Univariate>& x) {
            const auto times = [&](const Univariate& a, const Univariate& b) {
                return field.product(a, b);
            };
            const Univariate third = field.difference(x[0], field.constant(constant));
            return std::vector{
                field.difference(field.sum(times(x[0], x[1]), x[2]), field.constant(1)),
                field.difference(times(x[0], x[2]), field.constant(2)),
                field.difference(times(times(x[0], x[0]), x[1]), third)};
        };
    };
    const auto solved = with_linear_unknowns(field, {t}, 2, equations(2));
    REQUIRE(solved);
    REQUIRE(solved->size() == 3);
    CHECK(are_equal((*solved)[0], t));
    CHECK(are_equal((*solved)[2], univariate({0, 0, 1}))); // 2 / t
    CHECK(are_equal(field.product(t, (*solved)[1]), univariate({1, 0, -1})));
    CHECK(!with_linear_unknowns(field, {t}, 2, equations(3)));
    // At the root 0 of g the first two say nothing of y.
    const UnivariateField other(univariate({0, -2, 0, 0, 1}));
    CHECK(!with_linear_unknowns(other, {t}, 2, equations(2)));
}
