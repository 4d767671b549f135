#include "prover/solver/camera_solver.h"

#include "prover/solver/alignment.h"
#include "prover/three_views/path_follower.h"

#include <atomic>

namespace plprove {

CameraSolver::CameraSolver(Start start)
    : start_(std::move(start)),
      equations_(camera_system(label_classes()[start_.number]), start_.chart, start_.constants),
      extension_(ExtensionSolver::make(label_classes()[start_.number])) {}

void CameraSolver::register_cameras(const std::vector<Eigen::Vector3d>& images,
                                    const SearchOptions& options, ZerosAtRest& zeros) const {
    const std::uint64_t most_attempts = options.effort == Effort::thorough ? 2 : 1;
    for (std::uint64_t attempt = 0; attempt < most_attempts && !zeros.is_complete(); ++attempt)
        zeros.add(extension_->cameras(equations_.system, images, attempt, options.threads));
}

std::uint64_t CameraSolver::follow_paths(const Images& images, const SearchOptions& options,
                                         ZerosAtRest& zeros) const {
    const int most_ways = options.effort == Effort::thorough ? 3 : 1;
    Random random(0, start_.number);
    std::atomic<std::uint64_t> steps = 0;
    int before = 0; // where the second way finds nothing new, the third is no better
    for (int way = 0; way < most_ways && !zeros.is_complete(); ++way) {
        if (way >= 2 && zeros.found().size() == before) break;
        before = zeros.found().size();
        const Images to = way == 0 ? images : rephased(images, Phases::near_one, random);
        const TrackedImages straight =
            moving_images(equations_.system, start_.constants, start_.images, to);
        const auto follow = [&](const std::vector<CameraPoint>& starts, const auto& way_of) {
            return in_threads(starts, options.threads, [&](const auto& part) {
                PathFollower follower(equations_.tracked);
                auto ends = (follower.*way_of)(straight, part);
                steps += follower.counts().steps;
                return ends;
            });
        };
        const auto ends = zeros.add(follow(start_.solutions, &PathFollower::follow_quickly));
        if (options.effort == Effort::thorough && !zeros.is_complete())
            zeros.add(follow(without_end(start_.solutions, ends).first,
                             &PathFollower::follow_double_double));
    }
    return steps;
}

FoundCameras CameraSolver::solve(const std::vector<Eigen::Vector3d>& images,
                                 const SearchOptions& options) const {
    const Alignment alignment = align(equations_.system, start_.images, images);
    ZerosAtRest zeros(equations_, complex_images(alignment.turned), start_.degree(),
                      options.threads);
    if (options.templates && extension_) register_cameras(alignment.turned, options, zeros);
    std::uint64_t steps = 0;
    if (options.effort == Effort::thorough || zeros.found().size() == 0)
        steps = follow_paths(alignment.nearest, options, zeros);
    FoundCameras result{{}, start_.degree() - zeros.found().size(), steps};
    for (const CameraPoint& zero : zeros.found().points())
        result.cameras.push_back(turned_back(alignment.turn, start_.chart.cameras(zero)));
    return result;
}

} // namespace plprove
