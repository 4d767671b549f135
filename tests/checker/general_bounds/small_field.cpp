// Arithmetic modulo 2^31 - 1 by a second method, and ranks by FLINT.
#include "checker/general_bounds/small_field.h"

#include <doctest/doctest.h>
#include <flint/nmod_mat.h>

#include <random>

using namespace checker;

TEST_CASE("sums, products and inverses are those of integers") {
    std::mt19937_64 random(1);
    for (int i = 0; i < 1000; ++i) {
        const std::uint64_t a = random(), b = random();
        const Small x = Small::of(a), y = Small::of(b);
        CHECK(x.value == a % small_prime);
        CHECK((x + y).value == (a % small_prime + b % small_prime) % small_prime);
        CHECK((x * y).value == (a % small_prime) * (b % small_prime) % small_prime);
        CHECK((x - y + y) == x);
        if (x != Small{}) CHECK(x * x.inverse() == Small{1});
    }
    CHECK(Small::of(small_prime) == Small{});
    CHECK(Small::of(~std::uint64_t{0}).value == ~std::uint64_t{0} % small_prime);
    CHECK(Small::of_integer(-1).value == small_prime - 1);
    CHECK(Small::of_integer(-std::int64_t{small_prime}) == Small{});
}

TEST_CASE("the rank of rows is FLINT's, in whatever portions they come") {
    Choices choices;
    constexpr std::size_t columns = 40;
    for (const std::size_t rank : {0U, 1U, 13U, 40U}) {
        std::vector<SmallRow> basis, rows;
        for (std::size_t i = 0; i < rank; ++i)
            basis.push_back(choices.row(columns));
        nmod_mat_t matrix;
        nmod_mat_init(matrix, 60, columns, small_prime);
        for (std::size_t r = 0; r < 60; ++r) {
            SmallRow& row = rows.emplace_back(columns);
            for (const SmallRow& other : basis) {
                const Small factor = choices.next();
                for (std::size_t k = 0; k < columns; ++k)
                    row[k] = row[k] + factor * other[k];
            }
            for (std::size_t k = 0; k < columns; ++k)
                nmod_mat_entry(matrix, r, k) = row[k].value;
        }
        RowSpace one_by_one, at_once;
        for (const SmallRow& row : rows)
            one_by_one.add({row});
        CHECK(at_once.add(rows) == (rank > 0));
        CHECK(!at_once.add(rows));
        CHECK(one_by_one.rank() == static_cast<std::size_t>(nmod_mat_rank(matrix)));
        CHECK(at_once.rank() == one_by_one.rank());
        nmod_mat_clear(matrix);
    }
}
