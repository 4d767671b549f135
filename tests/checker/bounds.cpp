// Files of upper bounds by the letter of FORMAT.md, section 10: what the committed one certifies,
// laws that its bounds obey, and templates that are altered in one place, each refused for that.
#include "checker/claims.h"
#include "checker/rotation_ring.h"

#include <doctest/doctest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <tuple>

using namespace checker;

namespace {

const Classification& classes() {
    static const Classification all = classify();
    return all;
}

const std::string& committed_file() {
    static const std::string bytes = [] {
        std::ifstream in(CERTS_DIR "/bounds.plc", std::ios::binary);
        return std::string{std::istreambuf_iterator<char>(in), {}};
    }();
    return bytes;
}

const FileReport& committed() {
    static const FileReport report = replay(classes(), "bounds.plc", committed_file());
    return report;
}

bool extends_five_points(const Signature& s) {
    return std::ranges::any_of(view_pairs, [&](Views pair) { return shared_points(s, pair) == 5; });
}

/// What a classification file proves: of every class, whether it is minimal.
FileReport verdicts_on_all() {
    FileReport all{.name = "all", .kind = "classification"};
    for (std::size_t n = 0; n < classes().representatives.size(); ++n)
        all.verdicts.push_back({n, 1, obstruction(classes().representatives[n])});
    return all;
}

unsigned points_in_all(const Signature& s) {
    unsigned points = 0;
    for (std::size_t i = 0; i < feature_count; ++i)
        if (features[i].point == 0b111) points += s[i];
    return points;
}

unsigned free_lines(const Signature& s) {
    unsigned lines = 0;
    for (std::size_t i = 0; i < feature_count; ++i)
        if (features[i].free_line) lines += s[i];
    return lines;
}

std::size_t class_of(const std::string& wanted) {
    for (std::size_t n = 0; n < classes().representatives.size(); ++n)
        if (notation(classes().representatives[n]) == wanted) return n;
    FAIL("no such class: ", wanted);
    return 0;
}

/// What the checker makes of templates, whatever class they are for: `holds`, or the first
/// complaint.
std::string outcome(const std::string& templates) {
    const FileReport report = replay(Classification{}, "file",
                                     "plcert 1 bounds\nmodulus 2305843009213693951\n" + templates);
    if (report.complaints.empty()) return "holds";
    return (report.conforms ? "" : "syntax: ") + report.complaints[0].reason;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != text.npos;
}

std::string with(std::string text, const std::string& old, const std::string& replacement) {
    REQUIRE(contains(text, old));
    return text.replace(text.find(old), old.size(), replacement);
}

/// Two known points and a line: the smallest template of the committed file.
const std::string two_points_and_a_line = R"(template line degree 1 3
star point 0 0 0 image 66 4 -66
star point 33 -62 79 image -88 -4 -92
line point 78 -86 -9 direction 1 0 0 image 0 0 1
basis 1 2 5 6
rows 1 1 2 5 8 9 12 15 16 19
rows 2 1 2 3 5
rows 3 1 2 3 5
minor 594677692319771619
)";

/// Two known points, one with a pin, and a ray.
const std::string on_the_axis = R"(template points degree 4 2
star point 0 0 0 image 66 4 0
star point 33 0 0 image -88 -4 0 pin 78 -86 -9 toward 15 16 -47
transversals point -74 -58 32 direction -36 70 38 image -29 11 -94
basis 1 2 4 6 9 11 26 27 29 31 34 36
rows 1 1 2 4 6 7 9 11 12 14 16 17 19 26 27 29 31 32 34 36 37 39
rows 2 1 2 4 6 7 9 11 12 14 26 27 32
minor 1764528126404496281
)";

} // namespace

TEST_CASE("the committed templates hold, and bound all extensions, and some with common lines") {
    CHECK(committed().conforms);
    CHECK(committed().refused == 0);
    CHECK(committed().templates == 89);
    REQUIRE(committed().upper.size() == classes().representatives.size());
    std::size_t extensions = 0, terminal = 0;
    using Swaps = std::set<std::size_t>;
    std::map<std::size_t, Swaps> by_lines, by_points, by_both; // by bound
    for (std::size_t n = 0; n < classes().representatives.size(); ++n) {
        const Signature& s = classes().representatives[n];
        const bool extension = obstruction(s).minimal() && extends_five_points(s);
        extensions += extension;
        terminal += committed().upper[n] > 0 && classes().swap_class[n] == n;
        if (extension)
            CHECK(committed().upper[n] > 0);
        else if (committed().upper[n] > 0)
            (points_in_all(s) == 3                        ? by_points
             : points_in_all(s) == 2 && free_lines(s) > 0 ? by_both
                                                          : by_lines)[committed().upper[n]]
                .insert(classes().swap_class[n]);
        if (obstruction(s).minimal() && points_in_all(s) == 3) CHECK(committed().upper[n] > 0);
    }
    CHECK(extensions == 6413);
    CHECK(by_lines.size() == 3);
    CHECK(by_lines.at(64).size() == 13);                      // six lines through a point
    CHECK(by_lines.at(240) == Swaps{18, 19, 20, 21, 69, 70}); // five, and another
    CHECK(by_lines.at(272) == Swaps{22, 23, 32, 33, 34, 35, 36, 71, 72}); // and two points
    CHECK(by_points == std::map<std::size_t, Swaps>{{216, {6722}},
                                                    {224, {811}},
                                                    {272, {6723}},
                                                    {304, {2446}},
                                                    {312, {2394}},
                                                    {368, {6727, 6729}},
                                                    {376, {2447, 2448}},
                                                    {384, {6725}},
                                                    {448, {6730, 6732, 6734}},
                                                    {464, {6726, 6728}},
                                                    {520, {6731, 6733, 6735}}});
    CHECK(by_both == std::map<std::size_t, Swaps>{
                         {240, {6736}}, {256, {6767}}, {264, {2455}}, {304, {6768, 6769}}});
    CHECK(committed().at_most.at(64) == 13); // terminal problems
    CHECK(committed().at_most.at(272) == 10);
    CHECK(committed().at_most.at(400) == 13); // those with groups of five rays
    CHECK(committed().at_most.at(1280) == 342);
    CHECK(terminal == 3615 + 28 + 18 + 5);
}

TEST_CASE("upper bounds of extensions are multiples of 80, and the same for all of a swap class") {
    for (std::size_t n = 0; n < classes().representatives.size(); ++n) {
        const std::size_t upper = committed().upper[n];
        if (extends_five_points(classes().representatives[n]))
            CHECK(upper % 80 == 0); // 20 poses; cameras come in fours
        CHECK(committed().upper[n] == committed().upper[classes().swap_class[n]]);
    }
}

TEST_CASE("upper bounds of problems with known degrees") {
    const auto upper = [](const std::string& problem) {
        return committed().upper[class_of(problem)];
    };
    // The registration problems among the PL0Ps (section 6 of the paper): 160, and 80 with a line.
    CHECK(upper("2*P/P/P + a/a/a + 3*-/P/P") == 80);
    CHECK(upper("3*P/P/P + 2*-/P/P") == 160);
    CHECK(upper("P/P/P + 4*a/a/a") == 0); // no extension
    CHECK(upper("Pabcdef/Pabcdef/Pabcdef + 2*P/a/a") == 64);
    CHECK(upper("Pabcde/Pabcde/Pabcde + P/P/P") == 64); // the line to the other point is the sixth
    CHECK(upper("Pabcde/Pabcde/Pabcde + a/P/Pa + -/P/P") == 272);
    CHECK(upper("Pabcde/Pabcde/Pabcde + a/P/Pa + P/-/P") == 272);
    CHECK(upper("Pabcde/Pabcde/Pabcde + a/P/Pa + P/a/a") == 0);
    CHECK(upper("Pabcde/Pabcde/Pabcde + -/P/P + P/-/P + P/P/-") == 0);
    CHECK(upper("Pabcd/Pabcd/Pabcd + Pa/Pa/Pa") == 240); // the line to the other point
    CHECK(upper("Pabcd/Pabcd/Pabcd + P/P/P + -/P/P") == 240);
    CHECK(upper("Pabcd/Pabcd/Pabcd + P/P/P + P/a/a") == 272);
    CHECK(upper("Pabc/Pabc/Pabc + P/P/P + a/a/a") == 0);     // four lines through a point
    CHECK(upper("Pabcdefg/Pabcdefg/Pabcdefg + P/a/a") == 0); // not minimal
    CHECK(upper("2*Pa/Pa/Pa + P/P/P") == 312);               // the Chicago problem
    CHECK(upper("Pa/Pa/Pa + P/P/P + 2*a/a/a") == 264);       // two points, and two lines
    CHECK(upper("2*P/P/P + 2*a/a/a + -/P/P") == 256);
    CHECK(upper("2*P/P/P + a/Pa/Pa + a/a/a") == 240);
    CHECK(upper("2*P/P/P + a/a/a + a/P/Pa + -/P/P") == 0); // the pin is not seen by all
    CHECK(upper("Pa/Pa/Pa + P/P/P + a/Pa/Pa + -/P/P") == 0);
    CHECK(upper("Pa/Pa/Pa + P/P/P + a/a/a + 2*-/P/P") == 0);
    CHECK(upper("2*P/P/P + a/a/a + 2*-/P/P + P/-/P") == 0);
}

TEST_CASE("small templates hold; without that of the relative pose they bound no extension") {
    CHECK(outcome(two_points_and_a_line) == "holds");
    CHECK(outcome(on_the_axis) == "holds");
    CHECK(outcome(on_the_axis + two_points_and_a_line) == "holds");
    const FileReport report =
        replay(classes(), "file", "plcert 1 bounds\nmodulus 2305843009213693951\n" + on_the_axis);
    CHECK(report.templates == 1);
    for (std::size_t n = 0; n < classes().representatives.size(); ++n)
        CHECK(report.upper[n] ==
              (extends_five_points(classes().representatives[n]) ? 0 : committed().upper[n]));
}

TEST_CASE("of two templates of a type the one with the smaller basis counts") {
    const std::string& all = committed_file();
    std::string poses; // the template of a single group of five rays
    for (std::size_t at = all.find("template"), end = 0; at < all.size(); at = end) {
        end = std::min(all.find("template", at + 1), all.size());
        const std::string one = all.substr(at, end - at);
        const bool group = std::regex_search(
            one, std::regex("^template[^\\n]*\\ntransversals point \\S+ \\S+ \\S+"
                            "( direction \\S+ \\S+ \\S+ image \\S+ \\S+ \\S+){5}\\nbasis"));
        if (group) poses = one;
    }
    REQUIRE(!poses.empty());
    std::string larger = two_points_and_a_line;
    larger = with(larger, "basis 1 2 5 6", "basis 1 2 3 5 6");
    larger = with(larger, "rows 1 1 2 5", "rows 1 2 5");
    larger = with(larger, "594677692319771619", "892270926731167537");
    CHECK(outcome(larger) == "holds");
    const auto upper = [&](const std::string& templates) {
        const FileReport report =
            replay(classes(), "file",
                   "plcert 1 bounds\nmodulus 2305843009213693951\n" + poses + templates);
        CHECK(report.refused == 0);
        return report.upper[class_of("2*P/P/P + a/a/a + 3*-/P/P")];
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
    CHECK(outcome(with(good, "rows 1 1 2 5", "rows 1 1 2 3 5")) ==
          "there are 18 rows for 17 columns");
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
    CHECK(contains(outcome(with(two_points_and_a_line, "basis 1 2 5 6", "basis 1 2 5 22")),
                   "syntax: found `22`, expected an integer from 6 to 21"));
    CHECK(contains(outcome(with(two_points_and_a_line, "rows 3 1", "rows 9 1")),
                   "syntax: found `9`, expected an integer from 3 to "));
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
basis 1 2 3 4 6 10 12 16 23 25 29
rows 1 1 2 4 6 10 12 16 23 25 29
)";
    for (int equation = 2; equation <= 15; ++equation)
        text += say("rows ", equation, " 1\n");
    CHECK(outcome(text + "minor 1\n") == "equation 15 times monomial 1 is of too large a degree");
}

TEST_CASE("what a frame requires is refused where it is missing") {
    const std::string axis = "the first line is not the axis", star = "a star is not on the axis";
    CHECK(outcome(with(two_points_and_a_line, "direction 1 0 0", "direction 2 0 0")) == axis);
    CHECK(outcome(with(two_points_and_a_line, "direction 1 0 0", "direction 1 1 0")) == axis);
    CHECK(outcome(with(two_points_and_a_line, "image 0 0 1", "image 0 1 1")) == axis);
    CHECK(outcome(with(two_points_and_a_line, "point 0 0 0", "point 0 0 1")) ==
          "the first star is not at the origin");
    CHECK(outcome(with(on_the_axis, "point 0 0 0", "point 1 0 0")) ==
          "the first star is not at the origin");
    CHECK(outcome(with(on_the_axis, "point 33 0 0", "point 33 1 0")) == star);
    CHECK(outcome(with(on_the_axis, "point 33 0 0", "point 33 0 1")) == star);
    CHECK(outcome(with(on_the_axis, "image -88 -4 0", "image -88 -4 1")) == star);
    CHECK(outcome(with(on_the_axis, "points", "line")) == "the frame does not fit the constraints");
    const std::string incidence = "incidence point 1 2 3 line 4 5 6\n";
    CHECK(
        outcome(with(with(on_the_axis,
                          "star point 33 0 0 image -88 -4 0 pin 78 -86 -9 toward 15 16 -47\n", ""),
                     "transversals", incidence + incidence + incidence + "transversals")) ==
        "the frame does not fit the constraints"); // one star where there should be two
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
          "the frame does not fit the constraints");
    // Without the polynomial of lower degree there are zeros at infinity, and no template.
    CHECK(contains(outcome(with(good, "rows 2", "rows 3")), "is of too large a degree"));
}

TEST_CASE("constraints have weight six, except those of the relative pose") {
    CHECK(outcome(with(on_the_axis, " pin 78 -86 -9 toward 15 16 -47", "")) != "holds"); // weight 5
    CHECK(contains(outcome(with(on_the_axis, "image -29 11 -94",
                                "image -29 11 -94 direction 1 2 3 image 4 5 6")),
                   "expected constraints of weight 6"));
    CHECK(contains(outcome(with(on_the_axis, "toward 15 16 -47",
                                "toward 15 16 -47 pin 1 2 3 toward 3 4 5 pin 1 2 4 toward 3 5 5")),
                   "expected constraints of weight 6"));
    std::string basis, some; // the monomials of degree 2 at most; as many as columns are left, less
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
          "the constraints have weight 5");
    const std::string general = R"(template general degree 1
incidence point 1 2 3 line 4 5 7
basis 1
rows 1 1
minor 1
)";
    CHECK(contains(outcome(general), "syntax: found `1`, expected an integer from 1 to 0"));
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

TEST_CASE("a degree is certified exact where the bounds meet, and not a solution earlier") {
    const FileReport all = verdicts_on_all();
    const std::string problem = "2*P/P/P + a/a/a + 3*-/P/P";
    const std::size_t number = class_of(problem);
    const auto claim = [&](std::size_t solutions) {
        const FileReport degrees{
            .name = "degrees", .kind = "degrees", .degrees = {{number, 1, solutions, false}}};
        const Report report = summarize(classes(), {all, committed(), degrees});
        const auto about = [&](const DegreeClaim& c) { return contains(c.claim, problem); };
        const auto found = std::ranges::find_if(report.degrees, about);
        REQUIRE(found != report.degrees.end());
        const auto total =
            std::ranges::find(report.degrees, "terminal, of any degree", &DegreeClaim::claim);
        REQUIRE(total != report.degrees.end());
        return std::tuple(*found, report.status, total->exact);
    };
    const auto [exact, status, all_exact] = claim(80);
    CHECK(status == 0);
    CHECK(exact.certified == "80");
    CHECK(exact.exact == "80");
    CHECK(exact.paper == "80");
    // ... and with it the degree of all classes with the same type of registration.
    CHECK(all_exact == "8");
    const auto [less, still, none_exact] = claim(79);
    CHECK(still == 0);
    CHECK(less.certified == "79");
    CHECK(less.exact == "-");
    CHECK(none_exact == "0");
    CHECK(less.known == "-");
}

TEST_CASE("of the bounds that are theorems, one that is attained says nothing of others, but 64") {
    const FileReport all = verdicts_on_all();
    const auto exact = [&](const std::string& problem, std::size_t solutions) {
        const FileReport degrees{.name = "degrees",
                                 .kind = "degrees",
                                 .degrees = {{class_of(problem), 1, solutions, false}}};
        std::map<std::size_t, std::size_t> classes_with; // this degree
        for (const auto& [number, degree] : summarize(classes(), {all, committed(), degrees}).exact)
            ++classes_with[degree];
        return classes_with;
    };
    using Classes = std::map<std::size_t, std::size_t>;
    CHECK(exact("2*Pa/Pa/Pa + P/P/P", 312) == Classes{{312, 1}});
    CHECK(exact("Pabcd/Pabcd/Pabcd + Pa/Pa/Pa", 240) == Classes{{240, 1}});
    CHECK(exact("Pabcde/Pabcde/Pabcde + P/P/P", 64) == Classes{{64, 13}});
}

TEST_CASE("where certificates contradict each other, nothing follows") {
    const FileReport all = verdicts_on_all();
    const FileReport bounds = committed();
    const std::size_t one = class_of("2*P/P/P + a/a/a + 3*-/P/P"); // at most 80 solutions
    const auto same = std::ranges::find(bounds.types.begin() + std::ptrdiff_t(one) + 1,
                                        bounds.types.end(), bounds.types[one]);
    REQUIRE(same != bounds.types.end());
    const auto other = std::size_t(same - bounds.types.begin());
    const auto consistent = [&](const std::vector<Degree>& degrees,
                                const std::vector<FileReport>& files) {
        std::vector<FileReport> given{all, {.name = "degrees", .kind = "degrees"}};
        given[1].degrees = degrees;
        given.insert(given.end(), files.begin(), files.end());
        const Report report = summarize(classes(), given);
        CHECK((report.status == 0 || report.exact.empty()));
        CHECK(report.degrees.empty() == (report.status == 1));
        const bool says = contains(complaints(report), "certificates contradict each other: ");
        CHECK(says == (report.status == 1));
        CHECK(report.files[1].degrees.empty() == (report.status == 1));
        return report.status == 0;
    };
    CHECK(consistent({{one, 1, 80, false}}, {bounds}));
    CHECK_FALSE(consistent({{one, 1, 81, false}}, {bounds}));
    // One class attains the bound of the type, and another is said to have more solutions.
    CHECK_FALSE(consistent({{one, 1, 80, false}, {other, 2, 81, false}}, {bounds}));
    // ... or at most fewer, by another file.
    FileReport less = bounds;
    less.name = "less";
    less.upper[other] = 79;
    less.types[other] = {};
    CHECK(consistent({{one, 1, 79, false}}, {bounds, less}));
    CHECK_FALSE(consistent({{one, 1, 80, false}}, {bounds, less}));
    CHECK_FALSE(consistent({{one, 1, 80, false}}, {less, bounds}));
}
