// Minors of problems from the blocks of their features, against exact determinants of all of J.
#include "checker/minimal/record.h"
#include "checker/problem/notation.h"
#include "tests/support/all_classes.h"
#include "tests/support/exact_determinant.h"
#include "tests/support/jacobian_points.h"

using namespace checker;

namespace {

using IntegerRow = std::vector<mpz_class>;
using IntegerRows = Rows<mpz_class>;

std::uint64_t modulo(const mpz_class& x) {
    return mpz_fdiv_ui(x.get_mpz_t(), modulus);
}

/// The components of a class at a random point.
std::vector<Component> random_components(const Signature& signature, RandomIntegers& random) {
    std::vector<Component> components;
    for (std::size_t i = 0; i < feature_count; ++i)
        for (unsigned k = 0; k < signature[i]; ++k)
            components.push_back(random_component(features[i], random));
    return components;
}

std::vector<const Block*> blocks_of(const std::vector<Component>& components) {
    std::vector<const Block*> blocks;
    for (const Component& component : components)
        blocks.push_back(&component.block);
    return blocks;
}

std::size_t own_unknowns(const std::vector<Component>& components) {
    std::size_t own = 0;
    for (const Component& component : components)
        own += component.block.unknowns;
    return own;
}

/// All of J: the features' own unknowns one after the other, then those of the cameras.
IntegerRows whole_jacobian(const std::vector<Component>& components) {
    const std::size_t own = own_unknowns(components);
    IntegerRows whole;
    std::size_t first = 0;
    for (const Component& component : components) {
        for (const IntegerRow& row : component.rows) {
            IntegerRow& full = whole.emplace_back(own + camera_unknowns);
            for (std::size_t c = 0; c < row.size(); ++c)
                full[c < component.block.unknowns ? first + c
                                                  : own + c - component.block.unknowns] = row[c];
        }
        first += component.block.unknowns;
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
        const std::vector<Component> components =
            random_components(all_classes().representatives[n], random);
        std::vector<const Component*> pointers;
        for (const Component& component : components)
            pointers.push_back(&component);
        const IntegerRows whole = whole_jacobian(components);
        REQUIRE(whole.size() == own_unknowns(components) + camera_unknowns);
        CHECK(minor_of(blocks_of(components), camera_unknowns).value ==
              modulo(exact_determinant(whole)));

        const auto size = static_cast<int>(whole.size());
        const auto shift = static_cast<int>(n % 3);
        const MinorClaim claim{.deleted_rows = {1 + shift, size / 2, size - shift},
                               .deleted_columns = {2, 3, 9}};
        CHECK(minor_without(claim, pointers, camera_unknowns).value ==
              modulo(exact_determinant(without(whole, claim.deleted_rows, claim.deleted_columns))));
    }
}

TEST_CASE("a minor is 0 where the blocks leave more conditions than there are camera columns") {
    RandomIntegers random;
    Signature signature{};
    signature[index_of("P/P/P")] = 4; // which weigh 12
    const std::vector<Component> components = random_components(signature, random);
    std::vector<const Block*> blocks = blocks_of(components);
    CHECK(minor_of(blocks, camera_unknowns) == Residue{});
    blocks.pop_back();
    CHECK(minor_of(blocks, camera_unknowns, {10, 11}) != Residue{});
    CHECK(minor_of(blocks, camera_unknowns, {11}) == Residue{}); // not square
}

TEST_CASE("the conditions that elimination leaves are the weight, modulo q the same, scaled") {
    RandomIntegers random;
    for (const Feature& feature : features) {
        const Component component = random_component(feature, random);
        CHECK(component.block.unknowns == feature.unknowns());
        CHECK(component.rows.size() == feature.equations);
        CHECK(component.block.rows() == feature.equations);
        REQUIRE(component.conditions.size() == feature.weight());
        REQUIRE(component.block.left.size() == feature.weight());
        const IntegerRow& exact = component.conditions[0];
        const std::vector<Residue>& scaled = component.block.left[0];
        std::size_t column = 0; // in which the first condition has an entry
        while (column < camera_unknowns - 1 && scaled[column] == Residue{})
            ++column;
        REQUIRE(!(scaled[column] == Residue{}));
        for (std::size_t i = 0; i < component.conditions.size(); ++i)
            for (std::size_t c = 0; c < camera_unknowns; ++c)
                CHECK(component.block.left[i][c] * residue(exact[column]) ==
                      residue(component.conditions[i][c]) * scaled[column]);
    }
}

TEST_CASE("det J by elimination is the determinant of the whole of J, in its order") {
    RandomIntegers random;
    std::size_t not_zero = 0;
    for (const char* notation :
         {"5*P/P", "2*Pa/Pa/Pa + P/P/P", "a/a/a + 3*P/P/P", "P/P/P + a/a/a + Pa/Pa/Pa + Pb/Pb/Pb",
          "3*PL/PL/PL + 2*P/P/P", "PL/PL/PL + PM/PM/PM + PLM/PLM/PLM + a/a/a + P/P/P",
          "projective: 7*P/P", "projective: 3*PL/PL/PL + 5*P/P/P + a/a/a + Pa/Pa/Pa",
          "projective: 2*PLab/PLab/PLab/PLab + PLabcd/PLabcd/PLabcd/PLabcd"}) {
        CAPTURE(notation);
        const std::string line = std::string(notation) + '\n';
        Reader reader(line);
        const Problem problem = read_notation(reader).problem;
        Placement placement;
        for (std::size_t i = 0; i < scene_size(problem); ++i)
            placement.scene.push_back(random(999));
        for (int view = 1; view < problem.view_count(); ++view) {
            Numbers& camera = placement.cameras.emplace_back();
            for (std::size_t i = 0; i < problem.cameras->numbers; ++i)
                camera.push_back(random(999));
        }
        const Jacobian<mpz_class> j = jacobian<mpz_class>(problem, placement);
        CHECK(modulo_q(j.rows) == jacobian<Residue>(problem, placement).rows);
        if (j.rows.size() != j.rows[0].size()) {
            CHECK(surplus(problem) != 0);
            continue;
        }
        const Residue minor = jacobian_determinant(problem, placement);
        CHECK(minor.value == modulo(exact_determinant(j.rows)));
        not_zero += minor == Residue{} ? 0 : 1;
    }
    CHECK(not_zero >= 4);
}
