#include "prover/degree/trace_test.h"

#include <Eigen/LU>
#include <algorithm>
#include <set>

namespace plprove {

namespace {

/// Power series in one variable up to the second power.
struct Series {
    std::array<Complex, 3> c{};
};
Series operator+(const Series& a, const Series& b) {
    return {{a.c[0] + b.c[0], a.c[1] + b.c[1], a.c[2] + b.c[2]}};
}
Series operator-(const Series& a, const Series& b) {
    return {{a.c[0] - b.c[0], a.c[1] - b.c[1], a.c[2] - b.c[2]}};
}
Series operator*(const Series& a, const Series& b) {
    return {{a.c[0] * b.c[0], a.c[0] * b.c[1] + a.c[1] * b.c[0],
             a.c[0] * b.c[2] + a.c[1] * b.c[1] + a.c[2] * b.c[0]}};
}
using Series3 = std::array<Series, 3>;

Series constant(const Complex& x) {
    return {{x, 0.0, 0.0}};
}
Series3 constant(const Complex3& x) {
    return {constant(x[0]), constant(x[1]), constant(x[2])};
}
Series dot(const Series3& a, const Series3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Series3 cross(const Series3& a, const Series3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Series3 operator-(const Series3& a, const Series3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Cameras that move along a power series.
struct SeriesCameras {
    std::array<std::array<Series3, 3>, 3> rotation;
    std::array<Series3, 3> centre;

    SeriesCameras(const CameraChart& chart, const std::array<Series, camera_dimension>& point) {
        for (std::size_t v = 1; v < 3; ++v) {
            std::array<Series, 4> q;
            q[0] = constant(1.0);
            for (std::size_t k = 0; k < 3; ++k) {
                q[k + 1] = point[3 * (v - 1) + k];
                q[0] = q[0] - constant(chart.rotation[v - 1][k]) * q[k + 1];
            }
            const auto& [a, b, c, d] = q;
            const Series two = constant(2.0);
            rotation[v] = {
                {{a * a + b * b - c * c - d * d, two * (b * c - a * d), two * (b * d + a * c)},
                 {two * (b * c + a * d), a * a - b * b + c * c - d * d, two * (c * d - a * b)},
                 {two * (b * d - a * c), two * (c * d + a * b), a * a - b * b - c * c + d * d}}};
        }
        centre[1][0] = constant(1.0);
        for (std::size_t k = 0; k < 5; ++k) {
            centre[1][0] = centre[1][0] - constant(chart.centre[k]) * point[6 + k];
            centre[1 + (k + 1) / 3][(k + 1) % 3] = point[6 + k];
        }
    }

    Series3 back(int view, const Complex3& image) const {
        const Series3 x = constant(image);
        if (view == 0) return x;
        const auto& r = rotation[static_cast<std::size_t>(view)];
        Series3 result;
        for (std::size_t k = 0; k < 3; ++k)
            result[k] = r[0][k] * x[0] + r[1][k] * x[1] + r[2][k] * x[2];
        return result;
    }
};

/// The left hand side of an equation, with `instead` in the place of vector `replaced`.
Series value(const CameraSystem& system, const std::vector<Complex3>& vectors,
             const CameraEquation& equation, const SeriesCameras& cameras, int replaced = -1,
             const Complex3& instead = {}) {
    std::array<Series3, 3> x;
    std::array<Series3, 3> centre;
    for (std::size_t k = 0; k < (equation.kind == EquationKind::epipolar ? 2 : 3); ++k) {
        const auto v = static_cast<std::size_t>(equation.vectors[k]);
        const int view = system.vectors[v].view;
        x[k] = cameras.back(view, equation.vectors[k] == replaced ? instead : vectors[v]);
        centre[k] = cameras.centre[static_cast<std::size_t>(view)];
    }
    switch (equation.kind) {
    case EquationKind::epipolar:
        return dot(centre[1] - centre[0], cross(x[0], x[1]));
    case EquationKind::incidence:
        return dot(x[1], centre[0] - centre[1]) * dot(x[2], x[0]) -
               dot(x[2], centre[0] - centre[2]) * dot(x[1], x[0]);
    default:
        return dot(x[0], cross(x[1], x[2]));
    }
}

using Matrix = Eigen::Matrix<Complex, camera_dimension, camera_dimension>;
using Vector = Eigen::Matrix<Complex, camera_dimension, 1>;

std::array<Series, camera_dimension> curve(const CameraPoint& point, const Vector& first,
                                           const Vector& second) {
    std::array<Series, camera_dimension> result;
    for (std::size_t k = 0; k < point.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        result[k] = {{point[k], first[row], second[row]}};
    }
    return result;
}

Vector coefficient(const CameraSystem& system, const std::vector<Complex3>& vectors,
                   const SeriesCameras& cameras, std::size_t power) {
    Vector result;
    for (std::size_t e = 0; e < system.equations.size(); ++e)
        result[static_cast<Eigen::Index>(e)] =
            value(system, vectors, system.equations[e], cameras).c[power];
    return result;
}

Matrix jacobian(const CameraSystem& system, const std::vector<Complex3>& vectors,
                const CameraChart& chart, const CameraPoint& point) {
    Matrix result;
    for (Eigen::Index column = 0; column < camera_dimension; ++column) {
        const SeriesCameras cameras(chart, curve(point, Vector::Unit(column), Vector::Zero()));
        result.col(column) = coefficient(system, vectors, cameras, 1);
    }
    return result;
}

/// Moving a vector: which equation and vector of the system it is, and where it moves.
struct Pencil {
    int vector;
    Eigen::Index equation;
    Complex3 direction, other; ///< m and m'
};

/// One for each kind of equation and choice of views: images that move in one view only may leave a
/// part of the problem as it is.
std::vector<Pencil> pencils(const CameraSystem& system, Random& random) {
    std::vector<Pencil> result;
    std::set<std::pair<EquationKind, std::array<int, 3>>> covered;
    for (int v = 0; v < static_cast<int>(system.vectors.size()); ++v) {
        const ImageVector& vector = system.vectors[static_cast<std::size_t>(v)];
        if (vector.kind != VectorKind::free) continue;
        const int index = system.free[static_cast<std::size_t>(vector.base)].single_equation;
        if (index < 0) continue;
        const CameraEquation& equation = system.equations[static_cast<std::size_t>(index)];
        std::array<int, 3> views{-1, -1, -1};
        for (std::size_t k = 0; k < 3; ++k)
            if (equation.vectors[k] >= 0)
                views[k] = system.vectors[static_cast<std::size_t>(equation.vectors[k])].view;
        if (!covered.emplace(equation.kind, views).second) continue;
        const Complex3 direction = random.complex3();
        result.push_back({v, index, direction, random.complex3()});
    }
    return result;
}

} // namespace

std::optional<double> trace_residual(const CameraSystem& system, const CameraChart& chart,
                                     const std::vector<Complex3>& constants, const Images& images,
                                     std::span<const CameraPoint> solutions, Random& random) {
    const std::vector<Pencil> moving = pencils(system, random);
    if (moving.empty()) return std::nullopt;
    const std::vector<Complex3> vectors = image_vectors(system, constants, images);
    std::vector<Complex> sum(moving.size());
    std::vector<double> size(moving.size(), 0.0);
    for (const CameraPoint& point : solutions) {
        const Eigen::PartialPivLU<Matrix> lu(jacobian(system, vectors, chart, point));
        for (std::size_t p = 0; p < moving.size(); ++p) {
            const Pencil& pencil = moving[p];
            const CameraEquation& equation =
                system.equations[static_cast<std::size_t>(pencil.equation)];
            const auto part = [&](const SeriesCameras& cameras, const Complex3& instead) {
                return value(system, vectors, equation, cameras, pencil.vector, instead);
            };
            // x(s) = x + s x1 + s^2 x2 from the coefficients of F(x(s)) + s G(m)(x(s)) e = 0.
            const SeriesCameras still(chart, curve(point, Vector::Zero(), Vector::Zero()));
            const Vector first =
                lu.solve(Vector::Unit(pencil.equation) * -part(still, pencil.direction).c[0]);
            const SeriesCameras line(chart, curve(point, first, Vector::Zero()));
            Vector rest = coefficient(system, vectors, line, 2);
            rest[pencil.equation] += part(line, pencil.direction).c[1];
            const Vector second = lu.solve(-rest);
            const SeriesCameras parabola(chart, curve(point, first, second));
            const Series above = part(parabola, pencil.other),
                         below = part(parabola, pencil.direction);
            const Complex quotient = above.c[0] / below.c[0];
            const Complex slope = (above.c[1] - quotient * below.c[1]) / below.c[0];
            const Complex bend =
                (above.c[2] - quotient * below.c[2] - slope * below.c[1]) / below.c[0];
            sum[p] += bend;
            // Where phi is linear for each solution, its second derivative is nothing but rounding.
            constexpr double rounding = 1e-6;
            size[p] += std::abs(bend) + rounding * (std::abs(slope) + std::abs(quotient));
        }
    }
    double residual = 0;
    for (std::size_t p = 0; p < moving.size(); ++p)
        residual = std::max(residual, std::abs(sum[p]) / size[p]);
    return residual;
}

} // namespace plprove
