// The equations of templates (FORMAT.md, section 10), and what the frames ask of the constraints.
#include "checker/bounds/template_equations.h"
#include "tests/checker/bounds/templates.h"

using namespace checker;
using namespace templates;

TEST_CASE("what a frame requires is refused where it is missing") {
    const std::string axis = "the first line is not the axis", first = "star 1 is not on the axis",
                      second = "star 2 is not on the axis";
    CHECK(outcome(with(two_points_and_a_line, "direction 1 0 0", "direction 2 0 0")) == axis);
    CHECK(outcome(with(two_points_and_a_line, "direction 1 0 0", "direction 1 1 0")) == axis);
    CHECK(outcome(with(two_points_and_a_line, "image 0 0 1", "image 0 1 1")) == axis);
    CHECK(outcome(with(two_points_and_a_line, "point 0 0 0", "point 0 0 1")) ==
          "the first star is not at the origin");
    CHECK(outcome(with(on_the_axis, "point 0 0 0", "point 1 0 0")) ==
          "the first star is not at the origin");
    CHECK(outcome(with(on_the_axis, "point 33 0 0", "point 33 1 0")) == second);
    CHECK(outcome(with(on_the_axis, "point 33 0 0", "point 33 0 1")) == second);
    CHECK(outcome(with(on_the_axis, "image -88 -4 0", "image -88 -4 1")) == second);
    CHECK(outcome(with(on_the_axis, "points", "line")) == "the frame needs a line");
    CHECK(outcome(with(on_the_axis, "points", "lines")) == "the frame needs a line");
    const std::string incidence = "incidence point 1 2 3 line 4 5 6\n";
    CHECK(
        outcome(with(with(on_the_axis,
                          "star point 33 0 0 image -88 -4 0 pin 78 -86 -9 toward 15 16 -47\n", ""),
                     "transversals", incidence + incidence + incidence + "transversals")) ==
        "the frame `points` needs two stars");
    CHECK(contains(outcome(with(on_the_axis, "points", "plane")),
                   "syntax: found `plane`, expected `general`, `line`, `points` or `lines`"));
}

TEST_CASE("the frame of two lines wants two lines and two rays, in their places") {
    const std::string good = R"(template lines degree 3 4
line point 0 0 0 direction 1 0 0 image 0 0 1
line point 0 0 -92 direction 78 -86 0 image 15 16 -47
transversals point -74 -58 32 direction -36 70 38 image -29 11 -94
transversals point -1 5 66 direction -1 62 65 image 78 -93 -3
basis 1 2 3 6 7 8 10 11 19 37 38 39 42 43 46 47
rows 1 1 2 3 4 6 7 8 10 11 12 13 15 16 17 19 20 21 22 24 25 26 37 38 39 40 42 43 44 46 47 48 49 51 52 53
rows 2 1 2 3 6 7 10 11 12 15 16 37 38
minor 479527735541954229
)";
    CHECK(outcome(good) == "holds");
    const std::string perpendicular = "the third axis is not the common perpendicular";
    CHECK(outcome(with(good, "point 0 0 0", "point 0 1 0")) == perpendicular);
    CHECK(outcome(with(good, "point 0 0 0", "point 0 0 1")) == perpendicular);
    CHECK(outcome(with(good, "point 0 0 -92", "point 1 0 -92")) == perpendicular);
    CHECK(outcome(with(good, "direction 78 -86 0", "direction 78 -86 1")) == perpendicular);
    CHECK(outcome(with(good, "direction 1 0 0", "direction 1 1 0")) ==
          "the first line is not the axis");
    CHECK(outcome(with(good, "transversals point -74 -58 32 direction -36 70 38 image -29 11 -94",
                       "incidence point 1 2 3 line 4 5 6")) ==
          "the frame `lines` needs two lines and two rays, and nothing else");
    // Without the polynomial of lower degree there are zeros at infinity, and no template.
    CHECK(contains(outcome(with(good, "rows 2", "rows 3")), "is of too large a degree"));
}

TEST_CASE("constraints have weight six, except those of the relative pose") {
    CHECK(outcome(with(on_the_axis, " pin 78 -86 -9 toward 15 16 -47", "")) ==
          "the constraints have weight 5, not 6");
    CHECK(outcome(with(on_the_axis, "image -29 11 -94",
                       "image -29 11 -94 direction 1 2 3 image 4 5 6")) ==
          "the constraints have weight 7, not 6");
    CHECK(outcome(with(on_the_axis, "toward 15 16 -47",
                       "toward 15 16 -47 pin 1 2 3 toward 3 4 5 pin 1 2 4 toward 3 5 5")) ==
          "the constraints have weight 8, not 6");
    std::string basis, some; // the monomials of degree 2 at most; one for each column left, less
    const RotationRing ring{true};
    const auto columns = ring.monomials({3, 0});
    for (std::size_t i = 0, left = columns.size(); i < columns.size(); ++i) {
        if (ring.degree(columns[i])[0] > 2) continue;
        basis += say(' ', i + 1);
        if (left-- > 70) some += say(' ', i + 1);
    }
    CHECK(outcome(
              "template general degree 3\nstar point 0 0 0 image 1 2 3\nstar point 1 5 2 image 3 1 "
              "4 pin 1 5 9 toward 2 6 5\nbasis" +
              basis + "\nrows 1" + basis + "\nrows 2" + some + "\nminor 1\n") ==
          "the constraints have weight 5, not 6");
    const std::string general = R"(template general degree 1
incidence point 1 2 3 line 4 5 7
basis 1
rows 1 1
minor 1
)";
    CHECK(outcome(general) == "the constraints have weight 1, not 6");
}

TEST_CASE("the determinant of two incidences and two rays has degree 3") {
    // The first of the equations, of incidences alone, has degree 1; with one ray they have
    // degree 2.
    std::string text = R"(template general degree 2
incidence point 1 2 3 line 4 5 7
incidence point 2 7 1 line 8 2 8
incidence point 1 8 2 line 8 4 5
incidence point 9 0 4 line 5 2 3
transversals point 1 2 5 direction 1 2 4 image 3 5 8
transversals point 3 1 4 direction 2 2 7 image 1 5 9
basis 1 2 4 6 10 12 16 23 25 29
rows 1 1 2 4 6 10 12 16 23 25 29
)";
    for (int equation = 2; equation <= 15; ++equation)
        text += say("rows ", equation, " 1\n");
    CHECK(outcome(text + "minor 1\n") == "equation 10 times monomial 1 is of too large a degree");
}

TEST_CASE("only the first line of the frame `line` has a free term of a smaller degree") {
    // The determinant of a star, at the origin, and two lines: its free terms are those of lines.
    const std::string text = R"(template line degree 1 2
star point 0 0 0 image 66 4 -66
line point 78 -86 -9 direction 1 0 0 image 0 0 1
line point 1 2 3 direction 4 5 7 image 8 2 5
basis 1
rows 2 2
minor 1
)";
    CHECK(contains(outcome(text), "there are 1 rows for "));
    CHECK(outcome(with(text, "rows 2 2", "rows 2 6")) ==
          "equation 2 times monomial 6 is of too large a degree");
}

TEST_CASE("the kinds of constraints come in order, and there are at most six lines of them") {
    const std::string star = "star point 33 0 0 image -88 -4 0 pin 78 -86 -9 toward 15 16 -47\n";
    const std::string line = "line point 1 2 3 direction 4 5 6 image 7 8 9\n";
    CHECK(outcome(with(on_the_axis, star, line + star)) ==
          "syntax: found `star`, expected `basis`");
    const auto times = [](int count, const std::string& part) {
        std::string parts;
        while (count-- > 0)
            parts += part;
        return parts;
    };
    const auto with_incidences = [&](int count) {
        return outcome(with(on_the_axis, star, times(count, "incidence point 1 2 3 line 4 5 6\n")));
    };
    CHECK(with_incidences(4) == "the constraints have weight 7, not 6"); // six lines
    CHECK(with_incidences(5) ==
          "syntax: found `transversals`, expected at most 6 lines of constraints");
    const auto with_pins = [&](int count) {
        return outcome(
            with(on_the_axis, " pin 78", times(count - 1, " pin 1 2 3 toward 4 5 6") + " pin 78"));
    };
    CHECK(with_pins(6) == "the constraints have weight 11, not 6");
    CHECK(with_pins(7) == "syntax: found `pin`, expected at most 6 pins");
    const auto with_rays = [&](int count) {
        return outcome(with(on_the_axis, " direction -36",
                            times(count - 1, " direction 1 2 3 image 4 5 6") + " direction -36"));
    };
    CHECK(with_rays(6) == "the constraints have weight 11, not 6");
    CHECK(with_rays(7) == "syntax: found `direction`, expected at most 6 rays");
}

TEST_CASE("a frame without its line or its stars is refused, not read beyond its end") {
    const std::string none = R"(template lines degree 1 1
incidence point 1 2 3 line 4 5 6
incidence point 1 2 3 line 4 5 6
incidence point 1 2 3 line 4 5 6
incidence point 1 2 3 line 4 5 6
incidence point 1 2 3 line 4 5 6
incidence point 1 2 3 line 4 5 6
basis 1
rows 1 1
minor 1
)";
    CHECK(outcome(none) == "the frame needs a line");
    CHECK(outcome(with(none, "lines", "line")) == "the frame needs a line");
    CHECK(outcome(with(none, "lines", "points")) == "the frame `points` needs two stars");
    CHECK(outcome(with(none, "lines degree 1 1", "general degree 1")) != "holds");
    CHECK(outcome("template general degree 1\nbasis 1\nrows 1 1\nminor 1\n") ==
          "the constraints have weight 0, not 6");
}
