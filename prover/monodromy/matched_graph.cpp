#include "prover/monodromy/matched_graph.h"

#include <algorithm>
#include <utility>

namespace plprove {

namespace {

std::size_t index(int number) {
    return static_cast<std::size_t>(number);
}

} // namespace

int MatchedGraph::state(int edge, int node, int solution) const {
    const std::vector<int>& partners = edges_[index(edge)].partner[index(node)];
    return index(solution) < partners.size() ? partners[index(solution)] : open;
}

int& MatchedGraph::partner(int edge, int node, int solution) {
    std::vector<int>& partners = edges_[index(edge)].partner[index(node)];
    if (partners.size() <= index(solution)) partners.resize(index(solution) + 1, open);
    return partners[index(solution)];
}

std::vector<int> MatchedGraph::unfollowed(Direction direction, int known, int most) const {
    std::vector<int> result;
    for (int i = 0; i < known && std::ssize(result) < most; ++i)
        if (state(direction.edge, direction.from, i) == open) result.push_back(i);
    return result;
}

void MatchedGraph::match(Direction direction, int start, std::optional<int> end) {
    const auto [edge, from] = direction;
    std::vector<int>& doubtful = edges_[index(edge)].doubtful[index(from)];
    partner(edge, from, start) = lost;
    if (!end) {
        doubtful.push_back(start);
        return;
    }
    int& theirs = partner(edge, direction.to(), *end);
    if (theirs == disputed) {
        doubtful.push_back(start);
    } else if (theirs >= 0 && theirs != start) {
        doubtful.push_back(start);
        doubtful.push_back(theirs);
        partner(edge, from, theirs) = lost;
        theirs = disputed;
    } else {
        theirs = start;
        partner(edge, from, start) = *end;
    }
}

bool MatchedGraph::match_again(Direction direction, int start, std::optional<int> end) {
    const auto [edge, from] = direction;
    if (!end || is_matched(direction, *end)) return false;
    partner(edge, direction.to(), *end) = start;
    partner(edge, from, start) = *end;
    return true;
}

std::vector<int> MatchedGraph::take_doubtful(Direction direction) {
    std::vector<int> result;
    std::vector<int>& doubtful = edges_[index(direction.edge)].doubtful[index(direction.from)];
    for (const int start : std::exchange(doubtful, {}))
        if (state(direction.edge, direction.from, start) == lost &&
            std::ranges::find(result, start) == result.end())
            result.push_back(start);
    return result;
}

bool MatchedGraph::is_matched(Direction direction, int end) const {
    return state(direction.edge, direction.to(), end) >= 0;
}

int MatchedGraph::matched(int edge) const {
    return static_cast<int>(std::ranges::count_if(edges_[index(edge)].partner[0],
                                                  [](int partner) { return partner >= 0; }));
}

int MatchedGraph::complete_edges(int first, int second) const {
    int complete = 0;
    for (int edge = 0; edge < edges(); ++edge)
        complete += first == second && matched(edge) == first;
    return complete;
}

std::optional<std::vector<int>> MatchedGraph::bijection(int edge, int count) const {
    if (edges_[index(edge)].has_detour || matched(edge) != count) return std::nullopt;
    return edges_[index(edge)].partner[0];
}

} // namespace plprove
