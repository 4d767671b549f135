// How solutions are permuted along loops of images, by following them numerically: evidence, as a
// path may jump.
#pragma once

#include "prover/groups/permutation.h"
#include "prover/monodromy/monodromy.h"

namespace plprove {

/// All solutions for some images, and loops there. Each loop goes along the first edge and back
/// along another. Loops is as in monodromy.h.
template <class Loops>
class SolutionLoops {
public:
    using Point = typename Loops::Point;

    /// `monodromy` knows a solution; `degree` is the number of all. Where not all are found there
    /// are no loops. Most paths of the first ones have been followed when all are found.
    SolutionLoops(Monodromy<Loops> monodromy, int degree, double near)
        : monodromy_(std::move(monodromy)), near_(near) {
        constexpr int most_edges = 6;
        monodromy_.reach(degree, most_edges);
        const Solutions& solutions = monodromy_.solutions();
        if (solutions.size() != degree) return;
        add_bijections(1);
        if (bijections_.empty()) return;
        there_.emplace(near_);
        for (const int index : bijections_.front())
            there_->add(monodromy_.solutions(1)[index]);
    }

    bool complete() const { return there_.has_value(); }

    /// The solutions that loops permute.
    const std::vector<Point>& solutions() const { return monodromy_.solutions().points(); }

    /// Follows more edges, those first that it took to find the solutions, until so many are known
    /// whole or many have lost paths. Each path is followed once, in one direction. To be called
    /// before there are loops.
    void add_bijections(int count) {
        constexpr int most_lost = 4;
        for (int lost = 0; std::ssize(bijections_) < count && lost < most_lost;) {
            if (auto along = monodromy_.follow_edge(edges_++))
                bijections_.push_back(std::move(*along));
            else
                ++lost;
        }
    }

    /// How edges lead the solutions of one node to those of the other.
    const std::vector<Permutation>& bijections() const { return bijections_; }

    /// The permutation of another loop; nothing where a path is lost.
    std::optional<Permutation> next() { return back_along(add_edge()); }

    /// The same, followed both ways: nothing, too, where a path leads elsewhere on its way back. A
    /// path that jumps rarely does so on its way back, too.
    std::optional<Permutation> next_both_ways() {
        const int edge = add_edge();
        const auto forth = indices_in(*there_, follow({edge, 0}, monodromy_.solutions().points()));
        if (!forth) return std::nullopt;
        auto back = back_along(edge);
        if (!back || inverse(*forth) != *back) return std::nullopt;
        return back;
    }

private:
    using Ends = PathEnds<Point>;
    using Solutions = SolutionSet<Point>;

    /// From then on the graph has no more edges.
    int add_edge() {
        if (edges_ >= monodromy_.graph().edges()) monodromy_.loops().add_edge();
        return edges_++;
    }

    std::optional<Permutation> back_along(int edge) {
        return indices_in(monodromy_.solutions(), follow({edge, 1}, there_->points()));
    }

    /// Follows an edge from all solutions of a node; with more digits where a path is lost or
    /// jumps.
    Ends follow(Direction direction, const std::vector<Point>& starts) {
        Ends ends = monodromy_.loops().follow(direction, starts);
        forget_shared(ends);
        fill(ends, starts, [&](const std::vector<Point>& left) {
            return monodromy_.loops().follow_again(direction, 0, left);
        });
        return ends;
    }

    /// Takes away the ends that several paths have: these jumped.
    void forget_shared(Ends& ends) const {
        Solutions seen(near_);
        std::vector<std::vector<std::size_t>> paths;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            if (!ends[i]) continue;
            const std::optional<int> known = seen.find(*ends[i]);
            if (!known) {
                seen.add(*ends[i]);
                paths.emplace_back();
            }
            paths[as_index(known.value_or(seen.size() - 1))].push_back(i);
        }
        for (const std::vector<std::size_t>& same : paths)
            if (same.size() > 1)
                for (const std::size_t i : same)
                    ends[i].reset();
    }

    /// The solutions that the ends are, each once; nothing if some are none of them or one is met
    /// twice.
    static std::optional<Permutation> indices_in(const Solutions& solutions, const Ends& ends) {
        Permutation result;
        std::vector<bool> met(ends.size());
        for (const std::optional<Point>& end : ends) {
            const std::optional<int> index = end ? solutions.find(*end) : std::nullopt;
            if (!index || met[as_index(*index)]) return std::nullopt;
            met[as_index(*index)] = true;
            result.push_back(*index);
        }
        return result;
    }

    Monodromy<Loops> monodromy_;
    double near_;
    /// At the end of the first edge, in the order of the solutions that it leads there.
    std::optional<Solutions> there_;
    std::vector<Permutation> bijections_;
    int edges_ = 0; ///< that have been followed, for these and for loops
};

} // namespace plprove
