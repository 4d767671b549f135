// The equations of a registration problem at integer data (certs/FORMAT.md, section 10):
// polynomials on the rotations, the translation eliminated by minors, with bounds of their degrees
// that hold for arbitrary data.
#pragma once

#include "prover/bounds/registration.h"
#include "prover/bounds/rotation_ring.h"
#include "prover/minimal/placement.h"

#include <cstdint>
#include <string>

namespace plprove::bounds {

/// Which coordinates the rotations have, and what is special in the coordinates of space.
enum class Frame {
    general, // all rotations
    line,    // those that take the first known line into the plane of its image
    points,  // those that take the line through the first two known points into that of its image
    lines,   // like `line`; the common perpendicular of the first two lines is the third axis
};

std::string name(Frame frame);

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
        Vector3 point, line;
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

/// Data of the type, in the frame, that depend on the arguments alone. Assumes that they suit.
RegistrationData draw_data(const Registration& type, Frame frame, std::uint64_t seed);

/// A polynomial that vanishes at the rotations of all solutions, and a bound of its degree.
struct Equation {
    Polynomial polynomial;
    BiDegree degree;
};

RotationRing rotation_ring(Frame frame);

/// The equations, in the order of FORMAT.
std::vector<Equation> equations(const RegistrationData& data, Frame frame);

} // namespace plprove::bounds
