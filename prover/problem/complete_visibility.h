// The balanced problems with complete visibility, of each kind of cameras: those of two papers,
// calibrated cameras (PLMP: Duff, Kohn, Leykin, Pajdla, ICCV 2019) and projective ones (Kiehn,
// Ahlbaeck, Kohn, ICCV 2025), and of cameras that are calibrated in part. proofs/families.md proves
// that these lists are complete.
#pragma once

#include "prover/problem/problem.h"

#include <string>
#include <vector>

namespace plprove {

/// The name of the family of a kind: `plmp`, or that of the cameras.
std::string_view family_name(const CameraModel& cameras);

/// The cameras of the family with this name; null if there is none.
const CameraModel* family_named(std::string_view name);

/// The problems of a kind's family as certs/FORMAT.md, section 13, defines it: one of each class of
/// isomorphic problems, by ascending numbers of views, of points, and of lines without points.
std::vector<Problem> family_problems(const CameraModel& cameras);

/// The numbers in a problem's name: with `alpha`, `3002_1` in PLMP.
struct PlmpNumbers {
    int free_points = 0;
    int dependent_points = 0;
    int free_lines = 0;
    int adjacent_lines = 0;
    /// The most adjacent lines at one point; in two views the most points on one line.
    int alpha = 0;
};
PlmpNumbers counts(const Problem& problem);

/// The name in PLMP's Table 1: `3002_1`. Other problems may have the same name.
std::string name(const Problem& problem);

} // namespace plprove
