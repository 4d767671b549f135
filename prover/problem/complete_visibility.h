// The balanced problems of two papers with complete visibility: calibrated cameras (PLMP: Duff,
// Kohn, Leykin, Pajdla, ICCV 2019) and projective ones (Kiehn, Ahlbaeck, Kohn, ICCV 2025).
// proofs/families.md proves that these lists are complete.
#pragma once

#include "prover/problem/problem.h"

#include <string>
#include <vector>

namespace plprove {

/// All balanced problems for a kind of cameras. That the first two bounds leave none out is a
/// theorem: proofs/families.md, section 6. The third one is part of the definition.
struct Family {
    std::string_view name;
    const CameraModel* cameras = nullptr;
    int most_views = 0;
    int most_points = 0;
    int most_views_of_seven_points = 0; ///< or more

    static const Family plmp, projective;
};

inline constexpr Family Family::plmp{"plmp", &calibrated_cameras, 6, 5, 0};
inline constexpr Family Family::projective{"projective", &projective_cameras, 9, 8, 3};
inline constexpr std::array listed_families{&Family::plmp, &Family::projective};

/// The family's problems as certs/FORMAT.md, section 13, defines them: one of each class of
/// isomorphic problems, by ascending numbers of views, of points, and of lines without points.
std::vector<Problem> family_problems(const Family& family);

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
