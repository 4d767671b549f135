// What is known of the camera that a template registers (FORMAT.md, section 10), as a file has it.
#pragma once

#include "checker/algebra/vector3.h"
#include "checker/file/reader.h"

#include <compare>

namespace checker {
/// How many constraints of each kind there are: the type of a registration problem.
struct Registration {
    std::array<unsigned, 8> stars{}; // by the number of their pins
    unsigned lines = 0;
    unsigned incidences = 0;
    std::array<unsigned, 12> groups{}; // of rays, by size
    auto operator<=>(const Registration&) const = default;
};

/// The relative pose of two views that share five points: one camera, and five rays of the other.
inline constexpr Registration relative_pose{.groups = {0, 0, 0, 0, 0, 1}};

struct KnownPin {
    IntegerVector direction, toward;
};
/// The camera sees a known point as this image point, and known lines through it.
struct Star {
    IntegerVector point, image;
    std::vector<KnownPin> pins{};
};
/// The camera sees a known line as this image line.
struct KnownLine {
    IntegerVector point, direction, image;
};
/// The camera sees a known point on this image line.
struct Incidence {
    IntegerVector point, line;
};
struct Ray {
    IntegerVector direction, image;
};
/// The rays of some image points meet known lines through one point, one each.
struct Group {
    IntegerVector point;
    std::vector<Ray> rays{};
};

/// How coordinates were chosen: special ones make the rotations fewer.
enum class Frame { general, line, points, lines };

struct Constraints {
    Frame frame{};
    std::vector<Star> stars{};
    std::vector<KnownLine> lines{};
    std::vector<Incidence> incidences{};
    std::vector<Group> groups{};
};

/// Takes the lines of the constraints. Throws Malformed.
Constraints read_constraints(Reader& reader, Frame frame);

Registration type_of(const Constraints& constraints);

/// The number of conditions on a rotation and a translation.
unsigned weight_of(const Constraints& constraints);
} // namespace checker
