// All solutions for the cameras, for given images of a label class. Extensions of the five-point
// problem are solved by elimination templates, others by parameter homotopy: paths lead from the
// solutions of a start to those of the given images.
#pragma once

#include "prover/solver/extension.h"
#include "prover/solver/start.h"
#include "prover/solver/zeros_at_rest.h"

#include <Eigen/Core>

namespace plprove {

/// What came of following all paths to some images.
struct FoundCameras {
    std::vector<QuaternionCameras> cameras; ///< different ones
    /// How many solutions the start has more than were found: paths were lost, or end at degenerate
    /// cameras, as some do where images are special, or at rotations with entries beyond 10^12,
    /// which doubles do not hold.
    int lost = 0;
    std::uint64_t steps = 0; ///< of the paths
};

/// How much to do: `once` follows each path once; `thorough` follows lost paths again, with more
/// digits, and all paths on other ways while some are lost.
enum class Effort { once, thorough };

struct SearchOptions {
    Effort effort = Effort::thorough;
    /// Whether extensions of the five-point problem are solved by elimination templates
    /// (extension.h), and by paths only where these lose solutions.
    bool templates = true;
    /// How many threads share the work. The result does not depend on it.
    unsigned threads = 1;
};

class CameraSolver {
public:
    explicit CameraSolver(Start start);

    /// The solutions for real images, one vector of length 1 for each free vector of system(), to
    /// 13 digits. May be called by several threads at once. The same result for
    /// the same images.
    FoundCameras solve(const std::vector<Eigen::Vector3d>& images,
                       const SearchOptions& options) const;

    const CameraSystem& system() const { return equations_.system; }
    const Start& start() const { return start_; }

private:
    /// Adds what templates find, or what paths find; returns the steps of the paths.
    void register_cameras(const std::vector<Eigen::Vector3d>& images, const SearchOptions& options,
                          ZerosAtRest& zeros) const;
    std::uint64_t follow_paths(const Images& images, const SearchOptions& options,
                               ZerosAtRest& zeros) const;

    Start start_;
    ChartedEquations equations_;
    std::optional<ExtensionSolver> extension_;
};

} // namespace plprove
