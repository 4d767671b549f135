// The equations of a registration problem at integer data (certs/FORMAT.md, section 10):
// polynomials on the rotations, the translation eliminated by minors, with bounds of their degrees
// that hold for arbitrary data.
#pragma once

#include "prover/minimal/placement.h"
#include "prover/solver/templates/registration.h"
#include "prover/solver/templates/rotation_ring.h"

#include <cstdint>
#include <vector>

namespace plprove::templates {

/// Whether a type has what the frame needs.
bool suits(Frame frame, const Registration& type);

/// Integer data of a registration problem.
struct RegistrationData {
    struct Pin {
        Vector3 direction, toward;
    };
    struct Star {
        Vector3 point, image;
        std::vector<Pin> pins;
    };
    struct Line {
        Vector3 point, direction, image;
    };
    struct Incidence {
        Vector3 point, image;
    };
    struct Ray {
        Vector3 direction, image;
    };
    struct Group {
        Vector3 point;
        std::vector<Ray> rays;
    };
    std::vector<Star> stars;
    std::vector<Line> lines;
    std::vector<Incidence> incidences;
    std::vector<Group> groups;
};

/// The line that the camera sees of a pin: from the image of the point toward another one.
Vector3 line_of(const RegistrationData::Star& star, const RegistrationData::Pin& pin);

/// Data of the type, in the frame, that depend on the arguments alone. Assumes that they suit.
RegistrationData draw_data(const Registration& type, Frame frame, std::uint64_t seed);

/// A polynomial that vanishes at the rotations of all solutions, and a bound of its degree.
struct Equation {
    Polynomial polynomial;
    BiDegree degree;
};

/// The equations, in the order of FORMAT.
std::vector<Equation> equations(const RegistrationData& data, Frame frame);

} // namespace plprove::templates
