// All cameras of an extension of the five-point problem without paths: two views share five points,
// which determine 20 relative poses; with each, a template registers the third camera
// (proofs/registrations.md, Lemma U1).
#pragma once

#include "prover/solver/registration_template.h"

#include <optional>

namespace plprove {

class ExtensionSolver {
public:
    /// Nothing where no two views share five points, or paths are faster than the template.
    static std::optional<ExtensionSolver> make(const Signature& signature);

    /// Which cameras are wanted: all, or real ones with the five points in front.
    enum class Wanted { all, real_in_front };

    /// The cameras, to some digits, for real images, one unit vector for each free vector of
    /// `system`, which is that of the signature. At least one of each pair of complex conjugates is
    /// there, unless rounding errors lose it. Another attempt has other rounding errors. The same
    /// cameras in the same order by any number of threads.
    std::vector<QuaternionCameras> cameras(const CameraSystem& system,
                                           const std::vector<Eigen::Vector3d>& images,
                                           std::uint64_t attempt, unsigned threads,
                                           Wanted wanted = Wanted::all) const;

    const RegistrationTemplate& registration() const { return registration_; }

private:
    ExtensionSolver(int third, const templates::Template& found)
        : third_(third), registration_(found) {}

    /// The cameras with this relative pose of the two views that share points.
    std::vector<QuaternionCameras> with_third(const ClassSights& sights, const ComplexPose& pair,
                                              std::uint64_t attempt, Wanted wanted) const;

    int third_; ///< the view that is registered
    RegistrationTemplate registration_;
};

} // namespace plprove
