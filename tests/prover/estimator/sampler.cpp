// Which matches make a sample, and which problems the matches offer.
#include "prover/estimator/sampler.h"

#include "prover/estimator/choices.h"
#include "prover/problem/notation.h"
#include "scene.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <set>

using namespace plprove;

namespace {

std::vector<std::string> offered(const Matches& matches) {
    std::vector<std::string> result;
    for (const Choice& choice : choices(matches))
        result.push_back(notation(choice.problem));
    return result;
}

bool has(const std::vector<std::string>& words, const std::string& word) {
    return std::ranges::find(words, word) != words.end();
}

} // namespace

TEST_CASE("a sample has different matches, and pins pass through their points only") {
    Matches matches = scene(6, 3, 0, 1).matches;
    // A line through two points is a pin of one of them only where the other is not in the sample.
    matches.lines_through[0] = {0, 1};
    matches.lines_through[1] = {1};
    const Features problem = parse_features("2*Pa/Pa/Pa + P/P/P + a/a/a");
    const Sampler sampler(problem, matches);
    std::set<std::size_t> first_points;
    for (std::uint64_t number = 0; number < 200; ++number) {
        const auto sample = sampler.draw(7, number);
        REQUIRE(sample);
        std::set<std::size_t> points, lines;
        for (std::size_t f = 0; f < problem.size(); ++f) {
            if (problem[f].has_point) points.insert((*sample)[f].point);
            lines.insert((*sample)[f].lines.begin(), (*sample)[f].lines.end());
        }
        CHECK(points.size() == 3);
        CHECK(lines.size() == 3);
        for (std::size_t f = 0; f < problem.size(); ++f)
            for (const std::size_t line : (*sample)[f].lines)
                for (const std::size_t point : points) {
                    const bool passes =
                        std::ranges::binary_search(matches.lines_through[point], line);
                    CHECK(passes == (problem[f].has_point && point == (*sample)[f].point));
                }
        first_points.insert((*sample)[0].point);
    }
    CHECK(first_points.size() == 6);
    CHECK(sampler.draw(7, 3)->at(0).point == sampler.draw(7, 3)->at(0).point);
}

TEST_CASE("a view that misses a point is no view of the sample's point") {
    Matches matches = scene(5, 0, 0, 1).matches;
    matches.points[3][2].reset();
    matches.points[4][2].reset();
    const Features problem = parse_features("3*P/P/P + 2*P/P/-");
    for (std::uint64_t number = 0; number < 20; ++number) {
        const auto sample = Sampler(problem, matches).draw(1, number);
        REQUIRE(sample);
        for (std::size_t f = 0; f < 3; ++f)
            CHECK((*sample)[f].point < 3);
    }
    CHECK(!Sampler(parse_features("4*P/P/P"), matches).draw(1, 0));
}

TEST_CASE("matches offer the problems for which they have samples") {
    Matches matches = scene(5, 0, 0, 1).matches;
    auto names = offered(matches);
    CHECK(names.front() == "3*P/P/P + 2*P/P/-");
    CHECK(has(names, "P/P/P + 2*Pa/Pa/Pa"));
    CHECK(has(names, "P/P/P + 4*a/a/a"));
    // Five points, two of them in views 2 and 3 only.
    matches.points[3][0].reset();
    matches.points[4][0].reset();
    for (auto& line : matches.lines)
        line[0].reset();
    names = offered(matches);
    CHECK(names == std::vector<std::string>{"3*P/P/P + 2*-/P/P"});
    // Three points and a line through each.
    matches = scene(3, 0, 0, 1).matches;
    names = offered(matches);
    CHECK(names.front() == "P/P/P + 2*Pa/Pa/Pa");
    // Without incidences a line may pass through none of the points that are sampled.
    for (auto& lines : matches.lines_through)
        lines.clear();
    CHECK(offered(matches).front() == "3*P/P/P + a/a/a");
    CHECK(offered(scene(2, 0, 0, 1).matches).empty());
}

TEST_CASE("two views offer five points") {
    Matches matches = scene(5, 0, 0, 1).matches;
    matches.intrinsics.pop_back();
    for (auto& point : matches.points)
        point.pop_back();
    for (auto& line : matches.lines)
        line.pop_back();
    CHECK(offered(matches) == std::vector<std::string>{"5*P/P"});
    matches.points.pop_back();
    matches.lines_through.pop_back();
    CHECK(offered(matches).empty());
}
