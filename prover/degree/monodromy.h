// Monodromy: all camera solutions of a problem for some images, from a single one, by following
// solutions around loops of images.
#pragma once

#include "prover/degree/degree.h"
#include "prover/degree/images.h"
#include "prover/degree/path_follower.h"
#include "prover/degree/solution_set.h"
#include "prover/degree/spurious_zeros.h"

#include <functional>

namespace plprove {

/// Two nodes with random images, and edges between them along which all solutions are followed.
class Monodromy {
public:
    /// What is less nondegenerate than this is likely to be no solution, but a degenerate one.
    static constexpr double suspicious = 1e-8;
    /// What is less nondegenerate than this may be a spurious zero: these are degenerate, and 1e-8
    /// is the largest value that rounding has been seen to give them.
    static constexpr double doubtful = 1e-4;

    /// What is less nondegenerate than `least` when it is found is followed again with more digits.
    Monodromy(const CameraSystem& system, std::uint64_t seed, std::uint64_t stream,
              double least = suspicious);

    /// Chooses images of the first node near those of the second one.
    using ChooseImages = std::function<Images(const Images&, Random&)>;
    /// The images of both nodes are real; `choose` is given those of a scene. The conjugate of a
    /// solution is one, too: each one that is found brings its conjugate along.
    Monodromy(const CameraSystem& system, std::uint64_t seed, std::uint64_t stream,
              const ChooseImages& choose);

    /// Adds a zero of the camera equations for images(), wherever it comes from, that is not among
    /// solutions().
    void add(const CameraPoint& zero) { add(0, zero); }

    /// Follows solutions along all edges until each edge has matched all solutions of both nodes,
    /// or `target` solutions (0: any number) are known at the first node.
    void run(int edges, int target);

    /// Follows no more solutions than it takes to know `target` of them at the first node, along as
    /// few edges as will do, `most_edges` in all.
    void find(int target, int most_edges);
    /// Has run() and find() call a function each time they have followed some paths; an empty one
    /// is not called.
    void report_to(std::function<void(const DegreeProgress&)> progress) {
        progress_ = std::move(progress);
    }

    const SolutionSet& solutions() const { return nodes_[0].solutions; }
    const Images& images() const { return nodes_[0].images; }
    const CameraChart& chart() const { return chart_; }
    const std::vector<Complex3>& constants() const { return constants_; }
    PathFollower& follower() { return follower_; }
    int edges() const { return static_cast<int>(edges_.size()); }
    /// How many solutions of either node lack a partner along some edge, counted for each edge.
    int unmatched() const;
    /// How many edges match all solutions of both nodes.
    int bijective_edges() const;
    /// How many of solutions() are spurious zeros (spurious_zeros.h).
    int spurious_solutions() const;

private:
    Monodromy(const CameraSystem& system, std::uint64_t seed, std::uint64_t stream, double least,
              Field field);
    /// To be called once both nodes have their images.
    void prepare_nodes(std::uint64_t seed, std::uint64_t stream);

    struct Node {
        Images images;
        std::vector<Complex3> vectors; ///< the image vectors
        SolutionSet solutions;
    };
    static constexpr int open = -1, lost = -2;
    struct Edge {
        Images to;                                            ///< those of node 1, rephased
        std::array<TrackedImages, 2> images{};                ///< forth and back
        std::array<std::array<TrackedImages, 2>, 2> detour{}; ///< the same, in two legs
        std::array<std::vector<int>, 2> partner{};   ///< of each solution of node 0, node 1
        std::array<std::vector<int>, 2> postponed{}; ///< starts of paths to follow again
    };

    /// Adds a zero at a node, and its conjugate if the images are real. Returns its index.
    int add(std::size_t node, const CameraPoint& zero);
    void add_edge();
    /// Forth to the images and back, in two legs.
    std::array<std::array<TrackedImages, 2>, 2> random_detour(const Images& to);
    int unmatched(const Edge& edge) const;
    /// Matches the end of a path from a solution of node `from`. Returns the solutions whose paths
    /// are to be followed again with more digits: one that was lost, or has an end that is less
    /// nondegenerate than `least`, or two that have the same end, as one of them must have jumped.
    std::vector<int> match(Edge& edge, int from, int start, const std::optional<CameraPoint>& end,
                           double least);
    /// Follows solutions of node `from` that have no partner, `most` of them; false if there are
    /// none.
    bool follow_edge(Edge& edge, int from, int most);
    /// Follows those of the paths on a detour that have no end, and matches what arrives.
    void follow_detours(Edge& edge, int from, const std::vector<int>& starting,
                        const std::vector<CameraPoint>& starts, const PathFollower::Ends& ends);
    /// Follows solutions along the first edge that has some without a partner; false if none has.
    bool follow_some(int target);
    /// Follows the postponed paths with more digits. Whether that found solutions.
    bool follow_postponed();
    /// Of zeros for the images of a node, the indices of the spurious ones.
    std::vector<std::size_t> find_spurious(std::size_t node,
                                           const std::vector<CameraPoint>& zeros) const;
    /// The ends at a node without those that are new and spurious zeros: these paths jumped.
    PathFollower::Ends without_spurious(std::size_t node, PathFollower::Ends ends) const;

    const CameraSystem& system_;
    double least_;
    Field field_;
    Random random_;
    CameraChart chart_;
    std::vector<Complex3> constants_;
    std::array<Node, 2> nodes_;
    std::vector<Edge> edges_;
    PathFollower follower_;
    std::vector<SpuriousZeros> spurious_; ///< for the images of either node
    std::function<void(const DegreeProgress&)> progress_;
};

} // namespace plprove
