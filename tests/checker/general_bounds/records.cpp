// Files of upper bounds (FORMAT.md, section 15): what holds, and what is refused for which reason
// if anything is altered in it.
#include "checker/replay.h"
#include "tests/support/all_classes.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>

using namespace checker;

namespace {

/// Six points in three views, and two further images.
const std::string six_points = R"(problem projective: 6*P/P/P
view -37 87 80 -35 -76 -56 -97 -42 51 -10 -20 -47 77 -58 -65 67 71 -87
view 41 -4 -86 86 31 -46 -91 -81 26 37 -97 -4 35 -19 61 20 53 -25
view 68 77 40 28 81 4 89 2 17 45 31 -12 36 99 -17 62 24 -34
view 32 36 -83 93 83 -44 80 -67 -80 -21 -69 -14 -89 -39 -83 -88 -25 9
view -74 43 96 77 -89 53 49 -79 -44 51 -5 99 56 93 -97 61 -54 32
powers 1 2
)";

/// The bounds, or the first complaint as `line: reason`, after `syntax` if the file does not
/// conform.
std::string outcome(const std::string& records, std::uint64_t effort = usual_effort) {
    const ReplayedFile file =
        replay(all_classes(), "file", "plcert 2 at-most\n" + records, Execution{.effort = effort});
    if (const auto* malformed = std::get_if<Malformed>(&file.content))
        return say("syntax, ", malformed->complaint.line, ": ", malformed->complaint.reason);
    const auto& content = std::get<AtMostFile>(file.content);
    if (content.refusals.count > 0)
        return say(content.refusals.first[0].line, ": ", content.refusals.first[0].reason);
    std::string bounds;
    for (const SolutionBound& bound : content.bounds)
        bounds += say(bounds.empty() ? "" : ", ", bound.at_most);
    return bounds;
}

std::string altered(const std::string& old, const std::string& replacement) {
    return outcome(with(six_points, old, replacement));
}

} // namespace

TEST_CASE("records that hold say at most how many solutions there are") {
    CHECK(outcome(six_points) == "3");
    CHECK(outcome(six_points + six_points) == "3, 3");
    CHECK(altered("powers 1 2", "powers 1 3") == "3");
}

TEST_CASE("powers that give no bound are refused, with what is left open") {
    CHECK(contains(altered("powers 1 2", "powers 1 1"), "dimensions open: take other powers"));
}

TEST_CASE("images that are too special, or the same, are refused") {
    const std::string second =
        "view 41 -4 -86 86 31 -46 -91 -81 26 37 -97 -4 35 -19 61 20 53 -25\n";
    const std::string third = "view 68 77 40 28 81 4 89 2 17 45 31 -12 36 99 -17 62 24 -34\n";
    // Two views that show the same leave a curve of solutions.
    CHECK(contains(altered(third, second), "take other powers"));
    // In view 2 all points are on a line.
    // In view 2 all points are one.
    CHECK(altered(second, "view 1 2 1 1 2 1 1 2 1 1 2 1 1 2 1 1 2 1\n") ==
          "2: projective: 6*P/P/P: an image is too special: it leaves a part of the camera open");
    CHECK(contains(altered("41 -4 -86 86", "41 -4 0 86"), "0 as third coordinate"));
    CHECK(altered("view -37 87 80 -35 -76 -56 -97 -42 51 -10 -20 -47 77 -58 -65 67 71 -87",
                  "view 1 0 1 2 0 1 3 0 1 4 0 1 5 0 1 6 0 1") ==
          "2: projective: 6*P/P/P: view 1 shows everything on a line");
}

TEST_CASE("a problem that is calibrated, unbalanced or partly hidden has no such bound") {
    const auto of = [](const std::string& problem, int numbers) {
        std::string views;
        for (int view = 0; view < 5; ++view) {
            views += "view";
            for (int i = 0; i < numbers; ++i)
                views += say(' ', (i * i * 7 + view * 31 + 5) % 83 + 1);
            views += '\n';
        }
        return outcome("problem " + problem + '\n' + views + "powers 1 2\n");
    };
    CHECK(contains(of("3*P/P/P + a/a/a", 15), "its cameras are calibrated"));
    CHECK(contains(of("projective: 5*P/P/P", 15), "it is not balanced"));
    CHECK(contains(of("projective: 5*P/P/P + 3*P/P/-", 24), "misses a point or a line"));
}

TEST_CASE("the grammar") {
    const std::string last = "view -74 43 96 77 -89 53 49 -79 -44 51 -5 99 56 93 -97 61 -54 32\n";
    const std::string fourth =
        "view 32 36 -83 93 83 -44 80 -67 -80 -21 -69 -14 -89 -39 -83 -88 -25 9\n";
    CHECK(outcome(with(with(six_points, last, ""), fourth, "")) ==
          "syntax, 6: found `powers`, expected `view`");
    CHECK(altered("powers 1 2", "powers 0 2") ==
          "syntax, 8: found `0`, expected an integer from 1 to 20");
    CHECK(altered("powers 1 2", "powers 1 21") ==
          "syntax, 8: found `21`, expected an integer from 1 to 20");
    CHECK(altered("powers 1 2", "powers 1") ==
          "syntax, 8: found nothing, expected an integer from 1 to 20");
    CHECK(altered(" 61 -54 32", " 61 -54") ==
          "syntax, 7: found nothing, expected an integer from -999999999 to 999999999");
    std::string many = six_points;
    for (int i = 0; i < 98; ++i)
        many = with(many, "powers", last + "powers");
    CHECK(contains(outcome(many), "found `view`, expected `powers`"));
}

/// A record of many free lines in two views, which further images have, too.
static std::string record_of_lines(int lines, int cubics, int linear) {
    std::string record = say("problem projective: 7*P/P + ", lines, "*a/a\n");
    for (int view = 0; view < 3; ++view) {
        record += "view";
        for (int i = 0; i < 21 + 6 * lines; ++i)
            record += say(' ', (i * i * 7 + view * 31 + i + 5) % 83 + 1);
        record += '\n';
    }
    return record + say("powers ", cubics, ' ', linear, '\n');
}

TEST_CASE("a record of many lines is refused in few steps, whatever its powers") {
    for (const auto& [cubics, linear] : {std::pair{1, 1}, {20, 20}, {20, 1}, {1, 20}, {5, 5}})
        for (const int lines : {10, 20, 100}) {
            CAPTURE(lines);
            CHECK(contains(outcome(record_of_lines(lines, cubics, linear), 1),
                           "it takes more than 10000 monomials"));
        }
}

TEST_CASE("each record takes an effort of 1 before anything else; after 100 refusals the rest of a "
          "file is not replayed") {
    const std::string refused = with(six_points, "powers 1 2", "powers 1 1");
    std::string many;
    for (int i = 0; i < 101; ++i)
        many += refused;
    CHECK(contains(outcome(many, 99), "more effort than allowed"));
    const ReplayedFile file = replay(
        all_classes(), "file", "plcert 2 at-most\n" + many + six_points, Execution{.effort = 100});
    const auto& content = std::get<AtMostFile>(file.content);
    CHECK(content.refusals.count == 102);
    CHECK(content.bounds.empty());
    // Many lines that are refused before there are monomials take no less.
    const std::string lines = record_of_lines(20, 1, 1);
    CHECK(contains(outcome(lines + lines, 1), "more effort than allowed"));
}

TEST_CASE("the effort is that of the monomials; with less, nothing of the file counts") {
    CHECK(outcome(six_points + six_points, 2) == "3, 3");
    CHECK(contains(outcome(six_points + six_points, 1), "more effort than allowed"));
    CHECK(contains(outcome(six_points, 0), "more effort than allowed"));
}
