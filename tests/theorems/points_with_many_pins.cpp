// Theorem K of proofs/points_with_many_pins.md, by the program's integrals.
#include "proofs/computations/four_pins.h"
#include "tests/checker/bounds/degrees_on_file.h"

#include <doctest/doctest.h>

using namespace proofs::blown_up;

namespace {

const Integrals& integrals() {
    static const Integrals all = integrals_with_stars();
    return all;
}

const FourPinIntegrals& four_pin_integrals() {
    static const FourPinIntegrals all;
    return all;
}

checker::Signature constraints(std::string_view problem) {
    return checker::constraint_class(all_classes().representatives[class_of(problem)]);
}

bool has_four_pins(const checker::Signature& signature) {
    for (std::size_t i = 0; i < checker::feature_count; ++i)
        if (signature[i] > 0 && checker::features[i].pins == 4) return true;
    return false;
}

} // namespace

TEST_CASE("Theorem K has the degrees of other theorems") {
    const auto degree = [](std::string_view problem) {
        CHECK(has_degree_with_many_pins(constraints(problem)));
        return integrals().of(constraints(problem));
    };
    CHECK(degree("Pabcd/Pabcd/Pabcd + 2*a/a/a") == 480);           // Y
    CHECK(degree("Pabcd/Pabcd/Pabcd + Pa/Pa/Pa") == 240);          // Y and U11
    CHECK(degree("Pabcd/Pabcd/Pabcd + P/P/P + P/a/a") == 272);     // U11
    CHECK(degree("Pabcde/Pabcde/Pabcde + P/P/P") == 64);           // U8
    CHECK(degree("Pabcde/Pabcde/Pabcde + a/a/a + -/P/P") == 240);  // U11
    CHECK(degree("Pabcde/Pabcde/Pabcde + a/P/Pa + P/-/P") == 272); // U11
}

TEST_CASE("Theorem K applies to 75 constraint classes, and has their degrees on file") {
    std::size_t first_part = 0, second_part = 0;
    for (const auto& [signature, on_file] : degrees_on_file()) {
        if (!has_degree_with_many_pins(signature)) continue;
        const auto degree = static_cast<std::int64_t>(on_file);
        if (views_share_few_points(signature)) {
            CHECK(integrals().of(signature) == degree);
            ++first_part;
        }
        if (has_four_pins(signature)) {
            CHECK(four_pin_integrals().of(signature) == degree);
            ++second_part;
        }
    }
    CHECK(first_part == 59);
    CHECK(second_part == 57);
}

TEST_CASE("Theorem K does not speak of points with three or six pins") {
    CHECK_FALSE(has_degree_with_many_pins(constraints("Pabc/Pabc/Pabc + 2*a/a/a + P/a/a")));
    CHECK_FALSE(has_degree_with_many_pins(constraints("Pabcdef/Pabcdef/Pabcdef + 2*P/a/a")));
    CHECK_FALSE(has_degree_with_many_pins(constraints("Pabcde/Pabcde/Pabcde + 2*-/P/P + P/a/a")));
    CHECK(has_degree_with_many_pins(constraints("Pabcd/Pabcd/Pabcd + 2*-/P/P + 2*P/a/a")));
}

TEST_CASE("the integrals are 0 for a problem that is not minimal, and in other degrees") {
    const auto four = [](std::map<std::string_view, unsigned> counts) {
        return four_pin_integrals().of(signature_of(counts));
    };
    CHECK(four({{"Pabcd/Pabcd/Pabcd", 1}, {"-/P/P", 4}}) == 0);
    CHECK(four({{"Pabcd/Pabcd/Pabcd", 1}, {"-/P/P", 1}, {"P/a/a", 2}}) == 0);
    CHECK(integrals().of(signature_of({{"Pabcde/Pabcde/Pabcde", 1}, {"P/a/a", 2}})) == 0);
}

TEST_CASE("the integrals do not depend on the weights of the torus") {
    const auto problem =
        signature_of({{"Pabcde/Pabcde/Pabcde", 1}, {"-/P/P", 1}, {"P/a/a", 1}, {"a/P/a", 1}});
    CHECK(integrals_with_stars(77).of(problem) == integrals().of(problem));
}
