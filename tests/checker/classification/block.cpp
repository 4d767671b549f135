// Minors of problems from the blocks of their features, against exact determinants of all of J.
#include "checker/classification/block.h"
#include "tests/support/all_classes.h"
#include "tests/support/exact_determinant.h"
#include "tests/support/jacobian_points.h"

using namespace checker;

namespace {

std::uint64_t modulo(const mpz_class& x) {
    return mpz_fdiv_ui(x.get_mpz_t(), modulus);
}

/// The blocks of a class at a random point.
std::vector<Block> random_blocks(const Signature& signature, RandomIntegers& random) {
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < feature_count; ++i)
        for (unsigned k = 0; k < signature[i]; ++k) {
            const Placement placement = random_placement(features[i], random);
            blocks.push_back(eliminate(features[i].unknowns(),
                                       jacobian_rows(features[i], placement, three_cameras())));
        }
    return blocks;
}

std::size_t own_unknowns(const std::vector<Block>& blocks) {
    std::size_t own = 0;
    for (const Block& block : blocks)
        own += block.unknowns;
    return own;
}

/// All of J: the features' own unknowns one after the other, then those of the cameras.
IntegerRows whole_jacobian(const std::vector<Block>& blocks) {
    const std::size_t own = own_unknowns(blocks);
    IntegerRows whole;
    std::size_t first = 0;
    for (const Block& block : blocks) {
        for (const IntegerRow& row : block.rows) {
            IntegerRow& full = whole.emplace_back(own + camera_unknowns);
            for (std::size_t c = 0; c < row.size(); ++c)
                full[c < block.unknowns ? first + c : own + c - block.unknowns] = row[c];
        }
        first += block.unknowns;
    }
    return whole;
}

/// Without these rows and camera columns, numbered from 1.
IntegerRows without(const IntegerRows& whole, const Numbers& rows, const Numbers& columns) {
    const std::size_t own = whole.size() - camera_unknowns;
    const auto listed = [](const Numbers& list, std::size_t number) {
        return std::binary_search(list.begin(), list.end(), static_cast<int>(number));
    };
    IntegerRows rest;
    for (std::size_t r = 0; r < whole.size(); ++r) {
        if (listed(rows, r + 1)) continue;
        IntegerRow& entries = rest.emplace_back();
        for (std::size_t c = 0; c < whole.size(); ++c)
            if (c < own || !listed(columns, c - own + 1)) entries.push_back(whole[r][c]);
    }
    return rest;
}

} // namespace

TEST_CASE(
    "minors agree with the exact determinant of the whole of J, rows and columns deleted or not") {
    RandomIntegers random;
    for (std::size_t n = 100; n < all_classes().representatives.size(); n += 7001) {
        const std::vector<Block> blocks = random_blocks(all_classes().representatives[n], random);
        std::vector<const Block*> pointers;
        for (const Block& block : blocks)
            pointers.push_back(&block);
        const IntegerRows whole = whole_jacobian(blocks);
        REQUIRE(whole.size() == own_unknowns(blocks) + camera_unknowns);
        CHECK(minor_of(pointers, {}, {}).value == modulo(exact_determinant(whole)));

        const auto size = static_cast<int>(whole.size());
        const auto shift = static_cast<int>(n % 3);
        const Numbers rows{1 + shift, size / 2, size - shift}, columns{2, 3, 9};
        CHECK(minor_of(pointers, rows, columns).value ==
              modulo(exact_determinant(without(whole, rows, columns))));
    }
}

TEST_CASE("a minor is 0 where the blocks leave more conditions than there are camera columns") {
    RandomIntegers random;
    Signature signature{};
    signature[index_of("P/P/P")] = 4; // which weigh 12
    const std::vector<Block> blocks = random_blocks(signature, random);
    std::vector<const Block*> pointers;
    for (const Block& block : blocks)
        pointers.push_back(&block);
    CHECK(minor_of(pointers, {}, {}) == Residue{});
    pointers.pop_back();
    CHECK(minor_of(pointers, {}, {10, 11}) != Residue{});
}

TEST_CASE("elimination leaves as many conditions as a feature weighs, modulo q the same, scaled") {
    RandomIntegers random;
    for (const Feature& feature : features) {
        const Placement placement = random_placement(feature, random);
        const IntegerRows rows = jacobian_rows(feature, placement, three_cameras());
        const Block block = eliminate(feature.unknowns(), rows);
        CHECK(block.unknowns == feature.unknowns());
        CHECK(block.rows == rows);
        REQUIRE(block.conditions.size() == feature.weight());
        REQUIRE(block.residues.size() == feature.weight());
        const CameraMotion& exact = block.conditions[0];
        const ResidueRow& scaled = block.residues[0];
        std::size_t column = 0; // in which the first condition has an entry
        while (column < camera_unknowns - 1 && scaled[column] == Residue{})
            ++column;
        REQUIRE(!(scaled[column] == Residue{}));
        for (std::size_t i = 0; i < block.conditions.size(); ++i)
            for (std::size_t c = 0; c < camera_unknowns; ++c)
                CHECK(block.residues[i][c] * residue(exact[column]) ==
                      residue(block.conditions[i][c]) * scaled[column]);
    }
}
