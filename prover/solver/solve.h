// From images to all cameras and scenes that explain them.
#pragma once

#include "prover/solver/camera_solver.h"
#include "prover/solver/plan.h"
#include "prover/solver/reconstruction.h"

namespace plprove {

/// On what grounds the solutions found are all: the number of solutions for generic images bounds
/// those for any.
enum class Completeness {
    certified, ///< their number is the degree, which is certified (certs/degrees.csv)
    evidence,  ///< it is, and the degree is known by evidence (certs/family-degrees.csv)
    unknown    ///< fewer
};

std::string_view name(Completeness completeness);

struct Answer {
    int degree = 0; ///< how many solutions generic images have, as far as is known
    int found = 0;  ///< different ones, counted over the complex numbers
    int lost = 0;   ///< how many fewer than the degree
    Completeness complete = Completeness::unknown;
    std::vector<Solution> solutions; ///< real ones first, those with most points in front first
    /// All zeros of the camera equations, in the standard chart; in three views only.
    std::vector<CameraPoint> zeros;
};

/// Drops what rounding errors have made of images of extreme size; puts the real solutions first,
/// those with most points in front before the others.
void finish(Answer& answer, const SeenImages& images);

struct SolveOptions {
    SearchOptions search;
    bool complex = true;    ///< also reconstruct the solutions that are not real
    bool conditions = true; ///< also estimate the conditions of those that are
};

/// Solves one problem for any number of images. Its functions may be called by several threads at
/// once.
class Solver {
public:
    /// certs/models/registrations has a model whose file proves that there are no more.
    static constexpr int poses_of_five_points = 20;

    /// For three views: `start` must be of the label class of the plan. Throws BadInput if not.
    Solver(SolvePlan plan, Start start);
    /// For two views.
    explicit Solver(SolvePlan plan);

    const SolvePlan& plan() const { return plan_; }
    /// How many solutions generic images have, as far as is known.
    int degree() const { return cameras_ ? start().degree() : poses_of_five_points; }
    // In three views:
    const CameraSystem& system() const { return cameras_->system(); }
    const Start& start() const { return cameras_->start(); }

    /// Assumes that the observation has what the problem says that the views see.
    Answer solve(const SeenImages& images, const SolveOptions& options) const;

    /// The same, where the cameras are those for images of the class that are near: unit vectors as
    /// class_images has them. In three views.
    Answer solve(const SeenImages& images, const std::vector<Eigen::Vector3d>& class_images,
                 const SolveOptions& options) const;

private:
    Answer solve_two_views(const SeenImages& images, const SolveOptions& options) const;

    SolvePlan plan_;
    std::optional<CameraSolver> cameras_;
    bool certified_degree_ = false;
};

/// The solver of a problem with the start from the cache, which is made if need be (start.h).
/// Throws BadInput where the problem cannot be solved (plan.h).
Solver make_solver(const Features& problem);

} // namespace plprove
