// Degrees that are known by other means, and results that threads do not change.
#include "prover/many_views/monodromy.h"

#include "prover/problem/notation.h"

#include <doctest/doctest.h>

using namespace plprove;
using namespace plprove::many_views;

namespace {

MonodromyResult found(const std::string& text, int edges, int threads = 2) {
    MonodromySettings settings;
    settings.edges = settings.edges_of_few = edges;
    settings.threads = threads;
    const MonodromyResult result = run_monodromy(parse_problem(text), 1, settings);
    CHECK(result.edges == edges);
    return result;
}

} // namespace

TEST_CASE("monodromy finds degrees that are known") {
    // Ten essential matrices with two rotations each.
    CHECK(found("5*P/P", 5).solutions == 20);
    // A cubic: det = 0 on a pencil of fundamental matrices (M. Chasles, 1855).
    CHECK(found("projective: 7*P/P", 5).solutions == 3);
    // Cleveland, as the three-view engine has it (certs/degrees.csv).
    CHECK(found("3*P/P/P + a/a/a", 3).solutions == 216);
}

TEST_CASE("monodromy finds degrees that Groebner bases have") {
    // tests/families/groebner.py
    CHECK(found("upright: 3*P/P", 16).solutions == 4);
    CHECK(found("upright-shared-focal: 2*P/P/P + a/a/a", 16).solutions == 11);
    CHECK(found("shared-focal: 3*PL/PL + 3*P/P", 16).solutions == 20);
}

TEST_CASE("monodromy finds the other half where its first edges lead one half to itself") {
    // Three edges of this seed lead half of the 60 to itself.
    CHECK(found("focal: 2*P/P/P + Pabcde/Pabcde/Pabcde", 3).solutions == 60);
}

TEST_CASE("no path is lost where doubles have too few digits") {
    // In doubles alone some ways lose paths.
    CHECK(found("shared-focal: 3*PL/PL/PL + Pa/Pa/Pa", 3).solutions == 168);
}

TEST_CASE("no solution is taken for one without cameras") {
    // Some of these have a rotation that is nearly null, or very different focal lengths.
    const Problem problem = parse_problem("upright-focal: Pa/Pa/Pa + 3*a/a/a");
    for (const std::uint64_t seed : {0U, 1U, 2U}) {
        const MonodromyResult result = run_monodromy(problem, seed, {});
        CHECK(result.solutions == 60);
        CHECK(result.complete());
    }
}

TEST_CASE("the symmetries of a system divide the number of solutions that monodromy finds") {
    // Two views of points: the solutions with the same essential matrix come in pairs.
    for (const char* text : {"2*PL/PL + 2*P/P + PL/PL", "PLM/PLM + 2*PL/PL + 2*PM/PM"})
        CHECK(found(text, 4).solutions % 2 == 0);
}

TEST_CASE("problems with few solutions are followed along more ways") {
    // With five ways, one of these two solutions is missing for this seed.
    const Problem problem = parse_problem("projective: 2*P/P/P + Pabcde/Pabcde/Pabcde + 2*a/a/a");
    const MonodromyResult result = run_monodromy(problem, 1, {});
    CHECK(result.ways == 16);
    CHECK(result.edges == 16);
    CHECK(result.solutions == 2);
}

TEST_CASE("threads do not change what monodromy finds") {
    const MonodromyResult one = found("5*P/P", 3, 1);
    const MonodromyResult three = found("5*P/P", 3, 3);
    REQUIRE(one.points.size() == three.points.size());
    for (std::size_t i = 0; i < one.points.size(); ++i)
        CHECK((one.points[i] - three.points[i]).norm() == 0);
    CHECK(one.paths == three.paths);
}

TEST_CASE("monodromy stops when it knows more solutions than wanted") {
    MonodromySettings settings;
    settings.most_solutions = 10;
    const MonodromyResult result = run_monodromy(parse_problem("3*P/P/P + a/a/a"), 1, settings);
    CHECK(result.solutions > 10);
    CHECK(result.solutions < 216);
    CHECK(!result.complete());
}
