// Solutions that are known only approximately, told apart and found again.
#pragma once

#include <cmath>
#include <complex>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace plprove {

/// The relative distance of approximations of one solution, where paths end.
inline constexpr double near_at_path_ends = 1e-6;

/// The length of a point, where the coordinate that its chart fixes counts as 1.
template <class Point>
double length_with_one(const Point& point) {
    double sum = 1;
    for (const std::complex<double>& x : point)
        sum += std::norm(x);
    return std::sqrt(sum);
}

/// Whether two points, with equally many coordinates, are near relative to their length.
template <class Point>
bool approximates(const Point& point, const Point& other, double near = near_at_path_ends) {
    double distance = 0;
    auto x = point.begin();
    for (const std::complex<double>& y : other)
        distance += std::norm(*x++ - y);
    const double radius = near * length_with_one(point);
    return distance < radius * radius;
}

/// Whether all coordinates of two points are near, each relative to its size.
template <class Point>
bool has_near_coordinates(const Point& point, const Point& other, double near) {
    auto x = point.begin();
    for (const std::complex<double>& y : other)
        if (!(std::abs(*x++ - y) < near * (1 + std::abs(y)))) return false;
    return true;
}

/// When two approximations are of one solution: if they are near relative to the size of the whole
/// point, or if all coordinates are. The latter tells solutions apart where a coordinate is large,
/// and is for points that Newton's method has refined.
enum class Nearness : std::uint8_t { of_points, of_coordinates };

/// Different solutions for the same images, in the order in which they are added. A Point is a
/// range of complex numbers.
template <class Point>
class SolutionSet {
public:
    /// `near` is the relative distance of approximations of one solution.
    explicit SolutionSet(double near = near_at_path_ends, Nearness nearness = Nearness::of_points)
        : near_(near), nearness_(nearness) {}

    int size() const { return static_cast<int>(points_.size()); }
    const Point& operator[](int index) const { return points_[static_cast<std::size_t>(index)]; }
    const std::vector<Point>& points() const { return points_; }

    /// The index of the solution that the point approximates.
    std::optional<int> find(const Point& point) const {
        // The keys of near points are that near, by either measure (Cauchy-Schwarz).
        const double root = std::sqrt(static_cast<double>(point.size()));
        const double width = 1.2 * near_ * root * (root + length_with_one(point));
        const double centre = key(point);
        for (auto i = by_key_.lower_bound(centre - width);
             i != by_key_.end() && i->first <= centre + width; ++i)
            if (is_same((*this)[i->second], point)) return i->second;
        return std::nullopt;
    }

    /// Returns the index of the new solution.
    int add(const Point& point) {
        by_key_.emplace(key(point), size());
        points_.push_back(point);
        return size() - 1;
    }

private:
    /// The same for approximations of the same point but for rounding.
    static double key(const Point& point) {
        double sum = 0;
        for (const std::complex<double>& x : point)
            sum += x.real() + 0.61 * x.imag();
        return sum;
    }

    bool is_same(const Point& known, const Point& point) const {
        return nearness_ == Nearness::of_points ? approximates(point, known, near_)
                                                : has_near_coordinates(known, point, near_);
    }

    double near_;
    Nearness nearness_;
    std::vector<Point> points_;
    std::multimap<double, int> by_key_;
};

} // namespace plprove
