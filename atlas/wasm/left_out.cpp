// Of the solver what the page never asks for, and what would take the compiler long: elimination
// templates, which neither of its problems has; conditions; and starts that are made, as the page
// has them as files.
#include "prover/solver/condition.h"
#include "prover/solver/extension.h"

namespace plprove {

std::optional<ExtensionSolver> ExtensionSolver::make(const Signature&) {
    return std::nullopt;
}

std::vector<QuaternionCameras> ExtensionSolver::cameras(const CameraSystem&,
                                                        const std::vector<Eigen::Vector3d>&,
                                                        std::uint64_t, unsigned, Wanted) const {
    return {};
}

double condition(const CameraSystem&, const std::vector<Eigen::Vector3d>&,
                 const std::vector<Pose<double>>&) {
    return 0;
}

double condition(const std::vector<Eigen::Vector3d>&, const std::vector<Eigen::Vector3d>&,
                 const Pose<double>&) {
    return 0;
}

Start cached_start(std::size_t) {
    return {};
}

} // namespace plprove
