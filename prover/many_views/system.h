// The square system of a balanced problem with complete visibility: unknown are the depths and the
// coordinates of the cameras.
#pragma once

#include "prover/many_views/cameras.h"
#include "prover/many_views/incidences.h"

namespace plprove::many_views {

using Point = Eigen::VectorXcd;

/// The values of the equations, their derivatives by the unknowns and by time.
struct Evaluation {
    Eigen::VectorXcd values, speeds;
    Eigen::MatrixXcd jacobian;
};

/// Images and a point that solves the equations for them.
struct SolvedImages {
    Images<Complex> images;
    Point solution;
};

class System {
public:
    /// Assumes that the problem is balanced and that all views see everything. The chart is random.
    System(Problem problem, Random& random);
    System(Problem problem, CameraChart chart);

    const Problem& problem() const { return problem_; }
    const CameraChart& chart() const { return chart_; }
    /// The depths come first, then what all cameras share, then the coordinates of each.
    Eigen::Index depths() const { return depths_; }
    Eigen::Index unknowns() const { return depths_ + chart_.dimension(); }

    void evaluate(const Images<Moving>& images, const Point& point, Evaluation& result) const;

    /// What a step of Newton's method subtracts from the point. The evaluation is room for it.
    Point newton_step(const Images<Moving>& images, const Point& point, Evaluation& room) const;

    /// Whether the numbers of all views make cameras (CameraModel::is_camera). Paths jump to points
    /// that solve the equations, but have none.
    bool has_cameras(const Point& point) const;

    /// Images of a random scene in random cameras.
    SolvedImages random_scene(Random& random) const;

private:
    /// Sets a row of the result by an equation. The cameras are those of the point.
    void evaluate_row(Eigen::Index row, const Incidence<Moving>& equation,
                      const std::vector<CameraWithDerivatives>& cameras, const Point& point,
                      Evaluation& result) const;

    Problem problem_;
    Eigen::Index depths_;
    CameraChart chart_;
};

/// Random images with complete visibility.
Images<Complex> random_images(const Problem& problem, Random& random);

/// The same images, where each vector of the views but the first is multiplied by a random number
/// of modulus 1: solutions stay what they are, and the straight way to other images is another one.
Images<Complex> rephased(const Problem& problem, Images<Complex> images, Random& random);

} // namespace plprove::many_views
