// Solutions of the same images, told apart.
#pragma once

#include "prover/multiview/system.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

namespace plprove::multiview {

/// Whether all coordinates of two points are near, each relative to its size.
inline bool are_near(const Point& a, const Point& b, double tolerance) {
    return ((a - b).array().abs() < tolerance * (1 + b.array().abs())).all();
}

/// When two approximations are of one solution: if they are near relative to the size of the whole
/// point, or if all coordinates are. The latter tells solutions apart where a coordinate is large,
/// and is for points that Newton's method has refined.
enum class Nearness : std::uint8_t { of_points, of_coordinates };

/// Different solutions, in the order in which they are added.
class SolutionSet {
public:
    explicit SolutionSet(Nearness nearness = Nearness::of_points) : nearness_(nearness) {}

    int size() const { return static_cast<int>(points_.size()); }
    const std::vector<Point>& points() const { return points_; }
    const Point& operator[](int index) const { return points_[static_cast<std::size_t>(index)]; }

    std::optional<int> find(const Point& point) const {
        const double centre = key(point);
        // So far apart are the keys of near points at most, by either measure.
        const double root = std::sqrt(static_cast<double>(point.size()));
        const double width = 2 * near * (root + point.norm()) * root;
        for (auto i = by_key_.lower_bound(centre - width);
             i != by_key_.end() && i->first <= centre + width; ++i)
            if (is_found(point, (*this)[i->second])) return i->second;
        return std::nullopt;
    }

    int add(const Point& point) {
        by_key_.emplace(key(point), size());
        points_.push_back(point);
        return size() - 1;
    }

private:
    static constexpr double near = 1e-7; // relative distance of approximations of one solution

    /// Real and imaginary parts, added: no more apart than that for points that are near.
    static double key(const Point& point) { return point.real().sum() + point.imag().sum(); }

    bool is_found(const Point& point, const Point& known) const {
        if (nearness_ == Nearness::of_coordinates) return are_near(known, point, near);
        return (known - point).norm() < near * (1 + point.norm());
    }

    Nearness nearness_;
    std::vector<Point> points_;
    std::multimap<double, int> by_key_;
};

} // namespace plprove::multiview
