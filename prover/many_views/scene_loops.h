// Loops of images of a problem with complete visibility, for monodromy.
#pragma once

#include "prover/many_views/path.h"
#include "prover/monodromy/monodromy.h"

namespace plprove::many_views {

/// Two random images, and ways between them, for monodromy.
class SceneLoops {
public:
    using Point = many_views::Point;
    static constexpr int attempts = 2;

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
    PathEnds<Point> follow_again(Direction direction, int attempt,
                                 const std::vector<Point>& starts) {
        return follow(direction, starts, attempt == 0 ? Care::careful : Care::precise);
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

/// The relative distance of approximations of one solution.
inline constexpr double near_in_general = 1e-7;

/// Monodromy of these loops, where the solution that they start from is known.
inline SceneMonodromy scene_monodromy(SceneLoops loops, SceneMonodromy::Report report = {}) {
    SceneMonodromy monodromy(std::move(loops), near_in_general, std::move(report));
    monodromy.add(0, monodromy.loops().start());
    return monodromy;
}

} // namespace plprove::many_views
