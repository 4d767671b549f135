// The equations of cameras and scene at given coordinates, with derivatives, and the conditions
// that a solution has to meet (FORMAT.md, section 14). Over any ring of numbers: doubles find a
// solution, balls prove it, rationals test the equations.
#pragma once

#include "checker/degrees/degeneracy.h"
#include "checker/general_degrees/scene_system.h"

namespace checker {
template <class T> class SceneAt {
public:
    explicit SceneAt(const SceneSystem& system) : system_(system), depths_(system.places.size()) {}

    /// Goes to the cameras and depths with these coordinates.
    void move_to(const std::vector<T>& z) {
        cameras_.clear();
        std::size_t next = system_.second.shared;
        for (std::size_t n = 0; n < system_.cameras; ++n) {
            cameras_.push_back(camera_at(system_.form_of(n), z, next));
            next += system_.form_of(n).coordinates;
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
        const auto& [camera, line, place] = system_.equations[e];
        const auto& [x, form] = system_.places[place];
        const CameraAt& at = cameras_[camera];
        const Vector3<T> l = vector(line);
        const std::array<T, 4> point{number(x[0]), number(x[1]), number(x[2]), depths_[place]};
        std::fill(row.begin(), row.end(), T(0));
        for (const auto& [k, i, column, derivative] : at.changes)
            row[k] = row[k] + l[i] * derivative * point[column];
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
    /// How an entry of a camera matrix changes with a coordinate.
    struct Change {
        std::size_t coordinate = 0; // of all
        std::size_t row = 0, column = 0;
        T derivative{};
    };

    /// [M | t]: it takes (x, depth) to M x + depth t.
    struct CameraAt {
        CameraMatrix<T> columns{};
        std::vector<Change> changes{};
    };

    /// The camera whose own coordinates begin at this one; the shared ones are the first of all.
    static CameraAt camera_at(const CameraForm& form, const std::vector<T>& z, std::size_t first) {
        std::vector<T> own(z.begin(), z.begin() + static_cast<std::ptrdiff_t>(form.shared));
        for (std::size_t k = 0; k < form.coordinates; ++k)
            own.push_back(z[first + k]);
        CameraAt at;
        for (std::size_t column = 0; column < 4; ++column)
            for (std::size_t row = 0; row < 3; ++row)
                at.columns[column][row] = value_at(own.data(), form.matrix[column][row]);
        for (const auto& [k, row, column, derivative] : form.changes) {
            const std::size_t coordinate = k < form.shared ? k : first + k - form.shared;
            at.changes.push_back({coordinate, row, column, value_at(own.data(), derivative)});
        }
        return at;
    }

    /// The sum of two integers that doubles hold exactly: of 32 and of 31 bits.
    static T number(std::int64_t value) {
        const std::int64_t low = value % (std::int64_t{1} << 31);
        return low == value ? T(double(low)) : T(double(value - low)) + T(double(low));
    }

    static Vector3<T> vector(const ImageCoordinates& v) {
        return {number(v[0]), number(v[1]), number(v[2])};
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
} // namespace checker
