#include "prover/three_views/camera_system.h"

#include "prover/problem/feature.h"

#include <stdexcept>

namespace plprove {

QuaternionCameras conjugate(const QuaternionCameras& cameras) {
    QuaternionCameras result = cameras;
    for (auto& quaternion : result.quaternion)
        for (Complex& x : quaternion)
            x = std::conj(x);
    for (Complex3& centre : result.centre)
        for (Complex& x : centre)
            x = std::conj(x);
    return result;
}

QuaternionCameras CameraChart::cameras(const CameraPoint& point) const {
    QuaternionCameras result;
    for (std::size_t v = 0; v < 2; ++v) {
        auto& q = result.quaternion[v];
        q[0] = 1.0;
        for (std::size_t k = 0; k < 3; ++k) {
            q[k + 1] = point[3 * v + k];
            q[0] -= rotation[v][k] * q[k + 1];
        }
    }
    Complex first = 1.0;
    for (std::size_t k = 0; k < 5; ++k) {
        first -= centre[k] * point[6 + k];
        result.centre[(k + 1) / 3][(k + 1) % 3] = point[6 + k];
    }
    result.centre[0][0] = first;
    return result;
}

CameraPoint CameraChart::point(const QuaternionCameras& cameras) const {
    CameraPoint result;
    for (std::size_t v = 0; v < 2; ++v) {
        const auto& q = cameras.quaternion[v];
        Complex form = q[0];
        for (std::size_t k = 0; k < 3; ++k)
            form += rotation[v][k] * q[k + 1];
        for (std::size_t k = 0; k < 3; ++k)
            result[3 * v + k] = q[k + 1] / form;
    }
    Complex form = cameras.centre[0][0];
    for (std::size_t k = 0; k < 5; ++k)
        form += centre[k] * cameras.centre[(k + 1) / 3][(k + 1) % 3];
    for (std::size_t k = 0; k < 5; ++k)
        result[6 + k] = cameras.centre[(k + 1) / 3][(k + 1) % 3] / form;
    return result;
}

CameraChart standard_chart() {
    return {};
}

namespace {

/// Adds the vectors and equations of one feature after the other.
class Builder {
public:
    explicit Builder(const Signature& signature) {
        for (std::size_t index = 0; index < feature_count; ++index)
            for (int copy = 0; copy < signature[index]; ++copy)
                add(standard_features()[index]);
        if (system_.equations.size() != camera_dimension)
            throw std::logic_error("camera equations of a problem that is not balanced");
    }
    CameraSystem take() { return std::move(system_); }

private:
    int add_free(int view, int line, bool toward) {
        const int feature = static_cast<int>(system_.features.size()) - 1;
        system_.free.push_back({feature, view, line, toward});
        return static_cast<int>(system_.free.size()) - 1;
    }
    int add_vector(int view, VectorKind kind, int base, int other = 0) {
        system_.vectors.push_back({view, kind, base, other});
        return static_cast<int>(system_.vectors.size()) - 1;
    }
    /// The auxiliary line through an image point, or the auxiliary point on an image line.
    int across(int vector) {
        return add_vector(system_.vectors[static_cast<std::size_t>(vector)].view,
                          VectorKind::across, vector, system_.constants++);
    }
    void epipolar(int x, int y) {
        system_.equations.push_back({EquationKind::epipolar, {x, y, -1}});
    }
    void incidence(int ray, int plane, int other) {
        system_.equations.push_back({EquationKind::incidence, {ray, plane, other}});
    }
    void pencil(int l, int m, int n) {
        system_.equations.push_back({EquationKind::pencil, {l, m, n}});
    }

    void triangulate(const CameraEquation& meet) {
        system_.triangulations.push_back({meet.vectors[0], meet.vectors[1], {}, {}});
    }

    void add(const Feature& feature) {
        system_.features.push_back(feature);
        std::array<int, 3> points{-1, -1, -1};
        std::vector<std::array<int, 3>> lines(static_cast<std::size_t>(feature.lines),
                                              {-1, -1, -1});
        for (int view = 0; view < 3; ++view) {
            const auto v = static_cast<std::size_t>(view);
            const bool through = feature.sees_point(view);
            int point = -1;
            if (through) {
                point = add_free(view, -1, false);
                points[v] = add_vector(view, VectorKind::free, point);
            }
            for (int line = 0; line < feature.lines; ++line)
                if (feature.sees_line(view, line)) {
                    const int free = add_free(view, line, through);
                    lines[static_cast<std::size_t>(line)][v] =
                        through ? add_vector(view, VectorKind::meet, point, free)
                                : add_vector(view, VectorKind::free, free);
                }
        }
        constrain(feature, points, lines);
    }

    /// The table of FORMAT.md, section 9.
    void constrain(const Feature& feature, const std::array<int, 3>& points,
                   const std::vector<std::array<int, 3>>& lines) {
        std::vector<std::size_t> seeing, others;
        for (std::size_t v = 0; v < 3; ++v)
            (points[v] >= 0 ? seeing : others).push_back(v);
        // The line that a view sees which does not see the point.
        const auto pin = [&](std::size_t v) {
            for (const auto& line : lines)
                if (line[v] >= 0) return line[v];
            return -1;
        };
        if (!feature.has_point) {
            incidence(across(lines[0][0]), lines[0][1], lines[0][2]);
            triangulate(system_.equations.back());
        } else if (seeing.size() == 3) {
            epipolar(points[0], points[1]);
            epipolar(points[0], points[2]);
            // In two statements: compilers evaluate the arguments of a call in different orders.
            const int third = across(points[2]), second = across(points[1]);
            incidence(points[0], second, third);
            triangulate(system_.equations.back());
        } else if (seeing.size() == 2) {
            const int ray = points[seeing[0]], plane = across(points[seeing[1]]);
            epipolar(ray, points[seeing[1]]);
            if (const int line = pin(others[0]); line >= 0) incidence(ray, plane, line);
            triangulate({EquationKind::incidence, {ray, plane, -1}});
        } else {
            incidence(points[seeing[0]], pin(others[0]), pin(others[1]));
            triangulate(system_.equations.back());
        }
        for (const std::size_t v : seeing)
            system_.triangulations.back().sees_point[v] = true;
        system_.triangulations.back().lines = lines;
        for (const auto& line : lines)
            if (line[0] >= 0 && line[1] >= 0 && line[2] >= 0) pencil(line[0], line[1], line[2]);
    }

    CameraSystem system_;
};

} // namespace

CameraSystem camera_system(const Signature& signature) {
    return Builder(signature).take();
}

} // namespace plprove
