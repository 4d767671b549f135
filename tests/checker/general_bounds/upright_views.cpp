// Theorem D (proofs/upright_views.md): degrees on file, which Groebner bases counted.
#include "checker/general_bounds/upright_views.h"

#include "checker/problem/notation.h"
#include "tests/checker/general_bounds/degrees_on_file.h"

#include <doctest/doctest.h>
#include <string>

using namespace checker;

namespace {

std::optional<std::size_t> degree(const std::string& text) {
    return degree_in_upright_views(parse_problem(text));
}

} // namespace

TEST_CASE("degrees of three views with known verticals are those that Groebner bases count") {
    constexpr int every = 60; // each takes some seconds
    int minimal = 0;
    for (const OnFileInPart& row : degrees_in_part_on_file("upright")) {
        CAPTURE(row.problem);
        CHECK((row.degree == "0") != (row.source == "by Theorem D"));
        if (row.degree == "0" || minimal++ % every != 0) continue; // not minimal, or not now
        const auto found = degree(row.problem);
        REQUIRE(found.has_value());
        CHECK(std::to_string(*found) == row.degree);
    }
    CHECK(minimal == 613);
}

TEST_CASE("the order of the views, and which view sees a line, do not matter") {
    for (const char* text :
         {"upright: 3*-/P/P + 3*P/-/P + P/P/-", "upright: 3*P/P/- + 3*-/P/P + P/-/P",
          "upright: 3*P/P/- + 3*P/-/P + -/P/P",
          // The third view sees a line through a point, which says nothing of the cameras.
          "upright: 2*-/P/P + -/Pa/Pa + 3*P/-/P + P/P/-"}) {
        CAPTURE(text);
        CHECK(degree(text) == 16);
    }
    for (const char* text :
         {"upright: a/P/Pa + -/P/P + 3*P/-/P + P/P/-", "upright: a/Pa/P + -/P/P + 3*P/-/P + P/P/-",
          "upright: P/a/Pa + -/P/P + 3*P/P/- + P/-/P"}) {
        CAPTURE(text);
        CHECK(degree(text) == 16);
    }
}

TEST_CASE("a second line, in a view that sees one of both, does not matter") {
    CHECK(degree("upright: a/a/a + 3*-/P/P + 2*P/a/a") == 8);
    CHECK(degree("upright: a/a/a + 3*-/P/P + P/a/a + Pab/b/a") == 8);
}

TEST_CASE("two lines that all views see leave six solutions") {
    for (const char* text :
         {"upright: P/P/P + 2*a/a/a", "upright: P/P/P + Pa/Pa/Pa",
          "upright: Pab/Pab/Pab + P/a/a + a/P/a", "upright: 2*a/a/a + a/P/Pa + P/-/P",
          // One view may choose a point on a line that all see.
          "upright: Pa/a/a + a/a/a + a/P/Pa + P/-/P"}) {
        CAPTURE(text);
        CHECK(degree(text) == 6);
    }
}

TEST_CASE("the theorem says nothing of other problems") {
    for (const char* text : {"upright-focal: 3*P/P/P", "3*P/P/P + 3*-/P/P", // other cameras
                             "upright: 3*P/P", "upright: 2*P/P/P/P", // other numbers of views
                             "upright: 2*PL/PL/PL + a/a/a",          // a line joins two points
                             "upright: 2*P/P/P", "upright: 3*P/P/P", // not balanced
                             "upright: 3*a/a/a + P/-/P"}) {          // three lines in all views
        CAPTURE(text);
        CHECK(!degree(text).has_value());
    }
}
