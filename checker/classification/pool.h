// Pools of coordinates as a file has them (FORMAT.md, sections 2 and 5).
#pragma once

#include "checker/classification/jacobian.h"

namespace checker {
/// The numbers of two camera lines: a quaternion and a translation each.
using CameraLines = std::array<Numbers, 2>;

/// Takes the head of a pool: its number, and the cameras of views 2 and 3, in two views that of
/// view 2. As nothing is seen in view 3 then, any camera will do there.
inline CameraLines read_cameras(Reader& reader, std::size_t pool, unsigned views) {
    if (pool > 99) reader.fail("pool", "at most 99 pools");
    reader.take(say("pool ", pool, " $"));
    const Numbers second = reader.take("camera 2 quaternion @ @ @ @ translation @ @ @ $");
    if (views == 2) return {second, {1, 0, 0, 0, 0, 0, 0}};
    return {second, reader.take("camera 3 quaternion @ @ @ @ translation @ @ @ $")};
}

/// Takes the rest of a feature line: the point and the directions of so many pins.
inline Numbers read_placement(Reader& reader, unsigned pins) {
    std::string pattern = "point @ @ @";
    for (unsigned pin = 0; pin < pins; ++pin)
        pattern += " pin @ @ @";
    return reader.take(pattern + " $");
}

/// Three of the numbers, from this place on.
inline IntegerVector vector_at(const Numbers& numbers, std::size_t place) {
    return {numbers[place], numbers[place + 1], numbers[place + 2]};
}

/// Throws Refused if a quaternion is zero.
inline Cameras cameras_of(const CameraLines& lines) {
    Cameras cameras{Camera{rotation_of(1, 0, 0, 0), {}}};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Numbers& n = lines[i];
        cameras[i + 1] = {rotation_of(n[0], n[1], n[2], n[3]), vector_at(n, 4)};
    }
    return cameras;
}

inline Placement placement_of(const Numbers& numbers) {
    Placement placement{.point = vector_at(numbers, 0), .directions = {}};
    for (std::size_t place = 3; place < numbers.size(); place += 3)
        placement.directions.push_back(vector_at(numbers, place));
    return placement;
}
} // namespace checker
