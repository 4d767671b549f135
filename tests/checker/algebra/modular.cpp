// Arithmetic modulo q and determinants, against GMP, exact integers and FLINT.
#include "checker/algebra/modular.h"
#include "tests/support/exact_determinant.h"

#include <doctest/doctest.h>
#include <flint/nmod_mat.h>

#include <random>
#include <string>
#include <vector>

using namespace checker;

namespace {

using Entries = std::vector<std::vector<mpz_class>>;
using Residues = std::vector<std::vector<Residue>>;

mpz_class integer(std::uint64_t x) {
    mpz_class result;
    mpz_import(result.get_mpz_t(), 1, -1, sizeof x, 0, 0, &x);
    return result;
}

std::uint64_t modulo(const mpz_class& x) {
    return mpz_fdiv_ui(x.get_mpz_t(), modulus);
}

/// The residue of a number in decimal digits, digit by digit.
Residue by_digits(const std::string& decimal) {
    Residue value;
    for (const char c : decimal)
        if (c != '-') value = value * Residue{10} + Residue{static_cast<std::uint64_t>(c - '0')};
    return decimal.starts_with('-') ? -value : value;
}

/// Residues at the ends of the range, near the bounds of halves and thirds of words, and random.
std::vector<std::uint64_t> many_residues() {
    std::vector<std::uint64_t> values;
    for (unsigned bit = 0; bit < 61; ++bit)
        for (const std::uint64_t offset : {std::uint64_t{0}, std::uint64_t{1}, modulus - 1})
            values.push_back(((std::uint64_t{1} << bit) + offset) % modulus);
    for (const std::uint64_t small : {0, 1, 2, 3})
        for (const std::uint64_t x : {small, modulus - 1 - small})
            values.push_back(x);
    std::mt19937_64 random(20);
    for (int i = 0; i < 1000; ++i)
        values.push_back(random() % modulus);
    return values;
}

std::uint64_t flint_determinant(const Residues& m) {
    const auto size = static_cast<slong>(m.size());
    nmod_mat_t matrix;
    nmod_mat_init(matrix, size, size, modulus);
    for (std::size_t r = 0; r < m.size(); ++r)
        for (std::size_t c = 0; c < m.size(); ++c)
            nmod_mat_entry(matrix, static_cast<slong>(r), static_cast<slong>(c)) = m[r][c].value;
    const std::uint64_t result = nmod_mat_det(matrix);
    nmod_mat_clear(matrix);
    return result;
}

} // namespace

TEST_CASE("residues add, multiply and divide as GMP has it, at the extremes and in between") {
    const std::vector<std::uint64_t> values = many_residues();
    std::mt19937_64 random(7);
    const mpz_class q = integer(modulus);
    for (const std::uint64_t x : values) {
        for (int n = 0; n < 20; ++n) {
            const std::uint64_t y = values[random() % values.size()];
            CHECK((Residue{x} * Residue{y}).value == modulo(integer(x) * integer(y)));
            const std::uint64_t z = values[random() % values.size()];
            const std::uint64_t w = values[random() % values.size()];
            CHECK(Residue::sum_of_products({x}, {y}, {z}, {w}).value ==
                  modulo(integer(x) * integer(y) + integer(z) * integer(w)));
            CHECK((Residue{x} + Residue{y}).value == modulo(integer(x) + integer(y)));
            CHECK((Residue{x} - Residue{y}).value == modulo(integer(x) - integer(y)));
        }
        CHECK((Residue{x} * Residue{x}).value == modulo(integer(x) * integer(x)));
        CHECK((-Residue{x}).value == modulo(-integer(x)));
        if (x == 0) continue;
        mpz_class inverse;
        REQUIRE(mpz_invert(inverse.get_mpz_t(), integer(x).get_mpz_t(), q.get_mpz_t()) != 0);
        CHECK(Residue{x}.inverse().value == modulo(inverse));
        CHECK(Residue{x} * Residue{x}.inverse() == Residue{1});
    }
    const Residue last{modulus - 1};
    CHECK(last * last == Residue{1});
    CHECK(Residue::sum_of_products(last, last, last, last) == Residue{2});
}

TEST_CASE("a word of any size has its residue") {
    constexpr std::uint64_t one = 1;
    for (const std::uint64_t x :
         {one << 61, (one << 61) + 1, modulus, modulus - 1, 2 * modulus, 2 * modulus + 1, one << 62,
          one << 63, ~(one << 63), ~one, ~(one - 1)})
        CHECK(Residue::of(x).value == modulo(integer(x)));
    CHECK(Residue::of(modulus).value == 0);
    CHECK(Residue::of(~std::uint64_t{0}).value == 7);
    std::mt19937_64 random(3);
    for (int i = 0; i < 1000; ++i) {
        const std::uint64_t x = random();
        CHECK(Residue::of(x).value == modulo(integer(x)));
    }
}

TEST_CASE("an integer of any size and sign has its residue") {
    const mpz_class q = integer(modulus);
    CHECK(residue(0) == Residue{0});
    CHECK(residue(q) == Residue{0});
    CHECK(residue(-q) == Residue{0});
    CHECK(residue(-1) == Residue{modulus - 1});
    CHECK(residue((mpz_class(1) << 123) - 1).value == modulo((mpz_class(1) << 123) - 1));
    gmp_randclass random(gmp_randinit_default);
    random.seed(5);
    for (const unsigned bits : {1U, 31U, 32U, 33U, 60U, 61U, 62U, 63U, 64U, 65U, 127U, 128U, 3330U})
        for (int i = 0; i < 20; ++i)
            for (const mpz_class& x :
                 {mpz_class(random.get_z_bits(bits)), mpz_class(-random.get_z_bits(bits))}) {
                CHECK(residue(x).value == modulo(x));
                CHECK(residue(x) == by_digits(x.get_str()));
            }
}

TEST_CASE("determinants agree with exact ones and with FLINT's") {
    std::mt19937_64 random(20);
    for (int round = 0; round < 50; ++round) {
        const std::int64_t bound = round % 2 == 0 ? 1'000'000'000 : 1;
        std::uniform_int_distribution<std::int64_t> entry(-bound, bound);
        const std::size_t size = round < 40 ? 11 : 1 + static_cast<std::size_t>(round % 10) * 4;
        Entries exact(size, std::vector<mpz_class>(size));
        Residues m(size, std::vector<Residue>(size));
        for (std::size_t r = 0; r < size; ++r)
            for (std::size_t c = 0; c < size; ++c) {
                exact[r][c] = std::to_string(entry(random));
                m[r][c] = {modulo(exact[r][c])};
            }
        CHECK(determinant(m).value == modulo(exact_determinant(exact)));
        CHECK(determinant(m).value == flint_determinant(m));
        if (size != 11) continue;
        Residues swapped = m;
        std::swap(swapped[3], swapped[8]);
        CHECK(determinant(swapped) == -determinant(m));
        m[7] = m[2];
        CHECK(determinant(m) == Residue{});
    }
}

TEST_CASE("determinants of residues of any size, singular ones too, are FLINT's") {
    std::mt19937_64 random(21);
    for (std::size_t size = 1; size <= 40; ++size) {
        Residues m(size, std::vector<Residue>(size));
        for (auto& row : m)
            for (Residue& entry : row)
                entry = {random() % 3 == 0 ? modulus - 1 - random() % 2 : random() % modulus};
        CHECK(determinant(m).value == flint_determinant(m));
        for (Residue& entry : m.back())
            entry = {}; // the last row is a combination of the others
        for (std::size_t r = 0; r + 1 < size; ++r) {
            const Residue factor{random() % modulus};
            for (std::size_t c = 0; c < size; ++c)
                m.back()[c] = m.back()[c] + factor * m[r][c];
        }
        CHECK(determinant(m) == Residue{});
        CHECK(flint_determinant(m) == 0);
    }
}
