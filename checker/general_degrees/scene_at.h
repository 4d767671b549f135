// The equations of cameras and scene at given coordinates, with derivatives, and the conditions
// that a solution has to meet (FORMAT.md, section 14). Over any ring of numbers: doubles find a
// solution, balls prove it, rationals test the equations.
#pragma once

#include "checker/degrees/degeneracy.h"
#include "checker/general_degrees/scene_system.h"

namespace checker::general {
template <class T> class SceneAt {
public:
    explicit SceneAt(const SceneSystem& system) : system_(system), depths_(system.places.size()) {}

    /// Goes to the cameras and depths with these coordinates.
    void move_to(const std::vector<T>& z) {
        cameras_.clear();
        std::size_t next = 0;
        for (std::size_t n = 0; n < system_.cameras; ++n) {
            cameras_.push_back(system_.projective ? projective(&z[next], n)
                                                  : calibrated(&z[next], n));
            cameras_[n].first = next;
            next += system_.coordinates_of(n);
        }
        first_depth_ = next;
        for (std::size_t p = 0; p < depths_.size(); ++p) {
            depths_[p] = T(0);
            const DepthForm& form = system_.places[p].depth;
            for (std::size_t k = 0; k < form.size(); ++k)
                if (form[k] != 0) depths_[p] = depths_[p] + number(form[k]) * z[first_depth_ + k];
        }
    }

    /// The value of an equation there; its derivatives by the coordinates go to the row.
    T equation(std::size_t e, std::vector<T>& row) const {
        const auto& [camera, line, place] = system_.incidences[e];
        const auto& [x, form] = system_.places[place];
        const CameraAt& at = cameras_[camera];
        const Vector3<T> l = vector(line);
        const std::array<T, 4> point{number(x[0]), number(x[1]), number(x[2]), depths_[place]};
        std::fill(row.begin(), row.end(), T(0));
        derive_by_camera(row, at, l, point);
        const T by_depth = dot(l, at.columns[3]);
        for (std::size_t k = 0; k < form.size(); ++k)
            if (form[k] != 0) row[first_depth_ + k] = number(form[k]) * by_depth;
        return dot(l, image(at, place));
    }

    /// Which condition on a solution is not proved; empty if all are.
    std::string_view degeneracy() const {
        for (const CameraAt& camera : cameras_) {
            if (!has_rank_three(camera)) return "a camera may have a rank less than 3";
            for (std::size_t p = 0; p < system_.points; ++p)
                if (!nonzero(image(camera, p))) return "a point may be the centre of a camera";
            for (const auto& [a, b] : system_.lines)
                if (!nonzero(cross(image(camera, a), image(camera, b))))
                    return "a line may meet the centre of a camera";
        }
        return {};
    }

private:
    /// [M | t]: it takes (x, depth) to M x + depth t.
    struct CameraAt {
        std::array<Vector3<T>, 4> columns{};
        std::array<Matrix3<T>, 3> turned{}; // of a calibrated one: M derived by x, y, z, by columns
        std::size_t first = 0;              // of its coordinates
        std::size_t fixed = 0;              // of the numbers that make it, the first
    };

    /// The sum of two integers that doubles hold exactly: of 32 and of 31 bits.
    static T number(std::int64_t value) {
        const std::int64_t low = value % (std::int64_t{1} << 31);
        return low == value ? T(double(low)) : T(double(value - low)) + T(double(low));
    }

    static Vector3<T> vector(const ImageCoordinates& v) {
        return {number(v[0]), number(v[1]), number(v[2])};
    }

    /// x, y, z of the quaternion (1, x, y, z), then t; of camera 0 without t_1, which is 1.
    static CameraAt calibrated(const T* z, std::size_t camera) {
        const TransposedRotation<T> rotation = transposed_rotation(z[0], z[1], z[2]);
        CameraAt at;
        std::copy(rotation.matrix.begin(), rotation.matrix.end(), at.columns.begin());
        at.turned = rotation.derivatives;
        at.fixed = camera == 0 ? 1 : 0;
        at.columns[3] = camera == 0 ? Vector3<T>{T(1), z[3], z[4]} : Vector3<T>{z[3], z[4], z[5]};
        return at;
    }

    /// The entries row by row, without the first: 1; of camera 0 without 0, 0, 0, 1, 1.
    static CameraAt projective(const T* z, std::size_t camera) {
        CameraAt at;
        at.fixed = camera == 0 ? 5 : 1;
        for (std::size_t entry = 0; entry < 12; ++entry) {
            const bool is_one = camera != 0 || entry >= 3;
            const T fixed(is_one ? 1 : 0);
            at.columns[entry % 4][entry / 4] = entry < at.fixed ? fixed : z[entry - at.fixed];
        }
        return at;
    }

    /// Sets the derivatives of l · (M x + depth t) by the coordinates of the camera.
    void derive_by_camera(std::vector<T>& row, const CameraAt& at, const Vector3<T>& l,
                          const std::array<T, 4>& point) const {
        if (system_.projective) {
            for (std::size_t entry = at.fixed; entry < 12; ++entry)
                row[at.first + entry - at.fixed] = l[entry / 4] * point[entry % 4];
            return;
        }
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t column = 0; column < 3; ++column)
                row[at.first + k] =
                    row[at.first + k] + dot(l, at.turned[k][column]) * point[column];
        for (std::size_t i = at.fixed; i < 3; ++i)
            row[at.first + 3 + i - at.fixed] = l[i] * point[3];
    }

    /// Where the camera sees a place: M x + depth t.
    Vector3<T> image(const CameraAt& at, std::size_t place) const {
        Vector3<T> sum = times(depths_[place], at.columns[3]);
        for (std::size_t i = 0; i < 3; ++i)
            sum = plus(sum, times(number(system_.places[place].x[i]), at.columns[i]));
        return sum;
    }

    /// Whether some three columns are proved to be independent.
    static bool has_rank_three(const CameraAt& at) {
        const auto& [a, b, c, d] = at.columns;
        const Vector3<T> ab = cross(a, b), cd = cross(c, d);
        return nonzero(dot(ab, c)) || nonzero(dot(ab, d)) || nonzero(dot(a, cd)) ||
               nonzero(dot(b, cd));
    }

    const SceneSystem& system_;
    std::vector<CameraAt> cameras_{};
    std::vector<T> depths_; // of the places
    std::size_t first_depth_ = 0;
};
} // namespace checker::general
