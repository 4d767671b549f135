// Solutions of the same images, told apart.
#pragma once

#include "prover/multiview/system.h"

#include <cmath>
#include <map>
#include <optional>

namespace plprove::multiview {

/// Different solutions, in the order in which they are added.
class SolutionSet {
public:
    int size() const { return static_cast<int>(points_.size()); }
    const std::vector<Point>& points() const { return points_; }
    const Point& operator[](int index) const { return points_[static_cast<std::size_t>(index)]; }

    std::optional<int> find(const Point& point) const {
        const double radius = near * (1 + point.norm());
        const double centre = key(point);
        const double width = 2 * radius * std::sqrt(static_cast<double>(point.size()));
        for (auto i = by_key_.lower_bound(centre - width);
             i != by_key_.end() && i->first <= centre + width; ++i)
            if (((*this)[i->second] - point).norm() < radius) return i->second;
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

    std::vector<Point> points_;
    std::multimap<double, int> by_key_;
};

} // namespace plprove::multiview
