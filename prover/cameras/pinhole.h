// Pinhole cameras whose calibration is known in part.
//
// Let K be the calibration matrix of camera 1. A motion of space makes this camera [I | 0]. If K is
// that of another camera, too, then this is [K R K^-1 | t], with a rotation R and any t. The matrix
// K R K^-1 is a *rotation of the conic* omega = (K K^T)^-1, the image of the absolute conic: it is
// a polynomial in omega and in four numbers, as a rotation is one in a quaternion. So the unknowns
// are the entries of omega, which is what images say of K.
#pragma once

#include "prover/cameras/camera_map.h"

namespace plprove {

template <class T>
using Matrix3Of = std::array<std::array<T, 3>, 3>;

/// Of a symmetric matrix: that of its cofactors.
template <class T>
Matrix3Of<T> adjugate(const Matrix3Of<T>& w) {
    Matrix3Of<T> result;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3,
                              j2 = (j + 2) % 3;
            result[i][j] = w[i1][j1] * w[i2][j2] - w[i1][j2] * w[i2][j1];
        }
    return result;
}

template <class T>
T determinant(const Matrix3Of<T>& w, const Matrix3Of<T>& adjugate) {
    return w[0][0] * adjugate[0][0] + w[0][1] * adjugate[1][0] + w[0][2] * adjugate[2][0];
}

/// (a^2 det w - v.wv) I + 2 v (wv)^T + 2 a adj(w) [v]x, for a conic w: symmetric, of rank 3. For
/// w = I it is the matrix of the quaternion (a, v).
template <class T>
Matrix3Of<T> conic_rotation(const Matrix3Of<T>& w, const T& a, const std::array<T, 3>& v) {
    const Matrix3Of<T> adjugate = plprove::adjugate(w);
    const auto times_v = [&](std::size_t i) {
        return w[i][0] * v[0] + w[i][1] * v[1] + w[i][2] * v[2];
    };
    const std::array<T, 3> wv{times_v(0), times_v(1), times_v(2)};
    const T diagonal =
        a * a * determinant(w, adjugate) - (v[0] * wv[0] + v[1] * wv[1] + v[2] * wv[2]);
    Matrix3Of<T> result;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            // Column j of [v]x is v x e_j: v[j2] in row j1, -v[j1] in row j2.
            const T half = v[i] * wv[j] + a * (adjugate[i][j1] * v[j2] - adjugate[i][j2] * v[j1]);
            result[i][j] = half + half;
        }
    for (std::size_t i = 0; i < 3; ++i)
        result[i][i] = result[i][i] + diagonal;
    return result;
}

// What is known of calibrations. `conic` is omega, a function of the shared numbers.

/// All.
struct Calibrated {
    static constexpr int shared = 0;
    template <class T>
    static Matrix3Of<T> conic(const T*) {
        const T one = in_ring<T>(1);
        return {{{one, T{}, T{}}, {T{}, one, T{}}, {T{}, T{}, one}}};
    }
};

/// All but one focal length f, or that of camera 1: e = f^2.
struct SharedFocal {
    static constexpr int shared = 1;
    template <class T>
    static Matrix3Of<T> conic(const T* e) {
        const T one = in_ring<T>(1);
        return {{{one, T{}, T{}}, {T{}, one, T{}}, {T{}, T{}, *e}}};
    }
};

/// All but one focal length and one principal point.
struct SharedFocalCenter {
    static constexpr int shared = 3;
    template <class T>
    static Matrix3Of<T> conic(const T* n) {
        const T one = in_ring<T>(1);
        return {{{one, T{}, n[0]}, {T{}, one, n[1]}, {n[0], n[1], n[2]}}};
    }
};

/// Nothing but that it is the same for all cameras.
struct SharedMatrix {
    static constexpr int shared = 5;
    template <class T>
    static Matrix3Of<T> conic(const T* n) {
        return {{{in_ring<T>(1), n[0], n[2]}, {n[0], n[1], n[3]}, {n[2], n[3], n[4]}}};
    }
};

/// A camera by a rotation of the conic, (a, v) up to a factor; t; and if it has a focal length of
/// its own, the ratio of this to that of camera 1. An upright one turns about the vertical
/// direction, v = (0, b, 0), and its ratio is r. Another one has (r, s) instead, a turn about the
/// axis of the camera and the root of r^2 + s^2 as ratio; the rotation is then about an axis in the
/// image plane, v = (b, c, 0). (As diag(-1, -1, 1) is a rotation, a ratio and minus this ratio make
/// the same matrix, with different rotations. But r, s and v are determined by the matrix.)
template <class Calibration, bool upright, bool own_focal = false>
struct Pinhole {
    static constexpr int turn = upright ? 2 : own_focal ? 3 : 4;
    static constexpr int own = !own_focal ? 0 : upright ? 1 : 2;
    static constexpr int numbers = turn + 3 + own, shared = Calibration::shared;

    /// v of (a, v).
    template <class T>
    static std::array<T, 3> axis(const T* n) {
        if constexpr (upright)
            return {T{}, n[1], T{}};
        else if constexpr (own_focal)
            return {n[1], n[2], T{}};
        else
            return {n[1], n[2], n[3]};
    }

    template <class T>
    static CameraMatrix<T> matrix(const T* n) {
        const auto left = conic_rotation<T>(Calibration::conic(n + numbers), n[0], axis(n));
        CameraMatrix<T> camera;
        for (std::size_t i = 0; i < 3; ++i)
            camera[i] = {left[i][0], left[i][1], left[i][2], n[turn + i]};
        if constexpr (own_focal)
            for (std::size_t j = 0; j < 3; ++j) {
                const T x = left[0][j], y = left[1][j], r = n[turn + 3];
                camera[0][j] = r * x;
                camera[1][j] = r * y;
                if constexpr (!upright) {
                    const T s = n[turn + 4];
                    camera[0][j] = camera[0][j] - s * y;
                    camera[1][j] = camera[1][j] + s * x;
                }
            }
        return camera;
    }

    /// The matrix is quadratic in the rotation, so t is multiplied by the square of its factor.
    static void normalise(CameraModel::Complex* n, bool second, CameraModel::Complex& depths) {
        const CameraModel::Complex scale = 1.0 / n[0];
        for (int i = 0; i < turn; ++i)
            n[i] *= scale;
        if (second) depths = scale * scale * n[turn];
        for (int i = turn; i < turn + 3; ++i)
            n[i] *= scale * scale / depths;
    }

    /// Whether none of these is 0, clearly: the number N = a^2 det w + v.wv by which the rotation
    /// is multiplied, the determinant of the conic, and the ratio of focal lengths. (N counts,
    /// not the determinant of the matrix: that is N^3, and true cameras have a small one.)
    static bool is_camera(const CameraModel::Complex* n) {
        constexpr double small = 1e-8;
        const Matrix3Of<CameraModel::Complex> w = Calibration::conic(n + numbers);
        const CameraModel::Complex det = determinant(w, adjugate(w));
        const auto v = axis(n);
        CameraModel::Complex factor = n[0] * n[0] * det;
        double terms = std::abs(factor), size = 0;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) {
                const CameraModel::Complex term = v[i] * w[i][j] * v[j];
                factor += term;
                terms += std::abs(term);
                size += std::norm(w[i][j]);
            }
        if constexpr (own_focal) {
            const CameraModel::Complex r = n[turn + 3], s = upright ? 0 : n[turn + 4];
            const double ratio = std::sqrt(std::abs(r * r + s * s));
            if (ratio < small || ratio * ratio < small * (std::norm(r) + std::norm(s)))
                return false;
        }
        return std::abs(factor) > small * terms && std::abs(det) > small * std::pow(size, 1.5);
    }

    static constexpr std::array scaled{ScaledRun{0, turn}};
    static constexpr std::array scaled_in_second{ScaledRun{0, turn}, ScaledRun{turn, 3}};

    /// The kind of these cameras.
    static constexpr CameraModel model(std::string_view name, std::string_view prefix) {
        return with_map<Pinhole>({.name = name,
                                  .prefix = prefix,
                                  .unknowns = numbers - 1,
                                  .unknowns_of_second = numbers - 2,
                                  .may_turn = !upright,
                                  .scaled = scaled,
                                  .scaled_in_second = scaled_in_second,
                                  .normalise = normalise,
                                  .is_camera = is_camera});
    }
};

} // namespace plprove
