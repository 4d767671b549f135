// The bookkeeping of monodromy: which solution of one node leads to which of the other, along each
// of several edges. Solutions are integers here, so nothing depends on how paths are followed.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace plprove {

/// An edge, and from which of its two nodes it is followed.
struct Direction {
    int edge = 0;
    int from = 0;

    int to() const { return 1 - from; }
};

/// Two nodes, 0 and 1, whose solutions are numbered from 0; and edges between them. Each edge maps
/// the solutions of one node to those of the other one to one.
class MatchedGraph {
public:
    int edges() const { return static_cast<int>(edges_.size()); }
    void add_edge() { edges_.emplace_back(); }

    /// The first solutions, at most `most` of the `known` ones, that have neither been followed in
    /// this direction nor been reached from the other node.
    std::vector<int> unfollowed(Direction direction, int known, int most) const;

    /// The path of `start` leads to `end`, or is lost. A lost path is in doubt; so are two that
    /// have the same end, as one of them must have jumped: both are matched no more.
    void match(Direction direction, int start, std::optional<int> end);

    /// The same of a path that was in doubt and has been followed again, more carefully. If its end
    /// has a partner, that one stays. Whether the start is matched now.
    bool match_again(Direction direction, int start, std::optional<int> end);

    /// The starts in doubt that have not been matched since; they are no longer in doubt then.
    std::vector<int> take_doubtful(Direction direction);

    /// One of the edge's matches is of another path than the others.
    void mark_detour(int edge) { edges_[static_cast<std::size_t>(edge)].has_detour = true; }

    /// Whether a solution of the node that the direction leads to has a partner.
    bool is_matched(Direction direction, int end) const;

    /// How many solutions of either node have a partner along the edge.
    int matched(int edge) const;

    /// Along how many edges all solutions are matched one to one, if the nodes have these numbers.
    int complete_edges(int first, int second) const;

    /// To which solution of node 1 the edge leads each of the `count` ones of node 0. Nothing if
    /// some have no partner, or if the edge has a detour.
    std::optional<std::vector<int>> bijection(int edge, int count) const;

private:
    enum State : int { open = -1, lost = -2, disputed = -3 };

    struct Edge {
        std::array<std::vector<int>, 2> partner;  ///< of each solution of a node, or a State
        std::array<std::vector<int>, 2> doubtful; ///< starts of paths to follow again
        bool has_detour = false;
    };

    int state(int edge, int node, int solution) const;
    int& partner(int edge, int node, int solution);

    std::vector<Edge> edges_;
};

} // namespace plprove
