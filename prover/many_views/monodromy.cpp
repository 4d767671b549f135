#include "prover/many_views/monodromy.h"

#include "prover/many_views/distinct.h"
#include "prover/many_views/path.h"
#include "prover/monodromy/monodromy.h"

#include <algorithm>

namespace plprove::many_views {

namespace {

/// Two random images, and ways between them, for monodromy.
class SceneLoops {
public:
    using Point = many_views::Point;
    static constexpr int attempts = 1;

    SceneLoops(const Problem& problem, std::uint64_t seed, int threads)
        : threads_(threads), random_(seed, 0), system_(problem, random_) {
        SolvedImages scene = system_.random_scene(random_);
        images_ = {scene.images, random_images(problem, random_)};
        start_ = scene.solution;
    }

    const System& system() const { return system_; }
    const Images<Complex>& images(int node) const {
        return images_[static_cast<std::size_t>(node)];
    }
    /// A solution of node 0.
    const Point& start() const { return start_; }
    std::int64_t paths() const { return paths_; }

    void add_edge() {
        edges_.emplace_back();
        for (std::size_t node = 0; node < 2; ++node)
            edges_.back()[node] = rephased(system_.problem(), images_[node], random_);
    }

    PathEnds<Point> follow(Direction direction, const std::vector<Point>& starts) {
        return follow(direction, starts, Care::usual);
    }
    PathEnds<Point> follow_again(Direction direction, int, const std::vector<Point>& starts) {
        return follow(direction, starts, Care::careful);
    }
    static bool leads_elsewhere(int) { return false; }

    std::vector<bool> refused(int, const std::vector<Point>& points, bool) const {
        std::vector<bool> result;
        for (const Point& point : points)
            result.push_back(!system_.has_cameras(point));
        return result;
    }
    static std::optional<Point> companion(const Point&) { return std::nullopt; }

private:
    PathEnds<Point> follow(Direction direction, const std::vector<Point>& starts, Care care) {
        const auto& edge = edges_[static_cast<std::size_t>(direction.edge)];
        paths_ += std::ssize(starts);
        return follow_all(system_, edge[static_cast<std::size_t>(direction.from)],
                          edge[static_cast<std::size_t>(direction.to())], starts, care, threads_);
    }

    int threads_;
    Random random_;
    System system_;
    std::array<Images<Complex>, 2> images_;
    Point start_;
    std::vector<std::array<Images<Complex>, 2>> edges_;
    std::int64_t paths_ = 0;
};

using SceneMonodromy = Monodromy<SceneLoops>;

std::vector<Point> distinct(const SceneMonodromy& monodromy, int node) {
    const SceneLoops& loops = monodromy.loops();
    return distinct_solutions(loops.system(), loops.images(node),
                              monodromy.solutions(node).points());
}

MonodromyResult result_of(const SceneMonodromy& monodromy) {
    const std::vector<Point> points = distinct(monodromy, 0);
    const auto first = std::ssize(points), second = std::ssize(distinct(monodromy, 1));
    const MatchedGraph& graph = monodromy.graph();
    const SceneLoops& loops = monodromy.loops();
    MonodromyResult result{static_cast<int>(std::max(first, second)),
                           0,
                           graph.edges(),
                           monodromy.lost(),
                           loops.paths(),
                           loops.images(0),
                           loops.system(),
                           points};
    for (int edge = 0; edge < graph.edges(); ++edge)
        result.edges += first == second && graph.matched(edge) == first;
    return result;
}

} // namespace

MonodromyResult run_monodromy(const Problem& problem, std::uint64_t seed,
                              const MonodromySettings& settings) {
    constexpr double near = 1e-7; // relative distance of approximations of one solution
    SceneMonodromy::Report report;
    if (settings.report)
        report = [&](const MonodromyProgress& progress) {
            settings.report(progress.solutions, progress.edges);
        };
    SceneMonodromy monodromy(SceneLoops(problem, seed, settings.threads), near, report);
    monodromy.add(0, monodromy.loops().start());
    monodromy.until_agreed({settings.edges, settings.edges_of_few, settings.most_solutions});
    return result_of(monodromy);
}

} // namespace plprove::many_views
