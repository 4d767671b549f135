// The coordinates in which a registration problem is solved: the frames of certs/FORMAT.md, section
// 10.
#pragma once

#include <array>

namespace plprove::templates {

/// Which coordinates the rotations have, and what is special in the coordinates of space.
enum class Frame {
    general, // all rotations
    line,    // those that take the first known line into the plane of its image
    points,  // those that take the line through the first two known points into that of its image
    lines,   // like `line`; the common perpendicular of the first two lines is the third axis
};

constexpr const char* name(Frame frame) {
    switch (frame) {
    case Frame::general:
        return "general";
    case Frame::line:
        return "line";
    case Frame::points:
        return "points";
    case Frame::lines:
        return "lines";
    }
    return "";
}

/// Degree on all rotations: (half the degree in the quaternion, 0); in the other frames, on a
/// product of two circles: the degrees in the coordinates of the circles.
using BiDegree = std::array<int, 2>;

constexpr bool at_most(const BiDegree& a, const BiDegree& b) {
    return a[0] <= b[0] && a[1] <= b[1];
}

constexpr BiDegree sum(const BiDegree& a, const BiDegree& b) {
    return {a[0] + b[0], a[1] + b[1]};
}

/// The degree of the entries of the rotation.
constexpr BiDegree unit(Frame frame) {
    return {1, frame == Frame::general ? 0 : 1};
}

} // namespace plprove::templates
