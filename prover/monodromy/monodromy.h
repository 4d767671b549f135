// Monodromy: all solutions of a system of equations for some images, from a single one, by
// following solutions around loops of images. Two nodes have images; edges join them by different
// paths.
//
// What the equations and images are, and how a path is followed, is up to Loops, which has
//
//     Point                         a solution: a range of complex numbers
//     add_edge()                    makes another path between the images of the nodes
//     follow(direction, starts)     where the paths of these lead: an optional point each
//     attempts                      how many ways there are to follow again what is in doubt
//     follow_again(direction, attempt, starts)     the same, more carefully
//     leads_elsewhere(attempt)      whether this takes another path, which may lead elsewhere
//     refused(node, points, again)  which of these are no solutions for the images of the node
//     companion(point)              another solution that is known with this one, if any
#pragma once

#include "prover/monodromy/matched_graph.h"
#include "prover/monodromy/path_ends.h"
#include "prover/monodromy/progress.h"
#include "prover/monodromy/solution_set.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace plprove {

template <class Loops>
class Monodromy {
public:
    using Point = typename Loops::Point;
    using Report = std::function<void(const MonodromyProgress&)>;

    /// Nothing is known yet. `report`, unless it is empty, is called after some paths each time.
    Monodromy(Loops loops, double near, Report report = {})
        : loops_(std::move(loops)), solutions_{SolutionSet<Point>(near), SolutionSet<Point>(near)},
          report_(std::move(report)) {}

    /// Adds a solution of a node that is not among the known ones, and its companion.
    int add(int node, const Point& point) {
        SolutionSet<Point>& known = solutions_[static_cast<std::size_t>(node)];
        const int index = known.add(point);
        if (const std::optional<Point> other = loops_.companion(point);
            other && !known.find(*other))
            known.add(*other);
        return index;
    }

    /// Where the number is known: follows no more solutions than it takes to know `count` of them
    /// at the first node, along as few edges as will do, `most_edges` in all.
    void reach(int count, int most_edges) {
        while (solutions().size() < count) {
            report();
            if (follow_some(count) || follow_all_doubtful()) continue;
            if (graph_.edges() == most_edges) return;
            add_edge();
        }
        report();
    }

    /// When a run ends whose number of solutions is not known.
    struct Agreement {
        int edges = 0;
        int edges_of_few = 0;   ///< where few solutions are known
        int most_solutions = 0; ///< stops when more are known at the first node
        /// Or at the second one; and then it follows no more paths at a time than are missing.
        bool at_either_node = false;
    };

    /// Where the number is not known: follows all solutions along all edges. A few edges may lead a
    /// part of the solutions to themselves, so it looks along others, too.
    void until_agreed(const Agreement& agreement) {
        constexpr int few = 20;
        do {
            while (graph_.edges() < agreement.edges)
                add_edge();
            for (follow_all(agreement);
                 solutions().size() <= few && graph_.edges() < agreement.edges_of_few;
                 follow_all(agreement))
                add_edge();
        } while (!are_enough(agreement) && find_along_others());
    }

    /// Follows one more edge, or what has not been followed of one, from all solutions of either
    /// node. To which solution of the second node it leads each of the first one; nothing where a
    /// path is lost or takes a detour.
    std::optional<std::vector<int>> follow_edge(int edge) {
        if (edge == graph_.edges()) add_edge();
        for (bool moved = true; moved;) {
            moved = false;
            for (const int from : {0, 1}) {
                if (!follow({edge, from}, std::numeric_limits<int>::max())) continue;
                follow_doubtful({edge, from});
                moved = true;
            }
        }
        const int count = solutions().size();
        return solutions(1).size() == count ? graph_.bijection(edge, count) : std::nullopt;
    }

    /// Those of the first node, or of either.
    const SolutionSet<Point>& solutions() const { return solutions_[0]; }
    const SolutionSet<Point>& solutions(int node) const {
        return solutions_[static_cast<std::size_t>(node)];
    }
    const MatchedGraph& graph() const { return graph_; }
    const Loops& loops() const { return loops_; }
    Loops& loops() { return loops_; }
    /// How many paths were lost, or jumped, for good.
    int lost() const { return lost_; }

private:
    void add_edge() {
        if (graph_.edges() == made_) make_edge();
        graph_.add_edge();
    }

    /// One that the graph does not have yet.
    void make_edge() {
        loops_.add_edge();
        ++made_;
    }

    void report() const {
        if (report_) report_({solutions().size(), graph_.edges()});
    }

    std::vector<Point> points(int node, const std::vector<int>& indices) const {
        std::vector<Point> result;
        for (const int index : indices)
            result.push_back(solutions(node)[index]);
        return result;
    }

    /// Takes the ends away that are new at a node and no solutions there: these paths jumped.
    void refuse(int node, bool again, PathEnds<Point>& ends) const {
        std::vector<std::size_t> indices;
        std::vector<Point> unknown;
        for (std::size_t i = 0; i < ends.size(); ++i)
            if (ends[i] && !solutions(node).find(*ends[i])) {
                indices.push_back(i);
                unknown.push_back(*ends[i]);
            }
        const std::vector<bool> refused = loops_.refused(node, unknown, again);
        for (std::size_t i = 0; i < indices.size(); ++i)
            if (refused[i]) ends[indices[i]].reset();
    }

    /// The index of the end at a node, where it becomes known if it is new.
    std::optional<int> index_of(int node, const std::optional<Point>& end) {
        if (!end) return std::nullopt;
        const std::optional<int> known = solutions(node).find(*end);
        return known ? *known : add(node, *end);
    }

    /// Follows at most `most` solutions that have not been; false if there are none.
    bool follow(Direction direction, int most) {
        const int known = solutions(direction.from).size();
        const std::vector<int> starts = graph_.unfollowed(direction, known, most);
        if (starts.empty()) return false;
        PathEnds<Point> ends = loops_.follow(direction, points(direction.from, starts));
        refuse(direction.to(), false, ends);
        for (std::size_t k = 0; k < starts.size(); ++k)
            graph_.match(direction, starts[k], index_of(direction.to(), ends[k]));
        return true;
    }

    /// Follows what is in doubt again. Whether that found solutions.
    bool follow_doubtful(Direction direction) {
        const std::vector<int> starts = graph_.take_doubtful(direction);
        const std::vector<Point> from = points(direction.from, starts);
        const int before = solutions(direction.to()).size();
        PathEnds<Point> ends(starts.size());
        lost_ += static_cast<int>(starts.size());
        for (int attempt = 0; attempt < Loops::attempts; ++attempt) {
            const auto [open, indices] = without_end(from, ends);
            PathEnds<Point> again = loops_.follow_again(direction, attempt, open);
            refuse(direction.to(), true, again);
            for (std::size_t k = 0; k < indices.size(); ++k) {
                if (!again[k]) continue;
                // Past a branch point another path leads elsewhere: to where the straight one leads
                // another solution, which takes precedence, or where it would lead one that is
                // lost.
                const std::optional<int> known = solutions(direction.to()).find(*again[k]);
                if (loops_.leads_elsewhere(attempt) && known &&
                    graph_.is_matched(direction, *known))
                    continue;
                ends[indices[k]] = again[k];
                if (!graph_.match_again(direction, starts[indices[k]],
                                        index_of(direction.to(), again[k])))
                    continue;
                --lost_;
                if (loops_.leads_elsewhere(attempt)) graph_.mark_detour(direction.edge);
            }
        }
        return solutions(direction.to()).size() > before;
    }

    bool follow_all_doubtful() {
        bool found = false;
        for (int edge = 0; edge < graph_.edges(); ++edge)
            for (const int from : {0, 1})
                found = follow_doubtful({edge, from}) || found;
        return found;
    }

    bool are_enough(const Agreement& agreement) const {
        return solutions().size() > agreement.most_solutions ||
               (agreement.at_either_node && solutions(1).size() > agreement.most_solutions);
    }

    int most_paths(Direction direction, const Agreement& agreement) const {
        if (!agreement.at_either_node) return std::numeric_limits<int>::max();
        return std::max(lanes, agreement.most_solutions + 1 - solutions(direction.to()).size());
    }

    /// Follows solutions along the first edge that has some without a partner; false if none has.
    bool follow_some(int count) {
        const int known = solutions().size();
        // The first edge, and companions, reach nearly all solutions from a few. The others lead to
        // these: so they are followed for some solutions at a time.
        int most = std::max(lanes, (count - known) / 2);
        for (int edge = 0; edge < graph_.edges(); ++edge) {
            for (const int from : {0, 1})
                if (follow({edge, from}, most)) return true;
            most = std::max(lanes, known / 32);
        }
        return false;
    }

    /// Until each solution has been along each edge, or enough are known.
    void follow_all(const Agreement& agreement) {
        for (bool moved = true; moved;) {
            moved = false;
            for (int edge = 0; edge < graph_.edges(); ++edge)
                for (const int from : {0, 1}) {
                    const Direction direction{edge, from};
                    if (are_enough(agreement)) return;
                    if (!follow(direction, most_paths(direction, agreement))) continue;
                    follow_doubtful(direction);
                    moved = true;
                    report();
                }
        }
    }

    /// Follows the few solutions that became known last. Whether an end is new.
    bool find_along(Direction direction) {
        constexpr int few = 4;
        const SolutionSet<Point>& known = solutions(direction.from);
        std::vector<Point> starts;
        for (int i = std::max(0, known.size() - few); i < known.size(); ++i)
            starts.push_back(known[i]);
        PathEnds<Point> ends = loops_.follow(direction, starts);
        refuse(direction.to(), false, ends);
        const int before = solutions(direction.to()).size();
        for (const std::optional<Point>& end : ends)
            index_of(direction.to(), end);
        return solutions(direction.to()).size() > before;
    }

    /// Follows a few solutions along edges that the graph does not have, until one is new.
    bool find_along_others() {
        constexpr int others = 24;
        for (int edge = graph_.edges(); edge < graph_.edges() + others; ++edge) {
            if (edge == made_) make_edge();
            if (find_along({edge, 0}) || find_along({edge, 1})) return true;
        }
        return false;
    }

    static constexpr int lanes = 16; ///< to fill: fewer paths take as long

    Loops loops_;
    std::array<SolutionSet<Point>, 2> solutions_;
    MatchedGraph graph_;
    int made_ = 0; ///< how many edges the loops have
    int lost_ = 0;
    Report report_;
};

} // namespace plprove
