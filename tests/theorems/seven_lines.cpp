// Lemma N9 of proofs/seven_lines.md: where seven lines of a star are known, the integral of Theorem
// N is twice a number of Schubert calculus, found here by Pieri's rule.
#include "proofs/computations/star_cameras.h"

#include <doctest/doctest.h>

using proofs::star::ManyPins;
using proofs::star::zeros;

namespace {

/// A class on the Grassmannian G(2,6): entry [i][j] is the multiple of sigma_{ij}, 4 >= i >= j.
using Schubert = std::array<std::array<std::int64_t, 5>, 5>;

/// Pieri's rule: all ways to add this many boxes, at most one to a column.
Schubert times_row(const Schubert& x, std::size_t boxes) {
    Schubert product{};
    for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t j = 0; j <= i; ++j)
            for (std::size_t below = 0; below <= boxes && j + below <= i; ++below)
                if (const std::size_t above = i + boxes - below; above < 5)
                    product[above][j + below] += x[i][j];
    return product;
}

/// The product with sigma_{11}: one box more in both rows.
Schubert times_column(const Schubert& x) {
    Schubert product{};
    for (std::size_t i = 1; i < 5; ++i)
        for (std::size_t j = 1; j <= i; ++j)
            product[i][j] = x[i - 1][j - 1];
    return product;
}

std::int64_t schubert_number(const ManyPins& problem) {
    Schubert x{};
    x[0][0] = 1;
    for (const unsigned pins : problem.others) {
        x = times_column(x);
        for (unsigned i = 0; i < pins; ++i)
            x = times_row(x, 1);
    }
    for (unsigned i = 0; i < problem.lines; ++i)
        x = times_row(x, 2);
    return x[4][4];
}

struct Case {
    ManyPins problem;
    std::int64_t number;
};

/// The table of Lemma N9: all balanced problems with seven lines.
const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {{7, {}, 4}, 3},     {{6, {4}, 1}, 3},    {{6, {2}, 2}, 2},    {{6, {0}, 3}, 1},
        {{6, {6}, 0}, 5},    {{5, {4, 0}, 0}, 2}, {{5, {3, 1}, 0}, 2}, {{5, {2, 2}, 0}, 2},
        {{5, {2, 0}, 1}, 1}, {{5, {1, 1}, 1}, 1}, {{5, {0, 0}, 2}, 1}};
    return all;
}

} // namespace

TEST_CASE("Lemma N9: with seven lines the integral is twice a Schubert number") {
    for (const auto& [problem, number] : cases()) {
        CHECK(schubert_number(problem) == number);
        CHECK(zeros(problem) == 2 * number);
    }
}

TEST_CASE("Theorem N: integrals are for five pins or more") {
    CHECK_THROWS_AS(zeros({4, {4, 1}, 1}), std::invalid_argument);
}
