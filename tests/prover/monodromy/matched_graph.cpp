// The bookkeeping of monodromy, with integers in the place of solutions.
#include "prover/monodromy/matched_graph.h"

#include <doctest/doctest.h>

using namespace plprove;

namespace {

constexpr int many = 1000;
constexpr Direction forth{0, 0}, back{0, 1};
using Starts = std::vector<int>;

MatchedGraph with_one_edge() {
    MatchedGraph graph;
    graph.add_edge();
    return graph;
}

} // namespace

TEST_CASE("solutions are followed once, and not back from where they lead") {
    MatchedGraph graph = with_one_edge();
    CHECK(graph.unfollowed(forth, 3, many) == Starts{0, 1, 2});
    CHECK(graph.unfollowed(forth, 3, 2) == Starts{0, 1});
    graph.match(forth, 0, 4);
    graph.match(forth, 1, std::nullopt);
    CHECK(graph.unfollowed(forth, 3, many) == Starts{2});
    CHECK(graph.unfollowed(back, 5, many) == Starts{0, 1, 2, 3});
    CHECK(graph.matched(0) == 1);
    CHECK(graph.is_matched(forth, 4));
    CHECK(!graph.is_matched(forth, 3));
    // Another edge knows nothing of that.
    graph.add_edge();
    CHECK(graph.unfollowed({1, 0}, 3, many) == Starts{0, 1, 2});
}

TEST_CASE("a lost path is in doubt until it is matched, from either end") {
    MatchedGraph graph = with_one_edge();
    graph.match(forth, 0, std::nullopt);
    graph.match(forth, 1, std::nullopt);
    graph.match(back, 7, 1);
    CHECK(graph.take_doubtful(forth) == Starts{0});
    CHECK(graph.take_doubtful(forth).empty());
    CHECK(!graph.match_again(forth, 0, std::nullopt));
    CHECK(graph.match_again(forth, 0, 3));
    CHECK(graph.matched(0) == 2);
}

TEST_CASE("all paths that share an end are in doubt, however many there are") {
    MatchedGraph graph = with_one_edge();
    graph.match(forth, 0, 5);
    graph.match(forth, 1, 5);
    graph.match(forth, 2, 5);
    CHECK(graph.matched(0) == 0);
    CHECK(graph.unfollowed(forth, 3, many).empty());
    CHECK(graph.take_doubtful(forth) == Starts{1, 0, 2});
    CHECK(graph.match_again(forth, 1, 5));
    CHECK(!graph.match_again(forth, 0, 5)); // the partner stays
    CHECK(graph.match_again(forth, 2, 6));
    CHECK(graph.matched(0) == 2);
    CHECK(graph.is_matched(back, 1));
    CHECK(!graph.is_matched(back, 0));
}
