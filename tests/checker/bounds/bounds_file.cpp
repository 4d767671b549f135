// Files of upper bounds by the letter of FORMAT.md, section 10: templates that hold, and templates
// that are altered in one place, each refused for that.
#include "tests/checker/bounds/templates.h"

#include <ctime>
#include <regex>

using namespace checker;
using namespace templates;

TEST_CASE("the committed templates hold") {
    CHECK(committed().refusals.count == 0);
    CHECK(committed().templates == 89);
    CHECK(committed().bounds.size() == 89); // one for each type
    CHECK(committed().bounds.at(relative_pose) == 20);
}

TEST_CASE("small templates hold") {
    CHECK(outcome(two_points_and_a_line) == "holds");
    CHECK(outcome(on_the_axis) == "holds");
    CHECK(outcome(on_the_axis + two_points_and_a_line) == "holds");
}

TEST_CASE("a file without templates bounds nothing") {
    const FileContent content = replayed("");
    REQUIRE(std::holds_alternative<BoundsFile>(content));
    const BoundsFile& file = std::get<BoundsFile>(content);
    CHECK(file.templates == 0);
    CHECK(file.refusals.count == 0);
    CHECK(file.bounds.empty());
}

TEST_CASE("the modulus is q") {
    const auto conforms = [](const std::string& modulus) {
        const FileContent content =
            replay(Classification{}, "file", "plcert 2 bounds\nmodulus " + modulus + "\n").content;
        return std::holds_alternative<BoundsFile>(content);
    };
    CHECK(conforms("2305843009213693951"));
    CHECK_FALSE(conforms("2305843009213693950"));
    CHECK_FALSE(conforms("2305843009213693951 1"));
}

TEST_CASE("of two templates of a type the one with the smaller basis counts") {
    std::string larger = two_points_and_a_line;
    larger = with(larger, "basis 1 2 5 6", "basis 1 2 3 5 6");
    larger = with(larger, "rows 1 1 2 5", "rows 1 2 5");
    larger = with(larger, "594677692319771619", "892270926731167537");
    CHECK(outcome(larger) == "holds");
    const std::string poses = template_of_the_relative_pose();
    const auto upper = [&](const std::string& templates) {
        const BoundsFile file = std::get<BoundsFile>(replayed(poses + templates));
        CHECK(file.refusals.count == 0);
        return bound_of(table_of(file.bounds), "2*P/P/P + a/a/a + 3*-/P/P");
    };
    CHECK(upper(larger) == 100);
    CHECK(upper(larger + two_points_and_a_line) == 80);
    CHECK(upper(two_points_and_a_line + larger) == 80);
}

TEST_CASE("a minor other than the true one, or of too few or many rows, is refused") {
    const std::string& good = two_points_and_a_line;
    CHECK(outcome(with(good, "771619", "771618")) == "the minor is 594677692319771619 modulo q");
    CHECK(outcome(with(good, "rows 3 1 2 3 5", "rows 3 1 2 3")) ==
          "there are 16 rows for 17 columns");
    CHECK(outcome(with(good, "rows 3 1 2 3 5", "rows 3 1 2 3 5 6")) ==
          "there are more rows than the 17 columns");
    // One solution less than there are.
    CHECK(outcome(with(good, "basis 1 2 5 6", "basis 1 2 5")) ==
          "there are 17 rows for 18 columns");
    CHECK(contains(outcome(with(with(good, "basis 1 2 5 6", "basis 1 2 5"), "rows 2 1 2 3 5",
                                "rows 2 1 2 3 5 6")),
                   "the minor is 0 modulo q"));
    // Rows in another place: the sign of the determinant changes, or it vanishes.
    CHECK(outcome(with(good, "rows 2 1 2 3 5", "rows 2 1 2 3 6")).starts_with("the minor is "));
}

TEST_CASE("a monomial of too large a degree is refused, in the basis and in a row") {
    CHECK(outcome(with(two_points_and_a_line, "basis 1 2 5 6", "basis 1 2 5 8")) ==
          "monomial 8 is of too large a degree for the basis");
    CHECK(outcome(with(two_points_and_a_line, "rows 2 1 2 3 5", "rows 2 1 2 3 4")) ==
          "equation 2 times monomial 4 is of too large a degree");
    CHECK(outcome(with(two_points_and_a_line, "rows 1 1 2 5 8 9 12 15 16 19",
                       "rows 1 1 2 3 8 9 12 15 16 19")) ==
          "equation 1 times monomial 3 is of too large a degree");
    CHECK(outcome(with(two_points_and_a_line, "basis 1 2 5 6", "basis 1 2 5 22")) ==
          "there are only 21 monomials");
    CHECK(outcome(with(two_points_and_a_line, "rows 3 1", "rows 7 1")) ==
          "there are only 6 equations");
    CHECK(outcome(with(two_points_and_a_line, "rows 3 1 2 3 5", "rows 3 1 2 3 22")) ==
          "there are only 21 monomials");
}

TEST_CASE("templates have one spelling") {
    CHECK(contains(outcome(with(on_the_axis, "degree 4 2", "degree 4")), "syntax"));
    CHECK(contains(outcome(with(on_the_axis, "degree 4 2", "degree 7 2")),
                   "syntax: found `7`, expected an integer from 1 to 6"));
    CHECK(contains(outcome(with(on_the_axis, "basis 1 2", "basis 2 1")), "syntax"));
    CHECK(contains(outcome(with(on_the_axis, "rows 1 1 2 4", "rows 1 1 4 2")), "syntax"));
    CHECK(contains(outcome(with(on_the_axis, "rows 2", "rows 1")), "syntax"));
    CHECK(contains(outcome(with(on_the_axis, "minor 1764528126404496281", "minor 0")), "syntax"));
    CHECK(contains(outcome(with(on_the_axis, "transversals point -74 -58 32",
                                "transversals point -74 -58 1000000")),
                   "syntax"));
    CHECK(contains(outcome("template"), "syntax"));
    CHECK(contains(outcome(on_the_axis.substr(0, on_the_axis.find("minor"))), "syntax"));
}

TEST_CASE("a template stops at its first flaw, which the report names") {
    // Two flaws each: a minor that is not the true one beside one that is found before.
    const std::string wrong_minor = with(two_points_and_a_line, "771619", "771618");
    CHECK(outcome(wrong_minor).starts_with("the minor is "));
    CHECK(outcome(with(wrong_minor, "direction 1 0 0", "direction 2 0 0")) ==
          "the first line is not the axis");
    CHECK(outcome(with(wrong_minor, "basis 1 2 5 6", "basis 1 2 5 8")) ==
          "monomial 8 is of too large a degree for the basis");
    CHECK(outcome(with(wrong_minor, "rows 2 1 2 3 5", "rows 2 1 2 3 4")) ==
          "equation 2 times monomial 4 is of too large a degree");
    const std::string both = with(with(wrong_minor, "rows 2 1 2 3 5", "rows 2 1 2 3 4"),
                                  "basis 1 2 5 6", "basis 1 2 5 8");
    CHECK(outcome(both) == "monomial 8 is of too large a degree for the basis");
    CHECK(outcome(with(both, "point 0 0 0", "point 0 0 1")) ==
          "the first star is not at the origin");
}

TEST_CASE("a refused template touches no other of its file") {
    const std::string wrong = with(two_points_and_a_line, "771619", "771618");
    const BoundsFile file = std::get<BoundsFile>(replayed(wrong + on_the_axis + wrong));
    CHECK(file.templates == 1);
    CHECK(file.bounds.size() == 1);
    CHECK(file.refusals.count == 2);
    REQUIRE(file.refusals.first.size() == 2);
    CHECK(file.refusals.first[0].line == 3);
}

TEST_CASE("a flawed template costs little, whatever it says of itself") {
    // Of the largest degree; the flaw shows before any equation is made.
    std::string many;
    for (int copy = 0; copy < 200; ++copy)
        many += R"(template general degree 6
incidence point 1 2 3 line 4 5 7
incidence point 2 7 1 line 8 2 8
incidence point 1 8 2 line 8 4 5
incidence point 9 0 4 line 5 2 3
transversals point 1 2 5 direction 1 2 4 image 3 5 8
transversals point 3 1 4 direction 2 2 7 image 1 5 9
basis 455
rows 1 1
minor 1
)";
    const std::clock_t start = std::clock(); // of the processor: other work does not count
    const BoundsFile file = std::get<BoundsFile>(replayed(many));
    CHECK(std::clock() - start < 20 * CLOCKS_PER_SEC);
    CHECK(file.refusals.count == 200);
    CHECK(file.refusals.first.size() == Refusals::most_reported);
    CHECK(contains(file.refusals.first[0].reason, "is of too large a degree for the basis"));
}
