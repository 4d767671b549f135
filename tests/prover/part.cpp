// Which problems contain which features, by a second method: multisets of features.
#include "prover/catalogue/part.h"

#include "prover/catalogue/spelling.h"
#include "prover/minimal/obstruction.h"
#include "prover/problem/reduction.h"

#include <algorithm>
#include <doctest/doctest.h>

using namespace plprove;

namespace {

bool one_contains(const Signature& problem, const std::vector<Part>& parts) {
    return std::ranges::any_of(parts, [&](const Part& part) { return contains(problem, part); });
}

bool one_has_all_of(const Signature& problem, const std::vector<Part>& parts) {
    return std::ranges::any_of(parts,
                               [&](const Part& part) { return is_contained(problem, part); });
}

Features sorted(const Features& problem) {
    Features result;
    for (const Feature& feature : problem)
        result.push_back(canonical(feature));
    std::ranges::sort(result);
    return result;
}

/// The problem with a dangling pin fixed in the one or the other view that sees its point: all
/// ways to fix all of them.
std::vector<Features> all_fixed(const Features& problem) {
    std::vector<Features> found{{}};
    for (const Feature& feature : problem) {
        std::vector<Feature> ways{lifted(feature)};
        if (feature.lines == 1 && lifted(feature) != feature) {
            Feature other = feature;
            for (std::size_t view = 0; view < other.sights.size(); ++view)
                if (other.sights[view].point && lifted(feature).sights[view].pins == 0)
                    other.sights[view].pins = 1;
            ways.push_back(other);
        }
        std::vector<Features> longer;
        for (const Features& start : found)
            for (const Feature& way : ways) {
                longer.push_back(start);
                longer.back().push_back(way);
            }
        found = longer;
    }
    return found;
}

/// Whether some order of the views and some way to fix pins makes `inner` a part of `outer`.
template <class Test>
bool in_some_order(const Features& spec, Test test) {
    std::array<int, 3> views{0, 1, 2};
    do {
        Features relabeled;
        for (const Feature& feature : spec)
            relabeled.push_back(relabel_views(feature, views));
        for (const Features& fixed : all_fixed(relabeled))
            if (test(sorted(fixed))) return true;
    } while (std::ranges::next_permutation(views).found);
    return false;
}

} // namespace

TEST_CASE("a problem contains what is among its features in some order of the views") {
    for (const std::string spec :
         {"P/P/P", "2*Pa/Pa/Pa + -/P/P", "P/P/a", "2*P/P/a + Pa/P/a", "a/P/P + P/P/a + P/Pa/a",
          "P/b/a + 2*P/a/a", "-/P/P + 2*P/-/P + 3*P/P/-", "2*a/a/a"}) {
        CAPTURE(spec);
        const Features problem = parse_features(spec);
        const std::vector<Part> parts = parse_part(spec);
        std::size_t found = 0;
        bool alike = true;
        for (std::size_t number = 0; number < label_classes().size(); ++number) {
            const Signature& signature = label_classes()[number];
            // Some are too rare to be met at random.
            const bool answer = one_contains(signature, parts);
            const bool chosen = number % 61 == 0 || (answer && found < 50);
            if (!chosen) continue;
            const Features whole = sorted(problem_of(signature));
            const bool expected = in_some_order(
                problem, [&](const Features& part) { return std::ranges::includes(whole, part); });
            alike = alike && answer == expected;
            found += expected;
        }
        CHECK(alike);
        CHECK(found > 0);
    }
}

TEST_CASE("a problem is contained where all its features are, in some order of the views") {
    for (const std::string spec :
         {"3*P/P/P + 2*a/a/a + 5*P/P/a", "2*a/a/a + 9*P/a/a + 9*a/a/P",
          "2*P/P/a + 2*P/a/P + a/P/P + 2*P/P/P + a/a/a", "11*-/P/P + 5*P/-/P"}) {
        CAPTURE(spec);
        const Features problem = parse_features(spec);
        const std::vector<Part> parts = parse_part(spec);
        std::size_t found = 0;
        bool alike = true;
        for (std::size_t number = 5; number < label_classes().size(); number += 7) {
            const Signature& signature = label_classes()[number];
            // Too rare to be met at random: try those that may be contained.
            const bool answer = one_has_all_of(signature, parts);
            if (!answer && number % 1001 != 5) continue;
            const Features inner = sorted(problem_of(signature));
            const bool expected = in_some_order(problem, [&](const Features& outer) {
                return std::ranges::includes(outer, inner);
            });
            alike = alike && answer == expected;
            found += expected;
        }
        CHECK(alike);
        CHECK(found > 0);
    }
}

TEST_CASE("each class contains itself and its terminal problem, and is contained in both") {
    for (std::size_t number = 0; number < label_classes().size(); number += 101) {
        CAPTURE(number);
        const Signature& signature = label_classes()[number];
        for (const std::string& spec : {notation(signature), terminal_notation(signature)}) {
            const std::vector<Part> parts = parse_part(spec);
            CHECK(parts.size() == 6);
            CHECK(one_contains(signature, parts));
            CHECK(one_has_all_of(signature, parts));
        }
    }
}

TEST_CASE("what is no part of a class is refused with what to write") {
    for (const char* spec : {"P/P", "a/a/-", "Pabcdefgh/Pabcdefgh/Pabcdefgh", "P/a/- + P/P/P",
                             "5*P/P", "b/a/b", "a/b/a"})
        CHECK_THROWS_WITH_AS(parse_part(spec), doctest::Contains("none of the 27 features"),
                             NotationError);
    CHECK_THROWS_WITH_AS(parse_part("300*P/P/P"), doctest::Contains("at most 255"), NotationError);
    CHECK_THROWS_AS(parse_part("foo"), NotationError);
}
