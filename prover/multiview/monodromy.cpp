#include "prover/multiview/monodromy.h"

#include "prover/multiview/path.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <thread>

namespace plprove::multiview {

namespace {

/// Solutions of the same images, told apart.
class Solutions {
public:
    int size() const { return static_cast<int>(points_.size()); }
    const std::vector<Point>& points() const { return points_; }
    const Point& operator[](int index) const { return points_[static_cast<std::size_t>(index)]; }

    std::optional<int> find(const Point& point) const {
        const double radius = near * (1 + point.norm());
        const double centre = key(point);
        const double width = 2 * radius * std::sqrt(static_cast<double>(point.size()));
        for (auto i = by_key_.lower_bound(centre - width);
             i != by_key_.end() && i->first <= centre + width; ++i)
            if (((*this)[i->second] - point).norm() < radius) return i->second;
        return std::nullopt;
    }

    int add(const Point& point) {
        by_key_.emplace(key(point), size());
        points_.push_back(point);
        return size() - 1;
    }

private:
    static constexpr double near = 1e-7; // relative distance of approximations of one solution

    /// Real and imaginary parts, added: no more apart than that for points that are near.
    static double key(const Point& point) { return point.real().sum() + point.imag().sum(); }

    std::vector<Point> points_;
    std::multimap<double, int> by_key_;
};

struct Node {
    Images<Complex> images;
    Solutions solutions;
};

/// A way between the two nodes. `match[0][i]` is the solution of node 1 to which solution i of node
/// 0 leads; match[1] is the inverse.
struct Edge {
    std::array<Images<Complex>, 2> ends;
    std::array<std::map<int, int>, 2> match;
    std::array<int, 2> tried{}; ///< so many solutions of each node have been followed, or matched
};

std::vector<std::optional<Point>> follow_all(const System& system, const Images<Complex>& from,
                                             const Images<Complex>& to,
                                             const std::vector<const Point*>& starts, int threads) {
    std::vector<std::optional<Point>> ends(starts.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < starts.size(); i = next++)
            ends[i] = follow(system, from, to, *starts[i]);
    };
    std::vector<std::jthread> helpers;
    for (int thread = 1; thread < threads; ++thread)
        helpers.emplace_back(work);
    work();
    helpers.clear();
    return ends;
}

class Monodromy {
public:
    Monodromy(const general::Problem& problem, std::uint64_t seed,
              const MonodromySettings& settings)
        : settings_(settings), random_(seed, 0), system_(problem, random_) {
        const SolvedImages scene = system_.random_scene(random_);
        nodes_[0].images = scene.images;
        nodes_[0].solutions.add(scene.solution);
        nodes_[1].images = random_images(problem, random_);
        for (int edge = 0; edge < settings.edges; ++edge) {
            edges_.emplace_back();
            for (std::size_t node = 0; node < 2; ++node)
                edges_.back().ends[node] = rephased(problem, nodes_[node].images, random_);
        }
    }

    MonodromyResult run() {
        for (bool moved = true; moved;) {
            moved = false;
            for (Edge& edge : edges_)
                for (std::size_t from = 0; from < 2; ++from)
                    moved = follow_edge(edge, from) || moved;
        }
        return result();
    }

private:
    /// Follows the solutions of a node that have not been along this way. Returns whether there
    /// are any.
    bool follow_edge(Edge& edge, std::size_t from) {
        const Solutions& known = nodes_[from].solutions;
        std::vector<int> indices;
        std::vector<const Point*> starts;
        for (int i = edge.tried[from]; i < known.size(); ++i)
            if (!edge.match[from].contains(i)) {
                indices.push_back(i);
                starts.push_back(&known[i]);
            }
        edge.tried[from] = known.size();
        if (starts.empty() || known.size() > settings_.most_solutions) return false;
        const std::size_t to = 1 - from;
        const auto ends =
            follow_all(system_, edge.ends[from], edge.ends[to], starts, settings_.threads);
        paths_ += static_cast<std::int64_t>(starts.size());
        for (std::size_t k = 0; k < ends.size(); ++k) {
            if (ends[k])
                match(edge, from, indices[k], *ends[k]);
            else
                ++lost_;
        }
        settings_.report(nodes_[0].solutions.size(), paths_);
        return true;
    }

    /// One of two paths to the same end has jumped: none of both counts.
    void match(Edge& edge, std::size_t from, int start, const Point& end) {
        const std::size_t to = 1 - from;
        Solutions& others = nodes_[to].solutions;
        const auto known = others.find(end);
        const int index = known ? *known : others.add(end);
        const auto [place, is_new] = edge.match[to].try_emplace(index, start);
        if (is_new) {
            edge.match[from][start] = index;
        } else {
            edge.match[from].erase(place->second);
            edge.match[to].erase(place);
            ++lost_;
        }
    }

    MonodromyResult result() {
        const int count = nodes_[0].solutions.size();
        MonodromyResult result{
            count, 0, lost_, paths_, nodes_[0].images, nodes_[0].solutions.points()};
        for (const Edge& edge : edges_)
            result.edges += count == nodes_[1].solutions.size() &&
                            static_cast<int>(edge.match[0].size()) == count;
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
