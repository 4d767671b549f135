// Theorem Z of proofs/blown_up_cameras.md, by the program's integrals.
#include "proofs/computations/blown_up_cameras.h"

#include "checker/bounds/theorems.h"
#include "tests/checker/bounds/degrees_on_file.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace proofs::blown_up;

namespace {

std::int64_t degree(std::string_view problem) {
    static const Integrals integrals;
    const checker::Signature signature =
        checker::constraint_class(all_classes().representatives[class_of(problem)]);
    CHECK(has_degree_by_blow_up(signature));
    return integrals.of(signature);
}

bool applies(std::string_view problem) {
    return has_degree_by_blow_up(
        checker::constraint_class(all_classes().representatives[class_of(problem)]));
}

} // namespace

TEST_CASE("Theorem Z has the degrees of other theorems") {
    CHECK(degree("P/P/P + 4*a/a/a") == 360);              // Y
    CHECK(degree("Pab/Pab/Pab + 3*a/a/a") == 552);        // Y
    CHECK(degree("Pabc/Pabc/Pabc + Pab/Pab/Pab") == 480); // Y
    CHECK(degree("Pa/Pa/Pa + P/P/P + 2*a/a/a") == 264);   // U17
    CHECK(degree("3*P/P/P + a/a/a") == 216);              // U15
    CHECK(degree("2*Pa/Pa/Pa + P/P/P") == 312);           // U15
}

TEST_CASE("Theorem Z: the largest degree on file") {
    CHECK(degree("4*P/a/a + 4*a/P/a + 3*a/a/P") == 43224);
}

TEST_CASE("Theorem Z does not speak of points with four pins, nor of many points that two views "
          "share") {
    CHECK_FALSE(applies("Pabcd/Pabcd/Pabcd + 2*a/a/a"));
    CHECK_FALSE(applies("4*-/P/P + 4*P/a/a + 3*a/P/a"));
}

TEST_CASE("a common centre of two cameras: its image is on two given lines at most") {
    constexpr std::size_t first = 0;
    const auto of = [](std::map<std::string_view, unsigned> counts) {
        return may_have_common_centre(signature_of(counts), first);
    };
    CHECK(of({{"-/P/P", 3}, {"P/a/a", 8}}));
    CHECK(of({{"-/P/P", 3}, {"a/a/a", 3}, {"P/a/a", 2}}));       // two lines, one by the rotation
    CHECK_FALSE(of({{"-/P/P", 3}, {"a/a/a", 4}}));               // the rotation allows no second
    CHECK_FALSE(of({{"P/P/P", 2}, {"-/P/P", 1}, {"a/P/a", 4}})); // two points do not agree
    CHECK(of({{"P/P/P", 1}, {"-/P/P", 2}, {"a/P/a", 3}, {"P/a/a", 3}}));
}

TEST_CASE("Theorem Z applies to 5,074 constraint classes, and has their degrees on file") {
    const Integrals integrals;
    std::size_t count = 0;
    for (const auto& [signature, on_file] : degrees_on_file()) {
        if (!has_degree_by_blow_up(signature)) continue;
        ++count;
        CHECK(integrals.of(signature) == static_cast<std::int64_t>(on_file));
    }
    CHECK(count == 5074);
}

TEST_CASE("the integrals do not depend on the weights of the torus, and are 0 in other degrees") {
    const Integrals some, others(77);
    const auto problem = signature_of({{"P/P/P", 2}, {"a/Pa/Pa", 1}, {"P/a/a", 1}, {"-/P/P", 1}});
    CHECK(some.of(problem) == others.of(problem));
    CHECK(some.of(signature_of({{"P/P/P", 2}, {"-/P/P", 4}})) == 0);
    CHECK(some.of(signature_of({{"a/a/a", 1}})) == 0);
}

TEST_CASE("fibres of the second blow-up: a divisor over two null views meets its lines in -1") {
    // At the origin of a plane: the integral of the square of the divisor, over the weights.
    FixedPoint at;
    at.image = {Residue{3}, Residue{10}, {}};
    Residue square, one;
    for (const Chart& chart : charts_over(at)) {
        one = one + chart.factor;
        square = square + chart.factor * chart.both[2] * chart.both[2];
    }
    CHECK(one == Residue{1});
    CHECK(square == -Residue{30}); // -1 times the class of the origin
}
