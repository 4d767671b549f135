// Scenes and cameras that are known exactly, with their images (FORMAT.md, section 14).
#pragma once

#include "checker/general_degrees/scene_system.h"

#include <gmpxx.h>

#include <array>
#include <string>

/// A camera: rows of four numbers.
using KnownCamera = std::array<std::array<int, 4>, 3>;

/// Cameras and depths in the coordinates of FORMAT.md, all of them integers, and what views see.
struct KnownScene {
    checker::Problem problem{};
    std::vector<KnownCamera> cameras{};
    std::vector<mpq_class> coordinates{};
    std::vector<checker::Numbers> views{};
};

/// A scene whose images meet the conditions of FORMAT.md, with no degenerate camera.
KnownScene known_scene(const std::string& notation);
