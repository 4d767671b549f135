// Records of solutions (FORMAT.md, section 14): what holds, and what is refused for which reason if
// anything is altered in it.
#include "tests/support/file.h"
#include "tests/support/text.h"

#include "checker/degrees/krawczyk.h"
#include "checker/replay.h"
#include "tests/support/all_classes.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

/// Three solutions; two are complex conjugates.
const std::string seven_points = R"(problem projective: 7*P/P
view 31 80 -3 -2 39 26 10 -1 -22 13 -51 -36 -26 -18 36 63 -32 -6 96 47 -75
view 23 83 -92 -22 -55 -84 -46 74 1 -50 -27 13 -18 94 -95 -33 42 -55 -38 44 -34
pair 5 -9 2 18 -3 52 -13 -52 13 20 -8 -26 10 -100 59 108 77 30 -1 20 -18 -217 -72 3 22 -754 \
-83 -444 -186
real 5 -3 9 -93 -15 -3 5 75 116 11 103 70 205 1256 1318
)";

/// Points on a line, a pin and a free line, of calibrated cameras: one solution.
const std::string lines = R"(problem 2*PL/PL/PL + PLa/PLa/PLa + a/a/a
view 51 -21 74 -50 -92 -18 -1 -5 50 77 54 -82 5 49 39 93 -75
view -27 86 79 81 -67 31 -2 -5 -86 -42 40 50 -31 90 76 74 69
view -40 -69 87 23 24 98 -5 1 45 17 -7 -26 74 95 7 -86 -20
real 5 -71 186 -100 -135 -94 -3 22 -10 3 3 -5 -99551 28179 -23061 -34523 36232
)";

/// Images of three points on a line; view 3 shows two of them at the same place. The zeros of such
/// equations explain no images.
const std::string no_point = R"(problem projective: 3*PL/PL/PL + 2*P/P/P + 2*a/a/a
view 79 63 -92 -67 -60 55 2 -4 57 -92 -39 -74 -92 -86 21 -43 53 11 -84 -24 -72 -92 -30 74 34 1
view -53 -98 24 -19 74 -92 2 -5 89 -33 -34 -17 86 -62 -88 -74 -48 -29 -98 -35 -21 91 -42 -81 \
-46 -83
view 74 -95 54 -11 96 64 0 1 48 85 31 52 74 60 68 -60 -48 -43 -49 -55 -95 -81 -51 -49 79 -6
real 5 -3 52 -42 -14 6 -28 64 3 35 -22 33 -3 44 -71 27 -1 36 -53 -766 -343 100 1743 1474 -93 \
-978 652
)";
const std::string no_camera = R"(problem projective: 3*PLa/PLa/PLa + P/P/P + Pa/Pa/Pa
view 79 63 -92 -67 -60 55 2 -4 57 -92 -39 -74 -92 -86 21 -43 53 11 -84 -24 -72 -92 -30 74 34 1
view -53 -98 24 -19 74 -92 2 -5 89 -33 -34 -17 86 -62 -88 -74 -48 -29 -98 -35 -21 91 -42 -81 \
-46 -83
view 74 -95 54 -11 96 64 0 1 48 85 31 52 74 60 68 -60 -48 -43 -49 -55 -95 -81 -51 -49 79 -6
real 5 -29 105 -19 -30 52 -75 53 143 -70 156 -279 -1252 607 -1364 -186 -835 405 -909 -3679 \
-1648 1773 1961 1880 -1825 958 -1469
)";

/// `N solutions`, or the first complaint as `line: reason`, after `syntax` if the file does
/// not conform.
std::string outcome(const std::string& records) {
    const ReplayedFile file = replay(all_classes(), "file", "plcert 2 solutions\n" + records);
    if (const auto* malformed = std::get_if<Malformed>(&file.content))
        return say("syntax, ", malformed->complaint.line, ": ", malformed->complaint.reason);
    const auto& content = std::get<SolutionsFile>(file.content);
    if (content.refusals.count > 0)
        return say(content.refusals.first[0].line, ": ", content.refusals.first[0].reason);
    std::string counts;
    for (const SolutionCount& count : content.counts)
        counts += say(counts.empty() ? "" : ", ", count.solutions);
    return counts;
}

/// The same of the first record with another part in the place of the first such one.
std::string altered(const std::string& record, const char* old, const char* replacement) {
    return outcome(with(record, old, replacement));
}

/// The last line of a text.
std::string last_line(const std::string& text) {
    const std::size_t end = text.size() - 1;
    return text.substr(text.rfind('\n', end - 1) + 1);
}

} // namespace

TEST_CASE("records hold, alone and together") {
    if (!has_arb) return;
    CHECK(outcome(seven_points) == "3");
    CHECK(outcome(lines) == "1");
    CHECK(outcome(seven_points + lines + seven_points) == "3, 1, 3");
}

TEST_CASE("a solution counts once") {
    if (!has_arb) return;
    CHECK(outcome(lines + last_line(lines)) ==
          "7: 2*PL/PL/PL + PLa/PLa/PLa + a/a/a: this may be the solution of line 6");
    // The same cameras at other depths lead to the same solution.
    CHECK(outcome(lines + with(last_line(lines), " 36232", " 36300")) ==
          "7: 2*PL/PL/PL + PLa/PLa/PLa + a/a/a: this may be the solution of line 6");
}

TEST_CASE("a starting value far from any solution is refused, and the others of a file stand") {
    if (!has_arb) return;
    std::string far = lines.substr(0, lines.size() - last_line(lines).size()) + "real 0";
    for (int i = 0; i < 16; ++i)
        far += " 999999999999999999";
    far += '\n';
    CHECK(contains(outcome(far), "6: 2*PL/PL/PL + PLa/PLa/PLa + a/a/a: no "));
    const ReplayedFile file =
        replay(all_classes(), "file", "plcert 2 solutions\n" + far + seven_points);
    CHECK(std::get<SolutionsFile>(file.content).counts.size() == 1);
}

TEST_CASE("a pair that is real is refused, and so is a real line that leads nowhere real") {
    if (!has_arb) return;
    std::string pair = "pair 5";
    std::string words = last_line(lines).substr(6);
    words.pop_back();
    for (std::size_t at = 0; (at = words.find(' ', at)) != words.npos;) {
        const std::size_t end = std::min(words.find(' ', at + 1), words.size());
        pair += words.substr(at, end - at) + " 0";
        at = end;
    }
    CHECK(contains(outcome(lines.substr(0, lines.size() - last_line(lines).size()) + pair + '\n'),
                   "the pair may be real"));
}

TEST_CASE("images that do not meet the conditions are refused") {
    if (!has_arb) return;
    CHECK(contains(altered(lines, "view 51 -21 74", "view 51 -21 0"),
                   "an image point has 0 as third coordinate"));
    CHECK(contains(altered(lines, "-50 -92 -18", "51 -21 74"),
                   "its auxiliary line contains another point"));
    CHECK(contains(altered(lines, "-18 -1 -5", "-18 -1 0"),
                   "its auxiliary line contains another point"));
    CHECK(contains(altered(lines, "-82 5 49", "39 93 -75"),
                   "two image points of a line are the same"));
}

TEST_CASE("zeros that explain no images are refused") {
    if (!has_arb) return;
    CHECK(contains(outcome(no_point), ": a point may be the centre of a camera"));
    CHECK(contains(outcome(no_camera), ": a camera may have a rank less than 3"));
}

/// The records of a small file of certs/vectors.
std::string vector(const std::string& name) {
    const std::string file = read(SOURCE_DIR "/certs/vectors/solutions-" + name + ".plc");
    return file.substr(file.find('\n') + 1);
}

TEST_CASE("fibres hold, and two of a problem show permutations of its solutions") {
    CHECK(outcome(vector("fibre")) == "3");
    const ReplayedFile file =
        replay(all_classes(), "file", "plcert 2 solutions\n" + vector("two-fibres"));
    const std::vector<SolutionCount>& counts = std::get<SolutionsFile>(file.content).counts;
    REQUIRE(counts.size() == 2);
    CHECK(counts[0].cycle_types.empty());
    CHECK(counts[1].cycle_types.size() == 2);
}

TEST_CASE("what refuses a fibre of a problem in general, and why") {
    const std::string about = "2: projective: 7*P/P: ";
    CHECK(outcome(vector("fibre-equation")) == about + "equation 13 is not 0");
    CHECK(outcome(vector("fibre-separated")) == about + "the sum of `separated by` is not t");
    CHECK(outcome(vector("fibre-centre")) == about + "a point may be the centre of a camera");
    CHECK(outcome(vector("fibre-rank")) == about + "a camera may have a rank less than 3");
    const std::string good = vector("fibre");
    CHECK(contains(outcome(with(good, "7*P/P", "8*P/P")), "syntax, 3: "));
    CHECK(contains(outcome(with(good, "fibre 3", "fibre 0")), "syntax, 5: "));
    CHECK(contains(outcome(with(good, "fibre 3", "fibre 2")), "syntax, 6: "));
    CHECK(contains(outcome(good + "real 0\n"), "syntax, 22: "));
}

TEST_CASE("problems with incomplete visibility are refused") {
    if (!has_arb) return;
    std::string record = "problem 2*P/P/P + a/Pa/Pa + a/a/a\n";
    for (int view = 1; view <= 3; ++view) {
        record += "view";
        for (int number = 1; number <= 18; ++number)
            record += say(' ', number * number - view);
        record += '\n';
    }
    record += "real 0";
    for (int unknown = 0; unknown < 17; ++unknown)
        record += " 1";
    CHECK(contains(outcome(record + '\n'), ": some view misses a point or a line"));
}

TEST_CASE("points that are combinations of others may have nine digits, too, and no more") {
    if (!has_arb) return;
    CHECK(contains(altered(lines, " -1 -5 ", " 10000000 -5 "), "no proof of a zero"));
    CHECK(altered(lines, " -1 -5 ", " 20000000 -5 ") ==
          "2: 2*PL/PL/PL + PLa/PLa/PLa + a/a/a: a coordinate of the images is too large");
}

TEST_CASE("problems without such a system are refused") {
    if (!has_arb) return;
    const std::string five = "problem 5*P/P\nview 1 2 3 1 2 4 1 2 5 1 2 6 1 2 7\n"
                             "view 1 2 3 1 2 4 1 2 5 1 2 6 1 2 7\nreal 0 1 1 1 1 1 1 1 1 1 1\n";
    CHECK(outcome(five).starts_with("5: 5*P/P: "));
    const std::string four = "problem 4*P/P\nview 1 2 3 1 2 4 1 2 5 1 2 6\n"
                             "view 1 2 3 1 2 4 1 2 5 1 2 6\nreal 0 1 1 1 1 1 1 1 1 1\n";
    CHECK(outcome(four) == "2: 4*P/P: it is not balanced, so it has no degree");
    const std::string hidden = "problem P/P + 4*P/P/P\n";
    CHECK(outcome(hidden).starts_with("syntax, 2: "));
}

TEST_CASE("what does not conform is refused with its line") {
    if (!has_arb) return;
    for (const auto& [old, replacement, line] : {std::tuple{"-75\nview", "-75 1\nview", 3},
                                                 {" -75\nview", "\nview", 3},
                                                 {"view 51", "view 1000000000", 3},
                                                 {"view 51", "view 051", 3},
                                                 {"problem 2", "problem 1", 2},
                                                 {"real 5 ", "real 201 ", 6},
                                                 {"real 5 ", "real ", 6},
                                                 {"real", "solution", 6},
                                                 {" 36232", " 36232 1", 6},
                                                 {"real", "pair", 6},
                                                 {"+ a/a/a", "+ a/a/-", 3}}) {
        CAPTURE(replacement);
        const std::string found = altered(lines, old, replacement);
        CHECK((found.starts_with(say("syntax, ", line, ": ")) ||
               contains(found, "it is not balanced")));
    }
}
