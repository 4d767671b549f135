// Records of problems in general: what holds, and what is refused for which reason if anything is
// altered in it.
#include "tests/checker/minimal/image_rank.h"
#include "tests/checker/minimal/outcome.h"

namespace {

const std::string five_points = "problem 5*P/P\n"
                                "minimal 2057337849540660835\n"
                                "camera 9 -9 4 -7 3 0 -7\n"
                                "scene -6 2 -6 8 -1 -1 -5 7 -6 -4 6 4 -1 -7 4\n";
const std::string seven_points = "problem projective: 7*P/P\n"
                                 "minimal 2086694600815326076\n"
                                 "camera 0 0 0 1 3 0 -7 -6 2 -6 8 -1\n"
                                 "scene -1 -5 7 -6 -4 6 4 -1 -7 4 9 -9 -9 -1 -1 9 -5 -7 1 9 -7\n";
const std::string four_on_a_line = "problem 2*PL/PL + P/P + 2*PL/PL\n"
                                   "collinear 1 2 4 5 views 1 2\n";
const std::string star = "problem Pabcdef/Pabcdef/Pabcdef + a/a/a\n"
                         "excess 1\n"
                         "part views 1 2 3 points 1 lines 1 2 3 4 5 6 7\n"
                         "motion star 1 views 1 2 3 points lines\n";
const std::string plane = "problem projective: PLMN/PLMN + PLO/PLO + PMO/PMO + PL/PL + PM/PM + "
                          "PNO/PNO + PN/PN\n"
                          "excess 2\n"
                          "part views 1 2 points 1 2 3 4 5 6 7 lines 1 2 3 4\n"
                          "motion plane views 1 2 points 1 2 3 4 5 6 7 lines\n";

/// What the checker makes of a record with another part in the place of the first such one.
std::string altered(const std::string& record, const char* old, const char* replacement) {
    return outcome_of_record(with(record, old, replacement));
}

} // namespace

TEST_CASE("a record of each kind holds") {
    for (const std::string& record : {five_points, seven_points, four_on_a_line, star, plane})
        CHECK(outcome_of_record(record) == "holds");
    CHECK(outcome_of_record("problem 4*P/P\nunbalanced\n") == "holds");
    CHECK(outcome_of_record(five_points + star + plane + star) == "holds");
}

TEST_CASE("a minor that is not that of J is refused, and so is any other place") {
    CHECK(contains(altered(five_points, "minimal 2", "minimal 1"), "3: 5*P/P: the minor is 2057"));
    CHECK(contains(altered(five_points, "camera 9", "camera 8"), "3: 5*P/P: the minor is "));
    CHECK(contains(altered(five_points, "scene -6", "scene -5"), "3: 5*P/P: the minor is "));
    CHECK(contains(altered(five_points, "camera 9 -9 4 -7", "camera 0 0 0 0"),
                   "a quaternion is zero"));
    CHECK(contains(altered(five_points, "3 0 -7", "0 0 0"),
                   "the translation of camera 2 begins with 0"));
    CHECK(contains(altered(seven_points, "camera 0 0 0 1", "camera 0 0 1 1"),
                   "camera 2 does not begin with 0 0 0 1"));
    CHECK(contains(altered(seven_points, "camera 0 0 0 1", "camera 0 0 0 2"),
                   "camera 2 does not begin with 0 0 0 1"));
}

TEST_CASE("a minor of a problem that is not balanced is refused") {
    const std::string four = with(with(five_points, "5*", "4*"), " -7 4\n", "\n");
    CHECK(contains(outcome_of_record(with(four, " -1\n", "\n")), "it is not balanced"));
}

TEST_CASE("a record has the cameras and the numbers of its problem, no more and no less") {
    for (const auto& [old, replacement] : {std::pair{"3 0 -7", "3 0"},
                                           {"3 0 -7", "3 0 -7 1"},
                                           {"4 -1 -7 4", "4 -1 -7"},
                                           {"-7 4\n", "-7 4 1\n"},
                                           {"camera 9", "camera 1000000"},
                                           {"camera 9", "camera 09"},
                                           {"5*P/P\n", "5*P/P/P\n"},
                                           {"5*P/P\n", "projective: 5*P/P\n"},
                                           {"minimal 2057", "minimal 9057"},
                                           {"minimal 2057337849540660835", "minimal 0"},
                                           {"camera 9 -9 4 -7 3 0 -7\n", ""}}) {
        CAPTURE(replacement);
        CHECK(altered(five_points, old, replacement).starts_with("syntax, "));
    }
}

TEST_CASE("the notation decides what a record means") {
    CHECK(contains(altered(five_points, "5*P/P\nminimal", "4*P/P + P/P\nminimal"), "syntax"));
    CHECK(contains(altered(four_on_a_line, "2*PL/PL + P/P + 2*PL/PL", "5*PL/PL"), "holds"));
    CHECK(contains(altered(four_on_a_line, "2*PL/PL + P/P + 2*PL/PL", "3*PL/PL + P/P + PL/PL"),
                   "the four points are not on one line"));
}

TEST_CASE("unbalanced is a claim like any other") {
    CHECK(contains(outcome_of_record("problem 5*P/P\nunbalanced\n"), "3: 5*P/P: it is balanced"));
    CHECK(contains(outcome_of_record("problem projective: 7*P/P\nunbalanced\n"), "it is balanced"));
    CHECK(outcome_of_record("problem projective: 5*P/P\nunbalanced\n") == "holds");
}

TEST_CASE("four points must be on one line, and both views must see them") {
    CHECK(contains(altered(four_on_a_line, "1 2 4 5", "1 2 3 4"), "not on one line"));
    CHECK(contains(altered(four_on_a_line, "2*PL/PL + P/P + 2*PL/PL", "4*PL/PL/PL + PL/L/PL"),
                   "one of the views does not see point 5"));
    for (const auto& [old, replacement] : {std::pair{"1 2 4 5", "1 2 4"},
                                           {"1 2 4 5", "1 2 3 4 5"},
                                           {"1 2 4 5", "2 1 4 5"},
                                           {"1 2 4 5", "1 2 4 6"},
                                           {"1 2 4 5", "0 2 4 5"},
                                           {"views 1 2", "views 1"},
                                           {"views 1 2", "views 1 3"},
                                           {"views 1 2", "views 2 1"},
                                           {"views 1 2", "views 1 1"}}) {
        CAPTURE(replacement);
        CHECK(altered(four_on_a_line, old, replacement).starts_with("syntax, "));
    }
    CHECK(altered(four_on_a_line, "2*PL/PL + P/P + 2*PL/PL\ncollinear 1 2 4 5 views 1 2",
                  "5*PL/PL/PL\ncollinear 1 2 4 5 views 1 2 3")
              .starts_with("syntax, "));
}

TEST_CASE("the excess must be that of the part and of its motion") {
    for (const std::string& record : {star, plane})
        for (const char* wrong : {"excess 3", "excess 999999"}) {
            const std::string stated = record == star ? "excess 1" : "excess 2";
            CHECK(contains(altered(record, stated.c_str(), wrong), ": the excess is "));
        }
    CHECK(contains(altered(star, "motion star 1 views 1 2 3", "motion star 1 views 2"),
                   ": the excess is 0"));
    CHECK(contains(altered(star, "motion star 1 views 1 2 3 points lines", "motion none"),
                   ": the excess is "));
    CHECK(contains(altered(star, "lines 1 2 3 4 5 6 7", "lines 1 2 3 4 5 6"), ": the excess is 0"));
    CHECK(altered(star, "excess 1", "excess 0").starts_with("syntax, "));
}

TEST_CASE("a part arises by leaving out lines with two points, and points on two lines") {
    // Line 1 of `plane` has four points.
    CHECK(contains(altered(plane, "lines 1 2 3 4\n", "lines 2 3 4\n"), "does not arise"));
    // Without point 7, line 3 has two points.
    const std::string part = "part views 1 2 points 1 2 3 4 5 6 lines 1 2 4\n";
    const std::string smaller =
        with(plane, "part views 1 2 points 1 2 3 4 5 6 7 lines 1 2 3 4\n", part.c_str());
    CHECK(!contains(outcome_of_record(with(smaller, "5 6 7", "5 6")), "does not arise"));
}

TEST_CASE("a motion keeps the images of its part") {
    CHECK(contains(altered(star, "motion star 1 views 1 2 3 points lines",
                           "motion plane views 1 2 3 points 1 lines"),
                   "a motion of calibrated cameras has no generators"));
    CHECK(contains(altered(star, "motion star 1", "motion plane"),
                   "does not keep the image of point 1"));
    CHECK(contains(altered(star, "3 points lines", "3 points 1 lines"),
                   "a motion of calibrated cameras has no generators"));
    CHECK(contains(altered(star, "points 1 lines 1 2 3 4 5 6 7", "points lines 7"),
                   "point 1 is not in the part"));
    CHECK(
        contains(altered(star, "part views 1 2 3", "part views 1 2"), "a view is not in the part"));
    CHECK(contains(altered(plane, "motion plane views 1 2 points 1 2 3 4 5 6 7",
                           "motion plane views 1 2 points 1 2"),
                   "the motion does not keep the image of point 3"));
    CHECK(contains(outcome_of_record("problem projective: 7*P/P\nexcess 1\n"
                                     "part views 1 2 points 1 2 3 4 5 6 7 lines\n"
                                     "motion plane views 1 2 points 1 2 3 4 lines\n"),
                   "the rank of the generators is 4, more than 3"));
}

TEST_CASE("a part-record is spelled as section 13 says") {
    for (const auto& [old, replacement] : {std::pair{"part views 1 2 3", "part views 1"},
                                           {"part views 1 2 3", "part views 1 3 2"},
                                           {"part views 1 2 3", "part views 1 2 3 4"},
                                           {"points 1 lines", "points 2 lines"},
                                           {"lines 1 2 3 4 5 6 7", "lines 1 2 3 4 5 6 8"},
                                           {"lines 1 2", "lines 2 1"},
                                           {"star 1", "star"},
                                           {"star 1", "star 2"},
                                           {"star 1", "motion 1"},
                                           {"star 1", "plane 1"},
                                           {"views 1 2 3 points lines", "views points lines"},
                                           {"views 1 2 3 points lines", "views 1 2 3 points"},
                                           {"motion", "moves"},
                                           {"excess 1\n", "excess 1 "},
                                           {"3 points lines\n", "3 points lines\nmotion none\n"}}) {
        CAPTURE(replacement);
        CHECK(altered(star, old, replacement).starts_with("syntax, "));
    }
    CHECK(contains(altered(star, "star 1", "comet 1"), "found `comet`, expected `none`, `loose`"));
    CHECK(contains(outcome_of_record("problem 4*P/P\nbalanced\n"),
                   "found `balanced`, expected `minimal`, `unbalanced`"));
}

TEST_CASE("a file has a modulus; without a record it conforms, and has no verdict") {
    CHECK(outcome_of_problems("").starts_with("syntax, "));
    const auto empty =
        checker::replay(all_classes(), "file", "plcert 2 problems\nmodulus 2305843009213693951\n");
    const auto& content = std::get<checker::ProblemsFile>(empty.content);
    CHECK(content.verdicts.empty());
    CHECK(content.refusals.count == 0);
    CHECK(outcome_of_problems(five_points).starts_with("syntax, "));
    CHECK(
        outcome_of_problems("modulus 2305843009213693952\n" + five_points).starts_with("syntax, "));
    CHECK(outcome_of_problems("family pl1p\nmodulus 2305843009213693951\n" + five_points)
              .starts_with("syntax, "));
}

TEST_CASE("a refused record leaves the others") {
    const std::string bytes = "plcert 2 problems\nmodulus 2305843009213693951\n" + star +
                              with(five_points, "minimal 2", "minimal 1") + plane;
    const checker::ReplayedFile file = checker::replay(all_classes(), "file", bytes);
    const auto& content = std::get<checker::ProblemsFile>(file.content);
    CHECK(content.refusals.count == 1);
    REQUIRE(content.verdicts.size() == 2);
    CHECK(!content.verdicts[0].minimal);
    CHECK(content.verdicts[1].notation.starts_with("projective: PLMN/PLMN + PLO/PLO"));
}

TEST_CASE("cameras known in part have shared numbers, once for all") {
    const std::string four_points = "problem upright-shared-focal: 4*P/P\n"
                                    "minimal 1817093796227484055\n"
                                    "shared 2\n"
                                    "camera -6 4 3 -9 7\n"
                                    "scene -6 4 -7 0 -7 5 1 -5 7 4 -8 9\n";
    CHECK(outcome_of_record(four_points) == "holds");
    CHECK(contains(altered(four_points, "shared 2", "shared 3"), "the minor is "));
    CHECK(altered(four_points, "shared 2\n", "").starts_with("syntax"));
    CHECK(altered(four_points, "shared 2", "shared 2 3").starts_with("syntax"));
    CHECK(altered(four_points, "-9 7\n", "-9 7 1\n").starts_with("syntax"));
    CHECK(altered(five_points, "camera", "shared 2\ncamera").starts_with("syntax"));
    CHECK(contains(altered(four_points, "-6 4 3", "0 0 3"), "a rotation is zero"));
    CHECK(contains(altered(four_points, "-6 4 3", "-6 4 0"),
                   "the translation of camera 2 begins with 0"));
    // Three points are enough where the focal length is known, and four are too many.
    CHECK(outcome_of_record("problem upright: 4*P/P\nunbalanced\n") == "holds");
    CHECK(outcome_of_record("problem sideways: 4*P/P\nunbalanced\n").starts_with("syntax"));
}

TEST_CASE("cameras known in part satisfy the conditions of projective ones") {
    const std::string six_in_a_plane =
        "problem shared-focal: PLM/PLM + PLN/PLN + PMN/PMN + PL/PL + PM/PM + PN/PN\n"
        "excess 1\n"
        "part views 1 2 points 1 2 3 4 5 6 lines 1 2 3\n"
        "motion projective plane views 1 2 points 1 2 3 4 5 6 lines\n";
    CHECK(outcome_of_record(six_in_a_plane) == "holds");
    CHECK(contains(altered(six_in_a_plane, "excess 1", "excess 2"), "the excess is 1"));
    CHECK(contains(altered(six_in_a_plane, "projective plane", "plane"),
                   "a motion of shared-focal cameras has no generators"));
    CHECK(contains(altered(plane, "motion plane", "motion projective plane"),
                   "its cameras are projective"));
    CHECK(altered(six_in_a_plane, "projective plane", "projective").starts_with("syntax"));
}

TEST_CASE("directions of lines say too much of few rotations") {
    const std::string four_lines = "problem upright-shared-focal: 4*a/a/a\n"
                                   "excess 1\n"
                                   "part views 1 2 3 points lines 1 2 3 4\n"
                                   "motion directions\n";
    CHECK(outcome_of_record(four_lines) == "holds");
    CHECK(contains(altered(four_lines, "excess 1", "excess 2"), "the excess is 1"));
    CHECK(contains(altered(four_lines, "lines 1 2 3 4", "lines 1 2 3"), "the excess is 0"));
    CHECK(
        contains(altered(four_lines, "upright-shared-focal", "upright-focal"), "the excess is -1"));
    CHECK(contains(altered(four_lines, "directions", "projective directions"),
                   "projective cameras have no `directions`"));
    CHECK(altered(four_lines, "directions", "directions views 1").starts_with("syntax"));
}

TEST_CASE("joins of points have directions, too, if they close no circle") {
    const std::string two_points =
        "problem upright-focal: -/-/a/a/a/a + Pab/Pab/Pab/Pab/Pab/- + Pab/Pb/-/-/Pab/Pab\n"
        "excess 1\n"
        "part views 1 2 3 4 5 6 points 1 2 lines 1 2 3 4 5\n"
        "motion directions joins 1 2\n";
    CHECK(outcome_of_record(two_points) == "holds");
    CHECK(contains(altered(two_points, " joins 1 2", ""), "the excess is 0"));
    CHECK(contains(altered(two_points, "joins 1 2", "joins 1 2 2 1"),
                   "lines and joins close a circle"));
    CHECK(
        contains(altered(two_points, "joins 1 2", "joins 1 1"), "lines and joins close a circle"));
    CHECK(altered(two_points, "joins 1 2", "joins 1").starts_with("syntax"));
    CHECK(altered(two_points, "joins 1 2", "joins 1 3").starts_with("syntax"));
}

TEST_CASE("a line joins its points, and a core counts whole") {
    const std::string core =
        "problem upright-shared-focal: L/L/PL/L/PL/PL/PL + L/PL/PL/PL/L/PL/PL + "
        "PL/PL/PL/PL/L/PL/PL + a/-/a/-/a/-/-\n"
        "excess 1\n"
        "part views 1 2 3 4 5 6 7 points 1 2 3 lines 1 2\n"
        "motion directions\n"
        "core views 3 6 7 points 1 2 3 lines 1\n";
    CHECK(outcome_of_record(core) == "holds");
    CHECK(contains(altered(core, "excess 1", "excess 2"), "the excess is 1"));
    CHECK(
        contains(altered(core, "core views 3 6 7 points 1 2 3 lines 1\n", ""), "the excess is -1"));
    CHECK(contains(altered(core, "core views 3 6 7", "core views 3 6"), "the excess is "));
    CHECK(contains(altered(core, "points 1 2 3 lines 1\n", "points 1 2 lines 1\n"),
                   "line 1 of the part is in the core, point 3 on it is not"));
    CHECK(contains(altered(core, "directions", "directions joins 1 2"),
                   "lines and joins close a circle"));
    CHECK(contains(altered(core, "views 1 2 3 4 5 6 7", "views 1 2 3 4 5 6"),
                   "a view is not in the part"));
    CHECK(altered(core, "core views 3 6 7", "core views 3").starts_with("syntax"));
    CHECK(altered(core, "motion directions", "motion none").starts_with("syntax"));
    const std::string without_centre = "problem upright-focal: P/P/P + Pabc/Pabc/Pabc\n"
                                       "excess 1\n"
                                       "part views 1 2 3 points 1 2 lines 1 2 3\n"
                                       "motion directions\n"
                                       "core views 1 2 points 1 lines 1 2 3\n";
    CHECK(contains(outcome_of_record(without_centre), "the core does not arise by leaving out"));
}

TEST_CASE("a line that one view sees is loose, and so is a point on it") {
    const std::string line = "problem upright-shared-focal: P/P/P + Pa/Pa/Pa + Pbc/Pbc/a + a/-/a\n"
                             "excess 1\n"
                             "part views 1 2 3 points 1 2 3 lines 1 2 3 4 5\n"
                             "motion loose points lines 2\n";
    CHECK(outcome_of_record(line) == "holds");
    CHECK(contains(altered(line, "excess 1", "excess 2"), "the excess is 1"));
    CHECK(contains(altered(line, "points lines 2", "points lines 1"), "the excess is -1"));
    CHECK(contains(altered(line, "points lines 2", "points lines"), "the excess is 0"));
    CHECK(contains(altered(line, "points lines 2", "points 2 lines 2"), "the excess is -1"));
    CHECK(contains(altered(line, "points lines 2", "points 3 lines 2"),
                   "a loose point is on two lines that rest"));
    CHECK(altered(line, "points lines 2", "lines 2").starts_with("syntax"));
    const std::string points =
        "problem upright-shared-focal: -/PL/- + P/L/P + -/PL/- + P/-/P + P/P/P + 2*PM/M/M + "
        "PM/M/PM\n"
        "excess 1\n"
        "part views 1 2 3 points 1 2 3 4 5 6 7 8 lines 1 2\n"
        "motion loose points 1 3 lines 1\n";
    CHECK(outcome_of_record(points) == "holds");
    CHECK(contains(altered(points, "excess 1", "excess 2"), "the excess is 1"));
    CHECK(contains(altered(points, "loose points 1 3", "loose points 1"),
                   "a loose line contains two points that rest"));
    CHECK(contains(altered(points, "loose points 1 3 lines 1", "loose points 1 3 lines 1 2"),
                   "a loose line contains two points that rest"));
    CHECK(contains(outcome_of_record("problem PLM/PLM + 2*PL/PL + 2*PM/PM\n"
                                     "excess 1\n"
                                     "part views 1 2 points 1 2 3 4 5 lines 1 2\n"
                                     "motion loose points 1 2 lines 1 2\n"),
                   "a loose point on a loose line is on another one"));
    // Each line by itself: two through one point, one through another, and a free one.
    const std::string lines =
        "problem -/P/P/- + P/P/P/- + P/P/P/P + P/P/a/a + b/P/a/Pab + -/-/a/a + "
        "a/a/a/-\n"
        "excess 1\n"
        "part views 1 2 3 points 1 2 3 4 5 lines 1 2 3 4 5\n"
        "motion loose points lines 1 2 3 4\n";
    CHECK(outcome_of_record(lines) == "holds");
    CHECK(contains(altered(lines, "lines 1 2 3 4\n", "lines 2 3 4\n"), "the excess is 0"));
}

TEST_CASE(
    "cameras slide towards another with all that they see, if that camera alone sees it, too") {
    const std::string pairs = "problem upright-shared-focal: 4*-/P/P + 4*P/-/P\n"
                              "excess 1\n"
                              "part views 1 2 3 points 1 2 3 4 5 6 7 8 lines\n"
                              "motion central points lines\n"
                              "about view 3 views 1\n";
    CHECK(outcome_of_record(pairs) == "holds");
    CHECK(contains(altered(pairs, "excess 1", "excess 2"), "the excess is 1"));
    CHECK(contains(altered(pairs, "about view 3 views 1", "about view 2 views 1"),
                   "the motion does not keep the image of point 5"));
    CHECK(contains(altered(pairs, "views 1\n", "views 1 2\n"), "no two views rest"));
    CHECK(
        contains(altered(pairs, "views 1\n", "views 1 3\n"), "a view moves about its own centre"));
    CHECK(contains(altered(pairs, "points 1 2 3 4 5 6 7 8", "points 1 2 3 4"), "the excess is -3"));
    for (const char* wrong :
         {"about view 3 views\n", "about camera 3 views 1\n", "about 3 views 1\n",
          "about view 4 views 1\n", "about point 9 views 1\n", "about line 1 views 1\n", ""})
        CHECK(altered(pairs, "about view 3 views 1\n", wrong).starts_with("syntax"));
    CHECK(contains(altered(pairs, "about view 3", "about camera 3"),
                   "found `camera`, expected `point`, `line`, `view` or `axis`"));
    // A line that view 2 sees, too, through a point that view 1 sees.
    CHECK(contains(outcome_of_record("problem upright-shared-focal: 4*-/P/P + 2*P/-/P + Pa/a/P\n"
                                     "excess 1\n"
                                     "part views 1 2 3 points 1 2 3 4 5 6 7 lines 1\n"
                                     "motion central points lines\n"
                                     "about view 3 views 1\n"),
                   "the excess is 0"));
}

TEST_CASE("cameras that see the same points slide together, and so count once") {
    const std::string blocks =
        "problem upright-shared-focal: 2*-/-/-/-/P/P + -/-/P/P/-/- + L/PL/L/L/L/PL + L/L/PL/PL/L/L "
        "+ PL/PL/PL/PL/PL/PL + -/-/-/-/a/a + -/-/a/-/-/a + a/-/-/a/a/-\n"
        "excess 1\n"
        "part views 1 2 3 4 5 6 points 1 2 3 4 5 6 lines 1 2 3 4\n"
        "motion central points lines\n"
        "about point 6 views 1\n"
        "about point 6 views 2 5 6\n"
        "about point 6 views 3 4\n";
    CHECK(outcome_of_record(blocks) == "holds");
    CHECK(contains(altered(blocks, "views 3 4\n", "views 3\n"),
                   "the motion does not keep the image of point 3"));
    CHECK(contains(altered(blocks, "views 1\n", "views 1\nabout point 6 views 1\n"),
                   "view 1 belongs to two elements of a kind"));
    // A motion of space moves all three, so two do; one does not.
    const std::string two = with(blocks, "about point 6 views 1\n", "");
    CHECK(outcome_of_record(two) == "holds");
    CHECK(contains(altered(two, "about point 6 views 3 4\n", ""), "the excess is 0"));
    CHECK(contains(altered(blocks, "about point 6 views 1\n", "about line 4 views 1\n"),
                   "the motion does not keep the image of point 4"));
    CHECK(contains(altered(blocks, "points lines\n", "points 1 lines\n"), "has no generators"));
}

TEST_CASE(
    "a camera that does not see the centre, but a line through it, may slide towards all of it") {
    const std::string about_line =
        "problem projective: P/P/P/P + 2*PL/PL/PL/PL + PL/PL/L/L + Pab/a/Pabc/Pabc + -/a/a/- + "
        "a/-/a/- + a/a/-/- + a/a/-/a + a/a/a/a\n"
        "excess 1\n"
        "part views 1 2 3 4 points 1 2 3 4 5 lines 1 2 3 4 5 6 7 8 9\n"
        "motion central points 1 lines 1\n"
        "about point 5 views 1\n"
        "about point 5 views 2\n"
        "about point 5 views 3\n"
        "about point 5 views 4\n"
        "about line 2 views 2\n";
    CHECK(outcome_of_record(about_line) == "holds");
    CHECK(contains(altered(about_line, "about line 2 views 2\n", ""), "the excess is 0"));
    CHECK(contains(altered(about_line, "about line 2 views 2", "about line 2 views 1"),
                   "the motion does not keep the image of point 5"));
}

TEST_CASE("a point slides along a camera's ray, and cameras towards the point") {
    const std::string ray = "problem projective: -/-/P/P/P + -/-/Pabc/Pabc/Pabc + P/P/-/P/P + "
                            "2*P/P/P/P/P + Pabc/Pabc/Pabc/-/- + a/a/a/a/a\n"
                            "excess 1\n"
                            "part views 1 2 3 4 5 points 1 2 3 4 5 6 lines 1 2 3 4 5 6 7\n"
                            "motion central points 3 4 5 lines\n"
                            "about point 6 views 1\n"
                            "about point 6 views 2\n"
                            "about view 3 views 1 2\n";
    CHECK(outcome_of_record(ray) == "holds");
    CHECK(contains(altered(ray, "about view 3", "about view 4"),
                   "the motion does not keep the image of point 6"));
    CHECK(contains(altered(ray, "central points 3 4 5", "central points 3 4"),
                   "the motion does not"));
    CHECK(contains(altered(ray, "central points 3 4 5", "central points 1 3 4 5"),
                   "the rank of the generators is 4"));
    CHECK(contains(altered(ray, "about view 3 views 1 2\n", ""), "the excess is 0"));
}

TEST_CASE("each camera that slides may keep a subspace of its own") {
    const std::string own =
        "problem projective: -/-/P/a/Pa/- + -/P/-/-/-/P + -/a/a/P/a/Pa + L/PL/PL/PL/PL/PL + "
        "2*PL/PL/L/L/PL/PL + PL/L/PL/PL/L/L + Pabc/Pabc/Pabc/Pabc/Pabc/Pabc + a/a/-/P/-/- + "
        "-/-/a/-/a/-\n"
        "excess 1\n"
        "part views 1 2 3 4 5 6 points 1 2 3 4 5 6 7 8 lines 2 3 4 5 6\n"
        "motion central points lines 3\n"
        "about point 8 views 1\n"
        "about point 8 views 4 points 3 lines\n";
    CHECK(outcome_of_record(own) == "holds");
    CHECK(contains(altered(own, "excess 1", "excess 2"), "the excess is 1"));
    const char* const last = "about point 8 views 4 points 3 lines\n";
    CHECK(contains(altered(own, last, "about point 8 views 4\n"),
                   "the motion does not keep the image of point 3"));
    CHECK(contains(altered(own, last, "about point 8 views 4 points 1 3 lines\n"),
                   "the rank of the generators is 4"));
    CHECK(contains(altered(own, last, "about point 8 views 4 points 3 lines 1\n"),
                   "line 1 is not in the part"));
    CHECK(contains(altered(own, last, "about point 8 views 4 points 3 9 lines\n"),
                   "point 9 is not in the part"));
    CHECK(contains(altered(own, last, ""), "the excess is 0"));
    // What camera 1 keeps beside the line costs it a parameter, even if no camera would move it.
    CHECK(contains(altered(own, "views 1\n", "views 1 points 3 lines\n"), "the excess is 0"));
    CHECK(contains(altered(own, "points lines 3", "points 3 lines 3"), "the excess is 0"));
    for (const char* another :
         {"about point 8 views 4 points 3 lines\n", "about point 7 views 1 points 8 lines\n"})
        CHECK(contains(outcome_of_record(own + another), "belongs to two elements of a kind"));
    for (const char* wrong :
         {"views 4 points 3\n", "views 4 lines 3\n", "points 3 lines\n", "views points 3 lines\n",
          "views 4 points 3 3 lines\n", "views 4 points 10 lines\n", "views 4 points 3 lines 9\n"})
        CHECK(altered(own, "views 4 points 3 lines\n", wrong).starts_with("syntax"));
    CHECK(contains(outcome_of_record("problem upright-shared-focal: 4*-/P/P + 4*P/-/P\n"
                                     "excess 1\n"
                                     "part views 1 2 3 points 1 2 3 4 5 6 7 8 lines\n"
                                     "motion central points lines\n"
                                     "about view 3 views 1 points 1 lines\n"),
                   "has no generators"));
}

TEST_CASE("a line rests on what all elements keep that change its image") {
    // The line goes through point 3, which camera 1 keeps, and camera 4 does not: it cannot turn.
    CHECK(outcome_of_record("problem projective: 2*P/P/P/P + Pa/P/P/a + -/P/P/P + "
                            "Pabcd/Pabcd/Pabcd/Pabcd\n"
                            "excess 1\n"
                            "part views 1 2 3 4 points 1 2 3 4 5 lines 1 2 3 4 5\n"
                            "motion central points 1 2 lines\n"
                            "about point 5 views 1 points 3 lines\n"
                            "about point 5 views 4 points 4 lines\n") == "holds");
    // Only the first way in which camera 1 slides keeps point 3: the line costs two conditions.
    const std::string twice = "problem projective: 2*P/P/P/P + a/Pa/P/P + P/P/P/P\n"
                              "excess 1\n"
                              "part views 1 2 3 4 points 1 2 3 4 lines 1\n"
                              "motion central points 1 2 lines\n"
                              "about point 4 views 1 points 3 lines\n"
                              "about view 2 views 1 points 4 lines\n";
    CHECK(contains(outcome_of_record(twice), "the excess is -10"));
    CHECK(
        contains(altered(twice, "about view 2 views 1 points 4 lines\n", ""), "the excess is -9"));
}

TEST_CASE("generators of all elements may as well be those of each") {
    const std::string whole =
        "problem projective: -/-/P/P/P + -/-/Pabc/Pabc/Pabc + P/P/-/P/P + 2*P/P/P/P/P + "
        "Pabc/Pabc/Pabc/-/- + a/a/a/a/a\n"
        "excess 1\n"
        "part views 1 2 3 4 5 points 1 2 3 4 5 6 lines 1 2 3 4 5 6 7\n";
    const auto outcome = [&](const std::string& all, const std::string& each) {
        std::string record = whole + "motion central points" + all + "\n";
        for (const char* element : {"point 6 views 1", "point 6 views 2", "view 3 views 1 2"})
            record +=
                "about " + std::string(element) + (each.empty() ? "" : " points" + each) + "\n";
        return outcome_of_record(record);
    };
    for (const char* generators : {" 3 4 5 lines", " 3 4 lines", " 1 3 4 5 lines", " 3 4 5 lines 7",
                                   " 2 3 4 lines", " 3 4 5 6 lines"}) {
        CAPTURE(generators);
        const std::string common = outcome(generators, "");
        CHECK(outcome(" lines", generators) == common);
        CHECK(outcome(generators, " lines") == common);
        CHECK(outcome(generators, generators) == common);
    }
    CHECK(outcome(" 3 lines", " 4 5 lines") == "holds");
}

TEST_CASE("cameras turn about a line with all that they see and that is not on it") {
    const std::string turn = "problem 2*-/-/P/P/- + P/P/-/-/P + 3*PL/PL/PL/PL/PL\n"
                             "excess 1\n"
                             "part views 1 2 3 4 5 points 1 2 3 4 5 6 lines 1\n"
                             "motion central points lines\n"
                             "about axis 1 views 3 4\n";
    CHECK(outcome_of_record(turn) == "holds");
    CHECK(outcome_of_record(with(turn, "views 3 4\n", "views 1 2 5\n")) == "holds");
    CHECK(contains(altered(turn, "excess 1", "excess 2"), "the excess is 1"));
    CHECK(contains(altered(turn, "views 3 4\n", "views 3\n"),
                   "the motion does not keep the image of point 1"));
    CHECK(contains(altered(turn, "views 3 4\n", "views 1 2 3 4 5\n"), "no view rests"));
    CHECK(contains(altered(turn, "views 3 4\n", "views 3 4\nabout axis 1 views 1 2 5\n"),
                   "an element with an axis is not the only one"));
    CHECK(contains(altered(turn, "about axis 1", "about line 1"),
                   "the motion does not keep the image of point 4"));
    CHECK(altered(turn, "about axis 1", "about axis 2").starts_with("syntax"));
    CHECK(contains(altered(turn, "motion central", "motion projective central"),
                   "projective cameras do not turn"));
    const auto of = [&](const std::string& features, int lines) {
        std::string record = with(turn, "2*-/-/P/P/- + P/P/-/-/P + 3*PL/PL/PL/PL/PL", features);
        if (lines > 1) record = with(record, "lines 1\n", "lines 1 2\n");
        return outcome_of_record(record);
    };
    CHECK(contains(of("upright: 2*-/-/P/P/- + P/P/-/-/P + 3*PL/PL/PL/PL/PL", 1),
                   "upright cameras do not turn"));
    // The line through a point of the axis: seen from both sides it rests, and changes.
    CHECK(contains(of("2*-/-/P/P/- + P/P/-/-/P + PLa/PLa/PLa/PLa/PLa + 2*PL/PL/PL/PL/PL", 2),
                   "the excess is "));
    // Without points, it moves so that two views see it as before; three do not.
    const std::string same = "2*-/-/P/P/- + P/P/-/-/P + 3*PL/PL/PL/PL/PL + ";
    CHECK(of(same + "a/-/a/-/-", 2) == "holds");
    CHECK(contains(of(same + "a/a/a/-/-", 2), "the excess is "));
}

TEST_CASE("a camera that sees a line of four points turns about it") {
    const std::string fourth =
        "problem P/P/P/-/P/P + PL/L/PL/PL/PL/L + L/L/PL/PL/L/PL + PL/PL/L/PL/PL/PL + "
        "PL/PL/PL/PL/PL/PL\n"
        "excess 1\n"
        "part views 1 2 3 4 5 6 points 1 2 3 4 5 lines 1\n"
        "motion camera 4\n";
    CHECK(outcome_of_record(fourth) == "holds");
    CHECK(contains(altered(fourth, "excess 1", "excess 2"), "the excess is 1"));
    CHECK(contains(altered(fourth, "camera 4", "camera 3"), "the excess is -1"));
    CHECK(contains(altered(fourth, "views 1 2 3 4 5 6", "views 1 4"),
                   "fewer than two cameras of the part rest"));
    CHECK(contains(altered(fourth, "views 1 2 3 4 5 6", "views 1 2 4"), "the excess is "));
    CHECK(
        contains(altered(fourth, "views 1 2 3 4 5 6", "views 1 2 3"), "a view is not in the part"));
    CHECK(altered(fourth, "camera 4", "camera 7").starts_with("syntax"));
}

TEST_CASE("lines through a point make pencils that say too much of the cameras") {
    const std::string pencils =
        "problem projective: -/-/a/a/-/a + 2*-/P/P/P/P/P + P/-/P/-/P/- + Pa/Pa/-/Pa/Pa/Pa + "
        "Pabcd/Pabd/Pabcd/Pbcd/Pabcd/Pbcd\n"
        "excess 1\n"
        "part views 1 2 3 4 5 6 points 1 2 3 4 5 lines 3 4 5 6\n"
        "motion pencils 5\n";
    CHECK(outcome_of_record(pencils) == "holds");
    CHECK(contains(altered(pencils, "excess 1", "excess 2"), "the excess is 1"));
    CHECK(contains(altered(pencils, "points 1 2 3 4 5", "points 2 3 4 5"), "the excess is -2"));
    CHECK(contains(altered(pencils, "pencils 5", "pencils 4"),
                   "a view of the part does not see the point of the pencils"));
    CHECK(contains(altered(pencils, "lines 3", "lines 2 3"), "holds"));
    CHECK(contains(altered(pencils, "projective: ", "shared-k: "), "have no `pencils`"));
    CHECK(altered(pencils, "pencils 5", "pencils 6").starts_with("syntax"));
}

TEST_CASE("three points of a line lie in a plane with the point of the pencils") {
    const std::string flat = "problem projective: PL/PL/-/PL + PL/PL/P/PL + PL/L/-/PL + "
                             "Pab/Pa/Pab/Pab + Pabcd/Pabc/Pabcd/Pabcd\n"
                             "excess 1\n"
                             "part views 1 2 3 4 points 1 2 3 4 5 lines 1 4 5 6 7\n"
                             "motion pencils 5\n";
    CHECK(outcome_of_record(flat) == "holds");
    CHECK(contains(altered(flat, "excess 1", "excess 2"), "the excess is 1"));
    CHECK(contains(altered(flat, "lines 1 4", "lines 4"), "the part does not arise"));
    // The third point says nothing if one view sees it, and no plane if it is left out.
    CHECK(contains(altered(flat, "PL/L/-/PL", "PL/L/-/L"), "the excess is 0"));
    CHECK(contains(altered(flat, "points 1 2 3 4 5", "points 1 2 4 5"), "the excess is 0"));
    CHECK(contains(altered(flat, "lines 1 4", "lines 1 2 4"), "holds"));
    CHECK(contains(altered(flat, "pencils 5", "pencils 2"), "a line joins the point and another"));
}

TEST_CASE("cameras move and do not turn: lines cost no more than moving views that see them") {
    // Camera 5 sees two lines. It moves along both planes in which it sees them.
    const std::string fifth = "problem upright-shared-focal: P/P/P/P/-/P + P/P/P/P/-/- + "
                              "-/a/a/a/a/a + a/a/-/-/a/-\n"
                              "excess 1\n"
                              "part views 1 2 3 4 5 6 points 1 2 lines 1 2\n"
                              "motion plane views 5 points lines\n";
    CHECK(outcome_of_record(fifth) == "holds");
    CHECK(contains(altered(fifth, "plane views 5", "plane views 4"),
                   "does not keep the image of point 1"));
    CHECK(contains(altered(fifth, "excess 1", "excess 2"), "the excess is 1"));
    // Camera 4 sees a line with points that it does not see: the line rests, and costs one.
    const std::string fourth =
        "problem upright-shared-focal: P/L/PL/L/PL + -/PL/L/L/PL + -/a/a/-/a + a/a/a/a/a\n"
        "excess 1\n"
        "part views 1 2 3 4 5 points 1 2 lines 1 2 3\n"
        "motion plane views 4 points lines\n";
    CHECK(outcome_of_record(fourth) == "holds");
    CHECK(contains(altered(fourth, "excess 1", "excess 2"), "the excess is 1"));
}
