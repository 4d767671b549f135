// Coordinates in which the equations of a registration problem are those of a frame
// (certs/FORMAT.md, section 10; Lemma U3 of proofs/registrations.md).
#pragma once

#include "prover/solver/known_scene.h"
#include "prover/solver/templates/equations.h"

namespace plprove {

/// A scene in a frame, and the way there: a point X of space becomes space (X - origin), an image x
/// becomes view x. The matrices are rotations, complex where the scene is.
struct FramedScene {
    KnownScene<std::complex<double>> scene;
    Eigen::Vector3cd origin;
    Eigen::Matrix3cd space, view;

    /// The rotation in the coordinates of before.
    Eigen::Matrix3cd turned_back(const Eigen::Matrix3cd& rotation) const {
        return view.transpose() * rotation * space;
    }
};

/// What the frame leaves open is chosen at random, so that no scene is special: another way for
/// another attempt. Assumes that the scene has what the frame needs.
FramedScene in_frame(KnownScene<std::complex<double>> scene, templates::Frame frame,
                     std::uint64_t attempt);

} // namespace plprove
