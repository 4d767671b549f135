// How the path tracker evaluates a kind of cameras. No header of the standard library is used here:
// see prover/tracking/lanes.h.
#pragma once

namespace plprove {

enum class TrackedForm : unsigned char {
    polynomials, ///< from the polynomials of the matrix
    quaternion,  ///< faster: the numbers are a quaternion and a translation
    entries,     ///< faster: the numbers are the matrix, row by row
};

/// That a camera may consist of.
inline constexpr int most_camera_numbers = 12;

} // namespace plprove
