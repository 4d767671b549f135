// Features, notation, signatures and label classes: known counts and laws.
#include "prover/minimal/obstruction.h"
#include "prover/problem/notation.h"
#include "prover/problem/signature.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <map>
#include <numeric>
#include <set>

using namespace plprove;

TEST_CASE("the 27 features have the dimensions of Table 1 of the paper") {
    // Rows "3D" and "2D" of the table, in the authors' order.
    const int space[] = {17, 15, 13, 11, 9, 7, 5, 3, 5, 5, 5, 4, 5, 5,
                         5,  5,  5,  5,  3, 3, 3, 5, 5, 5, 7, 7, 7};
    const int images[] = {27, 24, 21, 18, 15, 12, 9, 6, 8, 8, 8, 6, 7, 7,
                          7,  7,  7,  7,  4,  4,  4, 6, 6, 6, 8, 8, 8};
    REQUIRE(standard_features().size() == feature_count);
    for (std::size_t i = 0; i < feature_count; ++i) {
        CAPTURE(i);
        const Feature& feature = standard_features()[i];
        CHECK(dimension_in_space(feature) == space[i]);
        CHECK(weight(feature) == images[i] - space[i]);
    }
}

TEST_CASE("notation survives a round trip, and names of pins do not matter") {
    for (const Feature& feature : standard_features())
        CHECK(parse_feature(notation(feature)) == feature);
    CHECK(canonical(parse_feature("Pab/b/a")) == canonical(parse_feature("Pab/a/b")));
    CHECK(canonical(parse_feature("Pab/b/a")) != canonical(parse_feature("b/Pab/a")));
    CHECK(notation(parse_features(" 2 * Pa/Pa/Pa+P/P/P ")) == "2*Pa/Pa/Pa + P/P/P");
    CHECK(notation(parse_features("P/P + P/P")) == "2*P/P");
}

TEST_CASE("malformed notation is refused with the column and what was expected") {
    const std::map<std::string, std::string> refused{
        {"", "column 1: found the end"},
        {"P/P/P +", "column 8: found the end"},
        {"P/P/P P/P/P", "column 7: found 'P', expected '+'"},
        {"P", "column 2: found the end, expected '/'"},
        {"ab/P/P", "Definition 1"},
        {"Pba/P/P", "alphabetical order"},
        {"Pb/Pb/P", "without gaps"},
        {"P/P/P/P", "column 6: found '/', expected at most 3 views"},
        {"2P/P/P", "column 2: found 'P', expected '*'"},
        {"9999999999999999999*P/P/P", "a multiplicity from 1 to 1000"},
        {"0*P/P/P", "a multiplicity from 1 to 1000"},
        {"P/a/-(bb)", "the letters of lines in alphabetical order"},
        {"P/a/-(a)", "leave it out there"},
        {"P/P/P(P)", "leave out '(P)'"},
        {"P/P/P()", "what no view sees"},
        {"P/P/P + P/P", "the same number of views"},
        {"Px/P/", "column 6: found the end"},
        {std::string("P/P\0/P", 6), "the byte 0"},
    };
    for (const auto& [text, reason] : refused) {
        CAPTURE(text);
        try {
            parse_features(text);
            FAIL("accepted");
        } catch (const NotationError& error) {
            CAPTURE(error.what());
            CHECK(std::string(error.what()).find(reason) != std::string::npos);
        }
    }
}

TEST_CASE(
    "relabeling views acts on signatures as the rotation and reflection of the authors' data") {
    Signature s{};
    std::iota(s.begin(), s.end(), std::uint8_t{0});
    const auto orbit = relabelings(s);
    CHECK(std::set<Signature>(orbit.begin(), orbit.end()).size() == 6);
    const Signature rotation{0,  1,  2,  3,  4,  5,  6,  7,  10, 8,  9,  11, 16, 17,
                             13, 12, 15, 14, 20, 18, 19, 23, 21, 22, 26, 24, 25};
    const Signature reflection{0,  1,  2,  3,  4,  5,  6,  7,  8,  10, 9,  11, 13, 12,
                               16, 17, 14, 15, 18, 20, 19, 21, 23, 22, 24, 26, 25};
    CHECK(std::ranges::count(orbit, rotation) == 1);
    CHECK(std::ranges::count(orbit, reflection) == 1);
}

TEST_CASE("there are 143,494 label classes, and orbits of 845,161 balanced signatures") {
    const std::vector<Signature>& classes = label_classes();
    REQUIRE(classes.size() == 143494);
    CHECK(std::ranges::is_sorted(classes, std::greater{}));
    std::size_t signatures = 0;
    for (const Signature& signature : classes) {
        auto orbit = relabelings(signature);
        std::ranges::sort(orbit);
        const auto size = std::unique(orbit.begin(), orbit.end()) - orbit.begin();
        CHECK(6 % size == 0);
        signatures += static_cast<std::size_t>(size);
    }
    CHECK(signatures == 845161);

    SUBCASE("the numbers are the authors'") {
        CHECK(notation(problem_of(classes[2394])) == "2*Pa/Pa/Pa + P/P/P");
        CHECK(notation(problem_of(classes[6722])) == "3*P/P/P + a/a/a");
    }
}

TEST_CASE("the number of balanced signatures is a coefficient of a generating function") {
    // The product of 1/(1 - x^w) over the weights w, up to x^11: a second way to count solutions.
    std::array<std::size_t, 12> coefficients{1};
    for (const Feature& feature : standard_features())
        for (std::size_t n = static_cast<std::size_t>(weight(feature)); n < 12; ++n)
            coefficients[n] += coefficients[n - static_cast<std::size_t>(weight(feature))];
    CHECK(coefficients[11] == 845161);
}

TEST_CASE("obstructions do not depend on the labels of the views") {
    for (const Signature& signature : label_classes()) {
        const Obstruction first = obstruction(problem_of(signature));
        if (first.deficiency() == 0) continue;
        for (const Signature& other : relabelings(signature)) {
            const Obstruction second = obstruction(problem_of(other));
            CHECK(std::ranges::is_permutation(first.excess, second.excess));
            CHECK(first.star == second.star);
        }
    }
}
