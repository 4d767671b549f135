// What the scripts have in common: which unknowns a problem has, what is observed, and how names
// and lists are written.
#pragma once

#include "prover/problem/notation.h"
#include "prover/scripts/layout.h"

#include <string>
#include <vector>

namespace plprove {

/// The image of a point (2 equations), of a pin in a view that sees its point (1), or of a line in
/// a view that sees no point on it (2).
struct Observation {
    enum Kind { point, pin, line };
    Kind kind = point;
    int view = 0;
    int index = 0; ///< of the pin; 0 for a point or a free line

    int equations() const { return kind == pin ? 1 : 2; }
};

/// What the views see of a feature, the views in order, a point before its pins.
std::vector<Observation> observations(const Feature& feature);

/// The number of equations of a problem, the degrees of freedom of its images.
int equation_count(const Features& problem);

/// The number of unknowns of the features alone.
int feature_unknown_count(const Features& problem);

/// The number of unknowns of the cameras: 6 for each camera but the first, less 1 for the scale.
int camera_unknown_count(const Features& problem);

/// The number of views, 0 for the problem without features.
int view_count(const Features& problem);

/// Vectors of three coordinates that place a feature: its point `X1`, its directions `D1a`, `D1b`,
/// ... for feature number 1. A coordinate is the name of an unknown, or `1`.
struct NamedVector {
    std::string name;
    std::vector<std::string> coordinates;
};

std::vector<NamedVector> vectors(const Feature& feature, std::size_t number);

/// The unknowns of camera `view` (1 for the second): three of the rotation, then the translation.
struct NamedCamera {
    std::string name; ///< `P2`
    std::vector<std::string> rotation;
    std::vector<std::string> translation;
};

NamedCamera camera(int view);

/// The names among coordinates: all but `1`.
void append_unknowns(std::vector<std::string>& unknowns,
                     const std::vector<std::string>& coordinates);

} // namespace plprove
