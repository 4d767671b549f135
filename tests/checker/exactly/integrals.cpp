// The integrals of Theorems C and K, against degrees that monodromy found and certificates bound
// from below, and by laws.
#include "checker/exactly/degree.h"
#include "checker/exactly/many_pins.h"

#include "tests/support/degrees_on_file.h"
#include "tests/support/results.h"

#include <doctest/doctest.h>

#include <set>

using namespace checker;
using namespace checker::exactly;

namespace {
unsigned most_pins(const Signature& signature) {
    unsigned most = 0;
    for (std::size_t i = 0; i < feature_count; ++i)
        if (signature[i] > 0) most = std::max(most, features[i].pins);
    return most;
}

/// The most points that two views share.
unsigned most_shared(const Signature& signature) {
    unsigned most = 0;
    for (const Views pair : view_pairs)
        most = std::max(most, shared_points(signature, pair));
    return most;
}
} // namespace

TEST_CASE("the degrees of all 10,073 constraint classes of minimal problems are those on file") {
    std::map<Signature, std::size_t> on_file;
    std::ifstream file(CERTS_DIR "/degrees/lower-bounds.txt");
    for (std::string line; std::getline(file, line);) {
        std::size_t number = 0, solutions = 0;
        const char* form = "class %zu: certified to have at least %zu solutions";
        if (std::sscanf(line.c_str(), form, &number, &solutions) == 2)
            on_file[constraint_class(all_classes().representatives[number])] = solutions;
    }
    REQUIRE(on_file.size() == 10073);
    const DegreeTable& computed = whole_report().findings.degrees;
    CHECK(computed.size() == on_file.size());
    std::map<std::string_view, std::size_t> by_theorem;
    for (const auto& [signature, solutions] : on_file) {
        const auto degree = bounds_of(computed, signature).theorem;
        REQUIRE(degree.has_value());
        CHECK(degree->solutions == solutions);
        CHECK(degree->solutions % 8 == 0); // Theorem G
        ++by_theorem[degree->theorem];
    }
    CHECK(by_theorem["C"] == 9989);
    CHECK(by_theorem["K"] == 75);
    CHECK(by_theorem["U8"] == 6);
    CHECK(by_theorem["U11"] == 3);
}

TEST_CASE("the integral is 0 where a problem with at most three pins is not minimal") {
    std::set<Signature> classes;
    for (std::size_t number = 0; number < all_classes().representatives.size(); ++number) {
        const Signature key = constraint_class(all_classes().representatives[number]);
        if (!is_minimal_class(number) && most_pins(key) <= 3) classes.insert(key);
    }
    CHECK(classes.size() == 614);
    Integrals few(7);
    std::size_t tried = 0;
    for (const Signature& signature : classes) {
        if (most_shared(signature) > 7) continue;
        ++tried;
        CHECK(few.over_third_blow_up(signature) == 0);
    }
    CHECK(tried > 400);
}

TEST_CASE("the integral is 0 where two views share up to eleven points") {
    Integrals many(11);
    for (const unsigned points : {8U, 9U, 10U, 11U}) {
        CHECK(many.over_third_blow_up(signature_of({{"-/P/P", points}, {"a/P/a", 11 - points}})) ==
              0);
        CHECK(many.over_third_blow_up(signature_of({{"-/P/P", points}, {"P/-/P", 11 - points}})) ==
              0);
    }
}

TEST_CASE("the integrals do not depend on the weights of the tori, nor on how far Gamma is tried") {
    Integrals some, others(5, 77), further(6);
    for (const auto& problem : {
             signature_of({{"-/P/P", 4}, {"P/-/P", 4}, {"P/P/-", 3}}),
             signature_of({{"P/P/P", 2}, {"a/Pa/Pa", 1}, {"P/a/a", 1}, {"-/P/P", 1}}),
             signature_of({{"Pabc/Pabc/Pabc", 1}, {"P/-/P", 3}, {"P/P/-", 2}}),
             signature_of({{"Pabcd/Pabcd/Pabcd", 1}, {"-/P/P", 3}, {"P/-/P", 1}}),
         }) {
        const std::int64_t degree = some.over_third_blow_up(problem);
        CHECK(degree > 0);
        CHECK(others.over_third_blow_up(problem) == degree);
        CHECK(further.over_third_blow_up(problem) == degree);
    }
    const auto five =
        signature_of({{"Pabcde/Pabcde/Pabcde", 1}, {"-/P/P", 1}, {"P/a/a", 1}, {"a/P/a", 1}});
    CHECK(some.over_second_blow_up(five) == others.over_second_blow_up(five));
}

TEST_CASE("the integrals are 0 in other degrees, and with a star that is not minimal") {
    Integrals integrals;
    for (const auto& problem : {
             signature_of({{"a/a/a", 1}}),
             signature_of({{"P/P/P", 2}, {"-/P/P", 3}}),
             signature_of({{"Pabcd/Pabcd/Pabcd", 1}, {"-/P/P", 4}}),
             signature_of({{"Pabcd/Pabcd/Pabcd", 1}, {"-/P/P", 1}, {"P/a/a", 2}}),
         })
        CHECK(integrals.over_third_blow_up(problem) == 0);
    CHECK(integrals.over_second_blow_up(
              signature_of({{"Pabcde/Pabcde/Pabcde", 1}, {"P/a/a", 2}})) == 0);
}

TEST_CASE("five points that two views share have twenty relative poses") {
    Integrals integrals;
    const std::int64_t degree =
        integrals.over_third_blow_up(signature_of({{"-/P/P", 5}, {"P/-/P", 5}, {"P/P/-", 1}}));
    CHECK(degree % (20 * 20) == 0);
}

TEST_CASE("Theorem K: where its first part speaks of four pins, the second has the same degree") {
    // The first part is an integral over the second blow-up.
    Integrals integrals;
    for (const auto& problem : {
             signature_of({{"Pabcd/Pabcd/Pabcd", 1}, {"a/a/a", 2}}),
             signature_of({{"Pabcd/Pabcd/Pabcd", 1}, {"Pa/Pa/Pa", 1}}),
             signature_of({{"Pabcd/Pabcd/Pabcd", 1}, {"P/P/P", 1}, {"P/a/a", 1}}),
             signature_of({{"Pabcd/Pabcd/Pabcd", 1}, {"P/a/a", 4}}),
         })
        CHECK(integrals.over_second_blow_up(problem) == integrals.over_third_blow_up(problem));
}

TEST_CASE("Theorem K speaks of one point with four or five pins") {
    const auto applies = [](std::map<std::string_view, unsigned> counts) {
        return theorem_k_applies(signature_of(counts));
    };
    CHECK(applies({{"Pabcd/Pabcd/Pabcd", 1}, {"-/P/P", 2}, {"P/a/a", 2}}));
    CHECK(applies({{"Pabcde/Pabcde/Pabcde", 1}, {"P/P/P", 1}}));
    CHECK_FALSE(applies({{"Pabc/Pabc/Pabc", 1}, {"a/a/a", 2}, {"P/a/a", 1}}));
    CHECK_FALSE(applies({{"Pabcdef/Pabcdef/Pabcdef", 1}, {"P/a/a", 2}}));
    CHECK_FALSE(applies({{"Pabcde/Pabcde/Pabcde", 1}, {"-/P/P", 2}, {"P/a/a", 1}}));
    CHECK_FALSE(applies({{"P/P/P", 3}, {"a/a/a", 1}}));
}
