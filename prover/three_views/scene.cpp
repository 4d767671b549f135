#include "prover/three_views/scene.h"

#include <algorithm>

namespace plprove {

namespace {

double norm(const Complex3& a) {
    double square = 0;
    for (const Complex& x : a)
        square += std::norm(x);
    return std::sqrt(square);
}

Complex dot(const Complex3& a, const Complex3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Complex3 along(const Complex3& a, const Complex& s, const Complex3& d) {
    return {a[0] + s * d[0], a[1] + s * d[1], a[2] + s * d[2]};
}

} // namespace

double nondegeneracy(const CameraSystem& system, const std::vector<Complex3>& vectors,
                     const QuaternionCameras& cameras) {
    double least = 1;
    const auto require = [&](double value, double scale) {
        least = std::min(least, value / scale);
    };
    for (const auto& q : cameras.quaternion) {
        Complex sum = 0;
        double size = 0;
        for (const Complex& x : q) {
            sum += x * x;
            size += std::norm(x);
        }
        require(std::abs(sum), size);
    }
    const std::array<Complex3, 3> centre{Complex3{}, cameras.centre[0], cameras.centre[1]};
    std::vector<Complex3> direction;
    for (std::size_t v = 0; v < vectors.size(); ++v) {
        const auto view = static_cast<std::size_t>(system.vectors[v].view);
        direction.push_back(view == 0 ? vectors[v]
                                      : rotate_back(cameras.quaternion[view - 1], vectors[v]));
    }
    const auto meeting = [&](std::size_t ray, std::size_t plane) {
        require(std::abs(dot(direction[ray], direction[plane])),
                norm(direction[ray]) * norm(direction[plane]));
    };
    for (const CameraEquation& equation : system.equations)
        if (equation.kind == EquationKind::incidence)
            for (const std::size_t k : {1U, 2U})
                meeting(static_cast<std::size_t>(equation.vectors[0]),
                        static_cast<std::size_t>(equation.vectors[k]));
    for (const Triangulation& triangulation : system.triangulations) {
        const auto ray = static_cast<std::size_t>(triangulation.ray);
        const auto plane = static_cast<std::size_t>(triangulation.plane);
        meeting(ray, plane);
        const Complex3& from = centre[static_cast<std::size_t>(system.vectors[ray].view)];
        const Complex3& through = centre[static_cast<std::size_t>(system.vectors[plane].view)];
        const Complex3& d = direction[ray];
        const Complex depth =
            dot(direction[plane], along(through, -1.0, from)) / dot(direction[plane], d);
        const Complex3 point = along(from, depth, d);
        for (std::size_t v = 0; v < 3; ++v) {
            const Complex3 seen = along(point, -1.0, centre[v]);
            const double scale = norm(point) + norm(centre[1]) + norm(centre[2]);
            if (triangulation.sees_point[v]) require(norm(seen), scale);
            for (const auto& line : triangulation.lines) {
                if (line[v] < 0) continue;
                std::vector<std::size_t> planes;
                for (const int vector : line)
                    if (vector >= 0) planes.push_back(static_cast<std::size_t>(vector));
                const Complex3 &first = direction[planes[0]], &second = direction[planes[1]];
                require(norm(cross(seen, cross(first, second))),
                        scale * norm(first) * norm(second));
            }
        }
    }
    return least;
}

} // namespace plprove
