// Reduction: the rows of the paper's table of all ways to observe a feature, the completeness of
// the 27, and the ways to name a problem.
#include "prover/problem/reduction.h"
#include "prover/problem/signature.h"
#include "prover/problem/spec.h"

#include <doctest/doctest.h>
#include <map>
#include <set>

using namespace plprove;

namespace {

std::string reduced(const std::string& text) {
    const Features problem = reduce(parse_features(text)).reduced;
    return problem.empty() ? "nothing" : notation(canonical(problem.front()));
}

/// Every way in which `views` views can see a feature, pins renamed at will: calls visit(feature)
/// for each.
template <class Visit>
void for_each_observation(int views, bool has_point, int lines, Visit visit) {
    // A line is known by the set of views that see it; the sets ascend, since names do not matter.
    const int sets = 1 << views;
    for (int points = 0; points < (has_point ? sets : 1); ++points) {
        std::vector<int> seen_by(static_cast<std::size_t>(lines), 0);
        while (true) {
            Feature feature{has_point, lines, std::vector<Sight>(static_cast<std::size_t>(views))};
            bool admissible = true;
            for (int view = 0; view < views; ++view) {
                Sight& sight = feature.sights[static_cast<std::size_t>(view)];
                sight.point = (points >> view & 1) != 0;
                for (int line = 0; line < lines; ++line)
                    if ((seen_by[static_cast<std::size_t>(line)] >> view & 1) != 0)
                        sight.pins |= 1U << line;
                // Definition 1: who sees two lines sees the point.
                admissible = admissible && (sight.point || (sight.pins & (sight.pins - 1)) == 0);
            }
            if (admissible) visit(feature);
            // The next ascending sequence.
            int last = lines - 1;
            while (last >= 0 && seen_by[static_cast<std::size_t>(last)] == sets - 1)
                --last;
            if (last < 0) break;
            const int next = seen_by[static_cast<std::size_t>(last)] + 1;
            for (int line = last; line < lines; ++line)
                seen_by[static_cast<std::size_t>(line)] = next;
        }
    }
}

std::string canonical_text(const char* text) {
    return notation(canonical(parse_feature(text)));
}

} // namespace

TEST_CASE("the rows of the paper's table reduce as it says") {
    const std::map<std::string, std::string> rows{
        {"a/-/-", "nothing"},
        {"a/a/-", "nothing"},
        {"a/a/a", "a/a/a"},
        {"P/-/-", "nothing"},
        {"P/P/-", "P/P/-"},
        {"P/P/P", "P/P/P"},
        {"P/a/-", "nothing"},
        {"P/P/a", "P/P/a"},
        {"P/a/a", "P/a/a"},
        {"Pa/a/-", "nothing"},
        {"Pa/P/a", "Pa/P/a"},
        {"Pa/a/a", "a/a/a"},
        {"Pa/Pa/a", "Pa/Pa/a"},
        {"Pa/Pa/Pa", "Pa/Pa/Pa"},
        {"Pa/Pa/P", "P/P/P"},
        {"Pa/-/-", "nothing"},
        {"Pa/P/-", "P/P/-"},
        {"Pa/Pa/-", "P/P/-"},
        {"a/a/a(P)", "a/a/a"},
        {"a/a/-(P)", "nothing"},
        {"a/b/-", "nothing"},
        {"a/b/b", "nothing"},
        {"-/-/-(P)", "nothing"},
        {"-/-/-(a)", "nothing"},
        {"P/P/P(a)", "P/P/P"},
        {"Pab/Pab/Pab", "Pab/Pab/Pab"},
        {"Pab/Pab/a", "Pa/Pa/a"},
        {"Pabc/a/b", canonical_text("Pab/a/b")},
        {"P/a/b", canonical_text("P/a/b")},
        {"Pa/a/b", canonical_text("Pa/a/b")},
    };
    for (const auto& [text, expected] : rows) {
        CAPTURE(text);
        CHECK(reduced(text) == expected);
    }
}

TEST_CASE(
    "three views: every observation of a feature with up to 8 pins reduces to one of the 27, to a "
    "feature with dangling pins (Theorem 5), to a star with 8 pins, or to nothing") {
    std::set<Feature> standard;
    for (const Feature& feature : standard_features())
        standard.insert(canonical(feature));
    std::set<Feature> irreducible;
    std::size_t observations = 0;
    const auto visit = [&](const Feature& feature) {
        ++observations;
        for (const Feature& result : reduce({feature}).reduced) {
            CHECK_FALSE(reduce_once(result));
            irreducible.insert(canonical(result));
        }
    };
    for_each_observation(3, false, 1, visit);
    for (int pins = 0; pins <= 8; ++pins)
        for_each_observation(3, true, pins, visit);
    CHECK(observations > 10000);

    std::set<Feature> expected = standard;
    expected.insert(canonical(parse_feature("Pabcdefgh/Pabcdefgh/Pabcdefgh")));
    // Theorem 5, in all labelings of the views: both pins dangling, one of two, the only one.
    for (const char* text : {"P/b/a", "b/P/a", "b/a/P", "Pa/b/a", "Pa/a/b", "b/Pa/a", "a/Pa/b",
                             "b/a/Pa", "a/b/Pa", "P/P/a", "P/a/P", "a/P/P"})
        expected.insert(canonical(parse_feature(text)));
    CHECK(irreducible == expected);

    for (const Feature& feature : irreducible) {
        CAPTURE(notation(feature));
        if (feature.lines == 8) continue;
        CHECK(standard.contains(canonical(lifted(feature))));
        CHECK(canonical(lifted(terminal(feature))).has_point == feature.has_point);
        CHECK(terminal(terminal(feature)) == terminal(feature));
    }
}

TEST_CASE("two views: every observation with up to 8 pins reduces to P/P or to nothing") {
    const auto visit = [](const Feature& feature) {
        for (const Feature& result : reduce({feature}).reduced)
            CHECK(notation(result) == "P/P");
    };
    for_each_observation(2, false, 1, visit);
    for (int pins = 0; pins <= 8; ++pins)
        for_each_observation(2, true, pins, visit);
}

TEST_CASE("reduction does not depend on labels of views or names of pins") {
    const auto visit = [](const Feature& feature) {
        const int order[] = {2, 0, 1};
        const Features direct = reduce({feature}).reduced;
        const Features turned = reduce({relabel_views(feature, order)}).reduced;
        REQUIRE(direct.size() == turned.size());
        if (!direct.empty())
            CHECK(canonical(relabel_views(direct.front(), order)) == canonical(turned.front()));
        const Features renamed = reduce({canonical(feature)}).reduced;
        CHECK(renamed.size() == direct.size());
        if (!direct.empty()) CHECK(canonical(renamed.front()) == canonical(direct.front()));
    };
    for (int pins = 0; pins <= 5; ++pins)
        for_each_observation(3, true, pins, visit);
}

TEST_CASE("a problem is known by notation, number, signature and Macaulay2 encoding") {
    const Features chicago = parse_features("2*Pa/Pa/Pa + P/P/P");
    CHECK(parse_spec("#2394") == chicago);
    CHECK(parse_spec("2394") == chicago);
    CHECK(parse_spec("{0,0,0,0,0,0,2,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0}") == chicago);
    CHECK(parse_spec("0 0 0 0 0 0 2 1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0") == chicago);
    CHECK(parse_spec("{{0,1},{{{1,1},{1,1,1}},{{1,1},{1,1,1}},{{1,1},{1,1,1}}}}") == chicago);
    // The example of the authors' documentation: problem 7.
    const Features seven =
        parse_spec("{{1,2,2,2,2,2,2},{{{0,1,1,1,1,1,1},{0,1,1}},{{1,1,1,1,1,1,1},{1,0,1}},"
                   "{{1,1,1,1,1,1,1},{1,0,1}}}}");
    const auto signature = signature_of(seven);
    REQUIRE(signature);
    CHECK(class_number(label_classes(), representative(*signature)) == 7);
    // Free lines, an unseen line and an unseen point.
    CHECK(notation(parse_spec("{{-1,0},{{{1,0},{1,0}},{{1,0},{1,0}},{{1,0},{1,0}}}}")) ==
          "P/P/P(a) + -/-/-(P) + a/a/a");
}

TEST_CASE("malformed specifications are refused with a column") {
    const std::map<std::string, std::string> refused{
        {"", "column 1: expected a problem"},
        {"#143494", "column 2: expected the number of a label class, 0 to 143493"},
        {"#12x", "column 2"},
        {"{1,2,3}", "27 numbers, found 3"},
        {"{{0},{{{1},{1}},{{1},{1}}}", "expected ',' or '}'"},
        {"{{0},{{{1},{1}},{{1},{1}},{{1,1},{1}}}}", "expected 1 entries, one a line"},
        {"{{1},{{{1},{1}},{{1},{1}},{{1},{1}}}}", "there are only 1 points"},
        {"{{0,0},{{{1,1},{0}},{{1,1},{1}},{{1,1},{1}}}}", "Definition 1"},
        {"{{0},{{{2},{1}},{{1},{1}},{{1},{1}}}}", "0 or 1 for each line"},
        {"{{{{{{{{{{{{", "nested too deeply"},
        {"{{},{{{},{}},{{},{}},{{},{}}}}", "at least one point or line"},
        {"P/P/P(", "what no view sees, 'P' or letters of lines, and ')'"},
        {"-/-/-", "'(P)' for a point"},
    };
    for (const auto& [text, reason] : refused) {
        CAPTURE(text);
        try {
            parse_spec(text);
            FAIL("accepted");
        } catch (const NotationError& error) {
            CAPTURE(error.what());
            CHECK(std::string(error.what()).find(reason) != std::string::npos);
        }
    }
}
