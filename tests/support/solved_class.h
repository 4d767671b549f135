// A class of problems with all its solutions, for tests of the degree engine.
#pragma once

#include "prover/degree/monodromy.h"
#include "prover/problem/spec.h"

namespace plprove {

/// The number of the label class of a problem in notation.
inline std::size_t number_of(const std::string& notation) {
    const Signature signature = *signature_of(parse_spec(notation));
    return class_number(label_classes(), representative(signature));
}

/// All solutions of a class at random complex images.
struct Solved {
    CameraSystem system;
    Monodromy monodromy;

    explicit Solved(std::size_t number)
        : system(camera_system(label_classes()[number])), monodromy(system, 1, number) {
        monodromy.run(4, 0);
    }
};

} // namespace plprove
