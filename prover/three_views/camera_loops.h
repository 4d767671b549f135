// Loops of images of a problem in three views, for monodromy: two nodes, whose images are
// neighbours, and edges between them. Each edge multiplies the image vectors by other numbers.
#pragma once

#include "prover/monodromy/monodromy.h"
#include "prover/three_views/images.h"
#include "prover/three_views/path_follower.h"
#include "prover/three_views/spurious_zeros.h"

#include <functional>
#include <limits>

namespace plprove {

class CameraLoops {
public:
    using Point = CameraPoint;
    /// In doubles straight ahead; then again with more digits, then on detours.
    static constexpr int attempts = 2;

    /// What is less nondegenerate than this is likely to be no solution, but a degenerate one.
    static constexpr double suspicious = 1e-8;
    /// What is less nondegenerate than this may be a spurious zero: these are degenerate, and 1e-8
    /// is the largest value that rounding has been seen to give them.
    static constexpr double doubtful = 1e-4;

    /// Random images of a scene, which node 0 has. What is less nondegenerate than `least` when it
    /// is found is followed again with more digits.
    CameraLoops(const CameraSystem& system, std::uint64_t seed, std::uint64_t stream,
                double least = suspicious);

    /// Chooses images of node 0 near those of node 1.
    using ChooseImages = std::function<Images(const Images&, Random&)>;
    /// The images of both nodes are real: `choose` is given those of a scene, which node 1 has. The
    /// conjugate of a solution is one, too: its companion.
    CameraLoops(const CameraSystem& system, std::uint64_t seed, std::uint64_t stream,
                const ChooseImages& choose);

    /// The cameras of the scene, and the node that has its images.
    const CameraPoint& start() const { return start_; }
    int start_node() const { return field_ == Field::real ? 1 : 0; }

    /// Of node 0.
    const Images& images() const { return nodes_[0].images; }
    const CameraChart& chart() const { return chart_; }
    const std::vector<Complex3>& constants() const { return constants_; }
    const PathCounts& counts() const { return follower_.counts(); }

    /// Follows no more paths than this again: at degenerate images many would be followed with many
    /// digits, to no end.
    void give_up_beyond(std::uint64_t paths) { most_again_ = paths; }

    // What Monodromy asks for.
    void add_edge();
    PathEnds<CameraPoint> follow(Direction direction, const std::vector<CameraPoint>& starts);
    PathEnds<CameraPoint> follow_again(Direction direction, int attempt,
                                       const std::vector<CameraPoint>& starts);
    static bool leads_elsewhere(int attempt) { return attempt == 1; }
    std::vector<bool> refused(int node, const std::vector<CameraPoint>& zeros, bool again) const;
    std::optional<CameraPoint> companion(const CameraPoint& zero) const;

private:
    struct Node {
        Images images;
        std::vector<Complex3> vectors; ///< the image vectors of the equations
    };
    using Legs = std::array<TrackedImages, 2>;
    struct Edge {
        Images to;                           ///< those of node 1, rephased
        std::array<TrackedImages, 2> images; ///< forth and back
        std::array<Legs, 2> detour;          ///< the same
    };

    CameraLoops(const CameraSystem& system, std::uint64_t seed, std::uint64_t stream, double least,
                Field field);
    /// To be called once both nodes have their images.
    void prepare_nodes(std::uint64_t seed, std::uint64_t stream);
    TrackedImages moving(const Images& from, const Images& to) const;
    /// Forth to the images and back.
    std::array<Legs, 2> random_detour(const Images& to);

    const CameraSystem& system_;
    double least_;
    Field field_;
    Random random_;
    CameraChart chart_;
    std::vector<Complex3> constants_;
    CameraPoint start_{};
    std::array<Node, 2> nodes_;
    std::vector<Edge> edges_;
    PathFollower follower_;
    std::uint64_t most_again_ = std::numeric_limits<std::uint64_t>::max();
    std::vector<SpuriousZeros> spurious_; ///< for the images of either node
};

/// Monodromy of these loops, where the solution that they start from is known.
Monodromy<CameraLoops> camera_monodromy(CameraLoops loops,
                                        Monodromy<CameraLoops>::Report report = {});

} // namespace plprove
