// A class of problems with all its solutions, for tests of the degree engine.
#pragma once

#include "prover/catalogue/degrees.h"
#include "prover/problem/spec.h"
#include "prover/three_views/camera_loops.h"

namespace plprove {

/// The number of the label class of a problem in notation.
inline std::size_t number_of(const std::string& notation) {
    const Signature signature = *signature_of(parse_spec(notation));
    return class_number(label_classes(), representative(signature));
}

/// All solutions of a class, or the first ones, at random complex images.
struct Solved {
    CameraSystem system;
    Monodromy<CameraLoops> monodromy;

    explicit Solved(std::size_t number) : Solved(number, degree_of(number)) {}
    Solved(std::size_t number, int solutions, std::uint64_t seed = 1)
        : system(camera_system(label_classes()[number])),
          monodromy(camera_monodromy(CameraLoops(system, seed, number))) {
        constexpr int most_edges = 10;
        monodromy.reach(solutions, most_edges);
    }

    const std::vector<CameraPoint>& solutions() const { return monodromy.solutions().points(); }
    const CameraLoops& loops() const { return monodromy.loops(); }

    /// Images that move on from these ones.
    TrackedImages moving(const Images& from, const Images& to) const {
        return moving_images(system, loops().constants(), from, to);
    }
    TrackedSystem tracked() const { return tracked_system(system, loops().chart()); }

private:
    static int degree_of(std::size_t number) {
        const std::vector<Signature>& classes = label_classes();
        return *degree_on_file(class_number(classes, constraint_representative(classes[number])));
    }
};

} // namespace plprove
