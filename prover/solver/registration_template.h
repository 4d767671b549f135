// Elimination templates (prover/solver/templates/template.h) with numbers: all rotations of a
// camera that sees a known scene.
//
// A template says which multiples of the equations express all monomials up to a degree by those of
// a basis. With the numbers of a scene these multiples are the rows of a matrix. The vectors of
// values that the monomials have at the solutions span its null space. Two functions g and h of the
// rotation, times monomials of lower degree, give a pencil of matrices on this space, whose
// eigenvectors are these vectors, and the eigenvalues the values of g / h (S. Telen, B. Mourrain,
// M. Van Barel, SIAM J. Matrix Anal. Appl. 2018). As g / h is finite at infinity, solutions with
// large entries do no harm to the others; and the basis is chosen anew for each scene, by pivoting.
#pragma once

#include "prover/solver/registration_frame.h"
#include "prover/solver/templates/template.h"

namespace plprove {

class RegistrationTemplate {
public:
    explicit RegistrationTemplate(const templates::Template& found);

    templates::Frame frame() const { return frame_; }
    /// How many solutions generic scenes have at most.
    int solutions() const { return solutions_; }
    /// How many rows the matrix has.
    int size() const { return static_cast<int>(rows_.size()); }

    /// The rotations, in the coordinates of the frame, to some digits. Of a real scene one of each
    /// pair of complex conjugates. Fewer, or none, where rounding errors leave nothing. Assumes
    /// that the scene is of the type of the template, and in its frame.
    std::vector<Eigen::Matrix3cd> rotations(const KnownScene<std::complex<double>>& scene) const;

private:
    /// A monomial, as a column of the matrix, with a factor.
    struct Term {
        int column = 0;
        int coefficient = 0; ///< which one of an equation is a factor, too; not used in products
        double factor = 0;
    };
    using Terms = std::vector<Term>;
    struct Row {
        std::size_t equation = 0; ///< in used_
        Terms terms;
    };
    /// An equation that the template uses, and what takes values at the sample rotations to
    /// coefficients.
    struct Used {
        std::size_t number = 0;
        std::size_t degree = 0; ///< in interpolations_
    };

    void draw_samples(std::size_t count);
    std::size_t interpolation(const templates::BiDegree& degree);
    void add_row(const templates::BiDegree& degree, const templates::Monomial& multiplier);
    void add_products(const templates::BiDegree& degree);
    Terms terms(const templates::Polynomial& polynomial, int coefficient) const;

    template <class Scalar>
    using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

    template <class Scalar>
    std::vector<Eigen::Matrix3cd> solve(const KnownScene<Scalar>& scene) const;
    template <class Scalar>
    std::vector<Eigen::Matrix<Scalar, Eigen::Dynamic, 1>>
    coefficients(const KnownScene<Scalar>& scene) const;
    template <class Scalar>
    Matrix<Scalar> null_space(const KnownScene<Scalar>& scene) const;
    template <class Scalar>
    Matrix<Scalar> product_values(const std::vector<double>& function,
                                  const Matrix<Scalar>& basis) const;
    Eigen::Matrix3cd rotation(const Eigen::VectorXcd& values) const;

    templates::Frame frame_;
    templates::RotationRing ring_;
    int solutions_;
    std::map<templates::Monomial, int> columns_;
    std::vector<Eigen::Vector4d> samples_; ///< coordinates of rotations
    std::vector<Eigen::Matrix3d> sample_rotations_;
    std::vector<templates::BiDegree> degrees_; ///< of the interpolations
    std::vector<Eigen::MatrixXd> interpolations_;
    std::vector<Used> used_;
    std::vector<Row> rows_;
    /// For each monomial of lower degree its products with the unit monomials.
    std::vector<std::vector<Terms>> products_;
    std::vector<double> g_, h_; ///< coefficients of the unit monomials
};

} // namespace plprove
