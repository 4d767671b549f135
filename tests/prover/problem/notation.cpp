// The notation for problems in general: what it means, that it is read as it is written, and what
// is refused.
#include "prover/problem/notation.h"
#include "prover/problem/spec.h"
#include "tests/prover/minimal/random_arrangements.h"
#include "tests/support/construction.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <tuple>

using namespace plprove;

namespace {

std::string refusal(const std::string& text) {
    try {
        parse_problem(text);
    } catch (const NotationError& error) {
        return error.what();
    }
    return "";
}

/// What an isomorphism keeps, in an order that does not depend on the numbers.
auto invariants(const Problem& problem) {
    std::vector<std::vector<ViewSet>> lines;
    for (const Line& line : problem.lines) {
        lines.push_back({line.seen});
        for (const int point : line.points)
            lines.back().push_back(problem.points[static_cast<std::size_t>(point)]);
        std::sort(lines.back().begin() + 1, lines.back().end());
    }
    std::ranges::sort(lines);
    std::vector<ViewSet> points = problem.points;
    std::ranges::sort(points);
    return std::tuple(problem.cameras, problem.views, points, lines, dimension_in_space(problem),
                      dimension_in_views(problem));
}

} // namespace

TEST_SUITE_BEGIN("problems in general: notation");

TEST_CASE("what the notation means") {
    const Problem collinear = parse_problem("3*PL/PL/PL");
    CHECK(collinear.points == std::vector<ViewSet>{7, 7, 7});
    CHECK(collinear.lines == std::vector<Line>{{{0, 1, 2}, 7}});
    CHECK(dimension_in_space(collinear) == 7);
    CHECK(dimension_in_views(collinear) == 15);

    const Problem pins = parse_problem("projective: 2*Pab/Pa/P/a(c) + a/a/-/-");
    CHECK(pins.cameras == &projective_cameras);
    CHECK(pins.points == std::vector<ViewSet>{7, 7});
    CHECK(pins.lines ==
          std::vector<Line>{{{0}, 11}, {{0}, 1}, {{0}, 0}, {{1}, 11}, {{1}, 1}, {{1}, 0}, {{}, 3}});

    // Unseen points: mentioned, or the meet of two lines.
    CHECK(parse_problem("-/-(P)").points == std::vector<ViewSet>{0});
    CHECK(parse_problem("a/b").points == std::vector<ViewSet>{0});
    CHECK(parse_problem("a/a").points.empty());
}

TEST_CASE("dimensions do not depend on the order of the points") {
    const Problem one = parse_problem("2*PL/PL + PL/PL + PLM/PLM + PM/PM + PM/PM");
    const Problem other = parse_problem("2*PM/PM + PLM/PLM + PL/PL + 2*PL/PL");
    CHECK(invariants(one) == invariants(other));
    CHECK(is_constructible_in_order(other));
    // Point 3 of the first text lies on two lines through earlier points: the points are put in
    // another order.
    const Problem crossing = parse_problem("2*PL/PL + 2*PM/PM + PLM/PLM");
    CHECK(is_constructible_in_order(crossing));
    CHECK(dimension_in_space(crossing) == 3 * 5 - 2 * 2);
}

TEST_CASE("what is written is read as the same problem") {
    RandomArrangements random(24);
    for (int i = 0; i < 500; ++i) {
        const Problem problem = random.problem();
        const std::string text = notation(problem);
        CAPTURE(text);
        const Problem again = parse_problem(text);
        CHECK(invariants(again) == invariants(problem));
        CHECK(notation(parse_problem(notation(again))) == notation(again));
    }
}

TEST_CASE("what cannot be is refused, with what to write instead") {
    const std::pair<const char*, const char*> refused[] = {
        {"P", "expected '/'"},
        {"P/P + foo", "column 7: 'foo' is no feature: write what each view sees"},
        {"", "found the end, expected what a view sees"},
        {"P/P + P/P/P", "column 7: found 3 views, expected 2"},
        {"P/P/P/P/P/P/P/P/P/P/P/P/P", "expected at most 12 views"},
        {"PL/P/PL + PL/P/PL", "view 2 sees point 1 and point 2, so it sees the line through them"},
        {"PL/P/PL + PL/PL/PL", "write L in the same views at each of its points"},
        {"2*PLM/PLM", "point 1 and point 2 lie on two lines"},
        {"Pab/ab", "expected 'P' before two lines"},
        {"PL/PL/PL + L/PL/PL + PLM/PLM/PLM + M/PM/PM + PMNA/PMNA/PMNA", "in alphabetical order"},
        {"PLM/PLM + PLN/PLN + PLO/PLO + PMN/PMN + PMO/PMO + PNO/PNO", "leave out a point"},
        {"L/L/L", "write a small letter for a line that meets no point"},
        {"PL/PL + PM/PM + PM/PM", "the line L has only one point: write a small letter"},
        {"P/P(P)", "leave out '(P)'"},
        {"Pa/P(a)", "leave it out there"},
        {"-/-", "nothing is in this feature"},
        {"Pba/P", "alphabetical order"},
        {"0*P/P", "a multiplicity from 1 to 1000"},
        {"P/P + ", "found the end"},
        {"101*P/P", "at most 100 points"},
        {"P/P\xc3\xa9", "U+00E9 (no ASCII)"},
    };
    for (const auto& [text, message] : refused) {
        CAPTURE(text);
        CHECK(refusal(text).find(message) != std::string::npos);
    }
}

TEST_CASE("any text is a problem, or refused with a message") {
    RandomArrangements random(26);
    const std::string letters = "PLMabc/-+*()0123: projective";
    int problems = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text = notation(random.problem());
        for (int edits = random.below(4); edits > 0; --edits) {
            const auto place =
                static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
            const char letter =
                letters[static_cast<std::size_t>(random.below(static_cast<int>(letters.size())))];
            if (random.below(2) == 0)
                text[place] = letter;
            else
                text.erase(place, 1);
        }
        CAPTURE(text);
        try {
            const Problem problem = parse_problem(text);
            CHECK(is_constructible_in_order(problem));
            CHECK(dimension_in_space(problem) >= 0);
            ++problems;
        } catch (const NotationError& error) {
            CHECK(std::string(error.what()).size() > 10);
        }
    }
    CHECK(problems > 5000);
    CHECK(problems < 19000);
}

TEST_CASE("PLMP's encoding and names") {
    const auto spec = [](const char* text) { return notation(*parse_general_spec(text)); };
    CHECK(spec("(5,0,{})") == "5*P/P");
    CHECK(spec("(3, 1, {})") == "3*P/P/P + a/a/a");
    CHECK(spec("(1,2,{{0}})") == spec("1021_1"));
    CHECK(spec("(5,0,{{0,1,2,3}},2)") == "4*PL/PL + P/P");
    CHECK(spec("projective: (6,0,{},3)") == "projective: 6*P/P/P");
    CHECK(spec("5000_2") == "5*P/P");
    CHECK_FALSE(parse_general_spec("3002_1")); // names.h has it
    CHECK_FALSE(parse_general_spec("9999_9"));
    CHECK_FALSE(parse_general_spec("Chicago"));
    CHECK_FALSE(parse_general_spec("2*Pa/Pa/Pa + P/P/P"));
    for (const char* wrong :
         {"(5,0,{{0,5}})", "(5,0", "(5,0,{}) x", "(0,0,{},3)", "(5,0,{{0,0}})", "(4,0,{})",
          "(3,0,{{0,1},{1,0}},3)", "(1,1,{},1)", "(5,100,{{0,4},{0,2}},3)"}) {
        CAPTURE(wrong);
        CHECK_THROWS_AS(parse_general_spec(wrong), NotationError);
    }
}

TEST_SUITE_END();
