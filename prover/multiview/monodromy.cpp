#include "prover/multiview/monodromy.h"

#include "prover/multiview/distinct.h"
#include "prover/multiview/path.h"
#include "prover/multiview/solution_set.h"

#include <algorithm>
#include <map>

namespace plprove::multiview {

namespace {

struct Node {
    Images<Complex> images;
    SolutionSet solutions;
};

/// A way between the two nodes. `match[0][i]` is the solution of node 1 to which solution i of node
/// 0 leads; match[1] is the inverse.
struct Edge {
    std::array<Images<Complex>, 2> ends;
    std::array<std::map<int, int>, 2> match;
    std::array<int, 2> tried{}; ///< so many solutions of each node have been followed, or matched
};

/// To which solution of the other node a solution leads; none where the path gets lost.
using Targets = std::map<int, std::optional<int>>;

class Monodromy {
public:
    Monodromy(const general::Problem& problem, std::uint64_t seed,
              const MonodromySettings& settings)
        : settings_(settings), random_(seed, 0), system_(problem, random_) {
        const SolvedImages scene = system_.random_scene(random_);
        nodes_[0].images = scene.images;
        nodes_[0].solutions.add(scene.solution);
        nodes_[1].images = random_images(problem, random_);
        for (int edge = 0; edge < settings.edges; ++edge)
            add_edge();
    }

    MonodromyResult run() {
        for (follow_all_edges(); wants_more_edges(); follow_all_edges())
            add_edge();
        return result();
    }

private:
    void add_edge() {
        edges_.emplace_back();
        for (std::size_t node = 0; node < 2; ++node)
            edges_.back().ends[node] = rephased(system_.problem(), nodes_[node].images, random_);
    }

    bool wants_more_edges() const {
        constexpr int few = 20;
        return nodes_[0].solutions.size() <= few &&
               static_cast<int>(edges_.size()) < settings_.edges_of_few;
    }

    /// Until each solution has been along each way.
    void follow_all_edges() {
        for (bool moved = true; moved;) {
            moved = false;
            for (Edge& edge : edges_)
                for (std::size_t from = 0; from < 2; ++from)
                    moved = follow_edge(edge, from) || moved;
        }
    }

    /// Follows the solutions of a node that have not been along this way. Returns whether there
    /// are any.
    bool follow_edge(Edge& edge, std::size_t from) {
        const int known = nodes_[from].solutions.size();
        std::vector<int> starts;
        for (int i = edge.tried[from]; i < known; ++i)
            if (!edge.match[from].contains(i)) starts.push_back(i);
        edge.tried[from] = known;
        const bool enough = nodes_[0].solutions.size() > settings_.most_solutions;
        if (starts.empty() || enough) return false;
        Targets targets = follow(edge, from, starts, Care::usual);
        const std::vector<int> doubtful = doubtful_starts(edge, from, targets);
        for (const auto& [start, target] : follow(edge, from, doubtful, Care::careful))
            targets[start] = target;
        for (const auto& [start, target] : targets)
            match(edge, from, start, target);
        settings_.report(nodes_[0].solutions.size(), paths_);
        return true;
    }

    /// Where the paths lead. The ends become known solutions: even a path that has jumped ends at
    /// one.
    Targets follow(Edge& edge, std::size_t from, const std::vector<int>& indices, Care care) {
        SolutionSet& others = nodes_[1 - from].solutions;
        std::vector<Point> starts;
        for (const int index : indices)
            starts.push_back(nodes_[from].solutions[index]);
        const auto ends = follow_all(system_, edge.ends[from], edge.ends[1 - from], starts, care,
                                     settings_.threads);
        paths_ += static_cast<std::int64_t>(starts.size());
        Targets targets;
        for (std::size_t k = 0; k < indices.size(); ++k) {
            std::optional<int>& target = targets[indices[k]];
            if (!ends[k] || system_.has_null_quaternion(*ends[k])) continue;
            target = others.find(*ends[k]);
            if (!target) target = others.add(*ends[k]);
        }
        return targets;
    }

    /// The starts of lost paths, and of those that share their ends: of these all but one have
    /// jumped. Earlier ones are no longer matched then.
    static std::vector<int> doubtful_starts(Edge& edge, std::size_t from, const Targets& targets) {
        const std::size_t to = 1 - from;
        std::map<int, std::vector<int>> starts_of;
        std::vector<int> doubtful;
        for (const auto& [start, target] : targets)
            if (target)
                starts_of[*target].push_back(start);
            else
                doubtful.push_back(start);
        for (auto& [target, starts] : starts_of) {
            const auto earlier = edge.match[to].find(target);
            if (earlier != edge.match[to].end()) {
                starts.push_back(earlier->second);
                edge.match[from].erase(earlier->second);
                edge.match[to].erase(earlier);
            }
            if (starts.size() > 1) doubtful.insert(doubtful.end(), starts.begin(), starts.end());
        }
        return doubtful;
    }

    void match(Edge& edge, std::size_t from, int start, const std::optional<int>& target) {
        if (target && !edge.match[1 - from].contains(*target)) {
            edge.match[from][start] = *target;
            edge.match[1 - from][*target] = start;
        } else {
            ++lost_;
        }
    }

    std::vector<Point> distinct(std::size_t node) const {
        return distinct_solutions(system_, nodes_[node].images, nodes_[node].solutions.points());
    }

    MonodromyResult result() {
        const std::vector<Point> points = distinct(0);
        const auto first = points.size();
        const auto second = distinct(1).size();
        MonodromyResult result{static_cast<int>(std::max(first, second)),
                               0,
                               static_cast<int>(edges_.size()),
                               lost_,
                               paths_,
                               nodes_[0].images,
                               system_,
                               points};
        for (const Edge& edge : edges_)
            result.edges += first == second && edge.match[0].size() == first;
        return result;
    }

    const MonodromySettings& settings_;
    Random random_;
    System system_;
    std::array<Node, 2> nodes_;
    std::vector<Edge> edges_;
    std::int64_t paths_ = 0;
    int lost_ = 0;
};

} // namespace

MonodromyResult run_monodromy(const general::Problem& problem, std::uint64_t seed,
                              const MonodromySettings& settings) {
    return Monodromy(problem, seed, settings).run();
}

} // namespace plprove::multiview
