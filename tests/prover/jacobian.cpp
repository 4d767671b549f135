// Minors of the Jacobian: elimination by blocks against the whole matrix, and the laws of
// certificates; and ball arithmetic as a second method for a determinant.
#include "prover/minimal/classification_file.h"
#include "prover/minimal/problem_file.h"

#include <doctest/doctest.h>
#if __has_include(<flint/arb_mat.h>)
#include <flint/arb_mat.h>
#else
#include <arb_mat.h>
#endif

using namespace plprove;

namespace {

std::vector<FeatureBlock> blocks_of(const Signature& signature, const Pool& pool) {
    std::vector<FeatureBlock> blocks;
    for (std::size_t i = 0; i < feature_count; ++i)
        for (std::size_t copy = 0; copy < signature[i]; ++copy)
            blocks.push_back(feature_block(pool.instances[i][copy], pool.cameras));
    return blocks;
}

std::vector<CameraPart> eliminated(const std::vector<FeatureBlock>& blocks) {
    std::vector<CameraPart> parts;
    for (const FeatureBlock& block : blocks)
        parts.push_back(eliminate(block).value());
    return parts;
}

} // namespace

TEST_CASE("block elimination gives the determinant of the whole Jacobian, sign included") {
    const std::vector<Signature>& classes = label_classes();
    const Pool pool = make_pool(1);
    for (std::size_t number = 0; number < classes.size(); number += 509) {
        CAPTURE(number);
        const auto blocks = blocks_of(classes[number], pool);
        const ResidueMatrix whole = jacobian(pointers(blocks));
        REQUIRE(whole.rows() == whole.columns());
        CHECK(determinant(pointers(eliminated(blocks))) == nmod_mat_det(whole.get()));
    }
}

TEST_CASE("the rank of the whole Jacobian falls short by max(E, S), for every obstructed class") {
    const std::vector<Signature>& classes = label_classes();
    const Pool pool = make_pool(2);
    for (const Signature& signature : classes) {
        const int deficiency = obstruction(problem_of(signature)).deficiency();
        if (deficiency == 0) continue;
        CAPTURE(notation(problem_of(signature)));
        const ResidueMatrix whole = jacobian(pointers(blocks_of(signature, pool)));
        CHECK(whole.rows() - nmod_mat_rank(whole.get()) == deficiency);
    }
}

TEST_CASE("another pool certifies the same classes") {
    // Classes are minimal or not whatever the coordinates: a sample in pools that the archive does
    // not use.
    const std::vector<Signature>& classes = label_classes();
    for (const std::uint64_t seed : {101U, 102U, 103U}) {
        const Pool pool = make_pool(seed);
        for (std::size_t number = seed; number < classes.size(); number += 2003) {
            CAPTURE(number);
            const auto blocks = blocks_of(classes[number], pool);
            const auto parts = eliminated(blocks);
            const PosedProblem posed{obstruction(problem_of(classes[number])), pointers(blocks),
                                     pointers(parts)};
            CHECK(find_minor(posed).has_value());
        }
    }
}

TEST_CASE("a problem certified by itself has small coordinates") {
    const std::vector<Signature>& classes = label_classes();
    for (const std::size_t number : {std::size_t{0}, std::size_t{2394}, classes.size() - 1}) {
        const ProblemFile certificate = certify_problem(problem_of(classes[number]));
        for (const PlacedFeature& placed : certificate.features)
            for (const std::int64_t coordinate : placed.point)
                CHECK(std::abs(coordinate) <= 9);
    }
}

TEST_CASE("ball arithmetic over the integers certifies that determinants do not vanish") {
    const std::vector<Signature>& classes = label_classes();
    const Pool pool = make_pool(1);
    constexpr slong precision = 256;
    for (std::size_t number = 5; number < classes.size(); number += 4001) {
        if (obstruction(problem_of(classes[number])).deficiency() > 0) continue;
        // Entries are below 2^60, so that the residue nearest to zero is the integer itself.
        const ResidueMatrix whole = jacobian(pointers(blocks_of(classes[number], pool)));
        arb_mat_t matrix;
        arb_mat_init(matrix, whole.rows(), whole.columns());
        for (int i = 0; i < whole.rows(); ++i)
            for (int j = 0; j < whole.columns(); ++j) {
                const auto entry = static_cast<slong>(whole.at(i, j));
                const auto q = static_cast<slong>(modulus);
                arb_set_si(arb_mat_entry(matrix, i, j), entry > q / 2 ? entry - q : entry);
            }
        arb_t ball;
        arb_init(ball);
        arb_mat_det(ball, matrix, precision);
        CAPTURE(number);
        CHECK_FALSE(arb_contains_zero(ball));
        arb_clear(ball);
        arb_mat_clear(matrix);
    }
}
