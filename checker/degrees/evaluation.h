// The camera equations at given cameras, with derivatives, and the conditions that a solution has
// to meet (FORMAT.md, section 9). Over any ring of numbers: doubles find a solution, balls prove
// it, rationals test the equations.
#pragma once

#include "checker/degrees/camera_equations.h"

#include <type_traits>

namespace checker {
/// The camera coordinates x_2 y_2 z_2 x_3 y_3 z_3 c_22 c_23 c_31 c_32 c_33, or derivatives by them.
template <class T> using CameraCoordinates = std::array<T, camera_unknowns>;

/// The integer as a number of the ring; a double close to it.
template <class T> T number(const mpz_class& x) {
    if constexpr (std::is_constructible_v<T, mpz_class>)
        return T(x);
    else
        return T(x.get_d());
}

template <class T> using Matrix3 = std::array<Vector3<T>, 3>; // by rows

template <class T> Vector3<T> product(const Matrix3<T>& matrix, const Vector3<T>& x) {
    return {dot(matrix[0], x), dot(matrix[1], x), dot(matrix[2], x)};
}

/// An image vector turned into space by the transpose of R, and the derivatives of this by x, y, z.
/// These are not set in view 1.
template <class T> struct BackProjection {
    Vector3<T> vector{}; // along a point's ray, or normal to a line's plane
    std::array<Vector3<T>, 3> derivatives{};
};

template <class T> struct BackProjections {
    std::array<Vector3<T>, 3> centres{};      // of the views
    std::vector<BackProjection<T>> vectors{}; // of the system
};

/// The transpose of R for the quaternion (1, x, y, z), and its derivatives by x, y, z.
template <class T> struct TransposedRotation {
    Matrix3<T> matrix;
    std::array<Matrix3<T>, 3> derivatives;
};

template <class T> TransposedRotation<T> transposed_rotation(const T& x, const T& y, const T& z) {
    const T one(1), two(2);
    const T xx = x * x, yy = y * y, zz = z * z;
    const T x2 = x + x, y2 = y + y, z2 = z + z;
    const T xy = x2 * y, xz = x2 * z, yz = y2 * z;
    return {
        .matrix{{{one + xx - yy - zz, xy + z2, xz - y2},
                 {xy - z2, one - xx + yy - zz, yz + x2},
                 {xz + y2, yz - x2, one - xx - yy + zz}}},
        .derivatives{{{{{x2, y2, z2}, {y2, -x2, two}, {z2, -two, -x2}}},
                      {{{-y2, x2, -two}, {x2, y2, z2}, {two, z2, -y2}}},
                      {{{-z2, two, x2}, {-two, -z2, y2}, {x2, y2, z2}}}}},
    };
}

/// Turns the image vectors of a system into space.
template <class T>
void back_project(const CameraSystem& system, const CameraCoordinates<T>& c,
                  BackProjections<T>& result) {
    const std::array rotations{transposed_rotation(c[0], c[1], c[2]),
                               transposed_rotation(c[3], c[4], c[5])};
    result.centres[1] = {T(1), c[6], c[7]};
    result.centres[2] = {c[8], c[9], c[10]};
    result.vectors.resize(system.vectors.size());
    for (std::size_t n = 0; n < system.vectors.size(); ++n) {
        const auto& [view, image] = system.vectors[n];
        BackProjection<T>& projection = result.vectors[n];
        const Vector3<T> x{number<T>(image[0]), number<T>(image[1]), number<T>(image[2])};
        if (view == 0) {
            projection.vector = x;
            continue;
        }
        const TransposedRotation<T>& rotation = rotations[view - 1];
        projection.vector = product(rotation.matrix, x);
        for (std::size_t k = 0; k < 3; ++k)
            projection.derivatives[k] = product(rotation.derivatives[k], x);
    }
}

/// One equation at given cameras: its image vectors in space, and where its derivatives go.
template <class T> class EquationAt {
public:
    EquationAt(const CameraSystem& system, const CameraEquation& equation,
               const BackProjections<T>& space, CameraCoordinates<T>& row)
        : system_(system), equation_(equation), space_(space), row_(row) {
        row_ = {};
    }

    /// The value; the derivatives by the camera coordinates go to the row.
    T evaluate() {
        switch (equation_.kind) {
        case Kind::epipolar:
            return epipolar();
        case Kind::pencil:
            return pencil();
        case Kind::incidence:
            return incidence();
        }
        return T(0);
    }

private:
    std::size_t view(std::size_t n) const { return system_.vectors[equation_.vectors[n]].view; }
    const BackProjection<T>& projection(std::size_t n) const {
        return space_.vectors[equation_.vectors[n]];
    }
    const Vector3<T>& vector(std::size_t n) const { return projection(n).vector; }
    const Vector3<T>& centre(std::size_t n) const { return space_.centres[view(n)]; }

    /// Sets the derivatives by the rotation of the n-th vector's view, from those by the vector.
    void by_vector(std::size_t n, const Vector3<T>& derivative) {
        if (view(n) == 0) return;
        const std::size_t first = 3 * (view(n) - 1);
        for (std::size_t k = 0; k < 3; ++k)
            row_[first + k] = dot(derivative, projection(n).derivatives[k]);
    }

    /// Sets the derivatives by the centre of the n-th vector's view.
    void by_centre(std::size_t n, const Vector3<T>& derivative) {
        if (view(n) == 1) { // the first coordinate is fixed
            row_[6] = derivative[1];
            row_[7] = derivative[2];
        }
        if (view(n) == 2) std::copy(derivative.begin(), derivative.end(), &row_[8]);
    }

    /// (c_i - c_j) · (b × a) for the rays a, b of two points.
    T epipolar() {
        const Vector3<T>& a = vector(0);
        const Vector3<T>& b = vector(1);
        const Vector3<T> apart = minus(centre(0), centre(1));
        const Vector3<T> normal = cross(b, a);
        by_vector(0, cross(apart, b));
        by_vector(1, cross(a, apart));
        by_centre(0, normal);
        by_centre(1, cross(a, b));
        return dot(apart, normal);
    }

    /// c · (b × a) for the normals a, b, c of three planes.
    T pencil() {
        const Vector3<T>& a = vector(0);
        const Vector3<T>& b = vector(1);
        const Vector3<T>& c = vector(2);
        const Vector3<T> normal = cross(b, a);
        by_vector(0, cross(c, b));
        by_vector(1, cross(a, c));
        by_vector(2, normal);
        return dot(c, normal);
    }

    /// For the ray a of a point and the normals b, c of two planes: both meet the ray where
    /// (b · (c_i - c_j)) (c · a) = (c · (c_i - c_k)) (b · a).
    T incidence() {
        const Vector3<T>& a = vector(0);
        const Vector3<T>& b = vector(1);
        const Vector3<T>& c = vector(2);
        const Vector3<T> to_b = minus(centre(0), centre(1));
        const Vector3<T> to_c = minus(centre(0), centre(2));
        const T b_apart = dot(b, to_b), c_apart = dot(c, to_c);
        const T b_ray = dot(b, a), c_ray = dot(c, a);
        by_vector(0, minus(times(b_apart, c), times(c_apart, b)));
        by_vector(1, minus(times(c_ray, to_b), times(c_apart, a)));
        by_vector(2, minus(times(b_apart, a), times(b_ray, to_c)));
        by_centre(0, minus(times(c_ray, b), times(b_ray, c)));
        by_centre(1, times(T(-c_ray), b));
        by_centre(2, times(b_ray, c));
        return b_apart * c_ray - c_apart * b_ray;
    }

    const CameraSystem& system_;
    const CameraEquation& equation_;
    const BackProjections<T>& space_;
    CameraCoordinates<T>& row_;
};

/// The value of an equation; its derivatives by the camera coordinates go to `row`.
template <class T>
T evaluate(const CameraSystem& system, const CameraEquation& equation,
           const BackProjections<T>& space, CameraCoordinates<T>& row) {
    return EquationAt<T>(system, equation, space, row).evaluate();
}
} // namespace checker
