// The conditions that constraints put on the rotation R and the translation t of the camera to be
// registered (FORMAT.md, section 10): coefficients · t + free term = 0, with polynomials in R.
#pragma once

#include "checker/bounds/constraints.h"
#include "checker/bounds/rotation_ring.h"

#include <functional>
#include <optional>

namespace checker {
struct Condition {
    std::optional<Bidegree> free_degree{}; // for arbitrary data; none if the free term is 0
    bool ray = false;  // whether the coefficients have the degree of R; else they are constants
    bool axis = false; // whether they are those of the line that the frame distinguishes
    std::array<Polynomial, 4> row{}; // the coefficients at t, then the free term
};

/// A polynomial that vanishes at the solutions, and its degree for arbitrary data. The polynomial
/// is computed when it is asked for: most templates use few of their equations.
struct RotationEquation {
    std::function<Polynomial()> polynomial{};
    Bidegree degree{};
};

/// The rotations of a frame, as polynomials.
class FrameRotations {
public:
    explicit FrameRotations(Frame frame) : ring(frame == Frame::general), matrix_(ring.matrix()) {}

    const RotationRing ring;

    /// l · R x
    Polynomial rotated(const IntegerVector& l, const IntegerVector& x) const {
        Polynomial sum;
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column)
                ring.add(sum, matrix_[3 * row + column], residue(l[row] * x[column]));
        return sum;
    }

    /// The point x lies on the image line l: l · (R x + t) = 0.
    Condition incident(const IntegerVector& x, const IntegerVector& l,
                       std::optional<Bidegree> free_degree) const {
        Condition condition{.free_degree = free_degree};
        for (std::size_t i = 0; i < 3; ++i)
            condition.row[i] = constant(residue(l[i]));
        if (free_degree) condition.row[3] = rotated(l, x);
        return condition;
    }

    /// The ray of x meets the line through X with direction D: x · ((R X + t) × R D) = 0.
    Condition meeting(const IntegerVector& point, const Ray& ray) const {
        Condition condition{.free_degree = ring.unit(), .ray = true};
        for (std::size_t i = 0; i < 3; ++i) {
            IntegerVector axis;
            axis[i] = 1;
            condition.row[i] = rotated(cross(ray.image, axis), ray.direction);
        }
        condition.row[3] = rotated(ray.image, cross(point, ray.direction));
        return condition;
    }

private:
    std::array<Polynomial, 9> matrix_;
};

/// The conditions of a template, in the order of its constraints. `frame` may be any that
/// check_frame accepts (template_equations.h) for the constraints.
std::vector<Condition> conditions_of(const Constraints& constraints,
                                     const FrameRotations& rotations);

/// Determinants of sets of conditions; a set is given by its bits.
class Determinants {
public:
    Determinants(const RotationRing& ring, const std::vector<Condition>& conditions)
        : ring_(ring), conditions_(conditions) {}

    /// Of three conditions (their coefficients at t), or of four.
    Polynomial of(unsigned set) const;

    /// The degree of a determinant for arbitrary data.
    Bidegree degree(unsigned set) const;

    /// The determinants of `size` conditions among those from `first` up to `end`, in
    /// colexicographic order. They need this object.
    std::vector<RotationEquation> all(int size, std::size_t first, std::size_t end) const;

private:
    Bidegree degree_of_three(unsigned set) const;

    const RotationRing& ring_;
    const std::vector<Condition>& conditions_;
};
} // namespace checker
