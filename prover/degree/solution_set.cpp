#include "prover/degree/solution_set.h"

#include <cmath>

namespace plprove {

namespace {

/// A linear function of the point, the same for approximations of the same point but for rounding.
double key(const CameraPoint& point) {
    double sum = 0;
    for (std::size_t k = 0; k < point.size(); ++k)
        sum += (1 + 0.37 * static_cast<double>(k)) * (point[k].real() + 0.61 * point[k].imag());
    return sum;
}

double norm(const CameraPoint& point) {
    double sum = 1;
    for (const Complex& x : point)
        sum += std::norm(x);
    return std::sqrt(sum);
}

} // namespace

bool approximates(const CameraPoint& point, const CameraPoint& other, double near) {
    const double radius = near * norm(point);
    double distance = 0;
    for (std::size_t k = 0; k < point.size(); ++k)
        distance += std::norm(point[k] - other[k]);
    return distance < radius * radius;
}

std::optional<int> SolutionSet::find(const CameraPoint& point) const {
    const double key_radius = 20 * near_ * norm(point);
    const double centre = key(point);
    for (auto i = by_key_.lower_bound(centre - key_radius);
         i != by_key_.end() && i->first <= centre + key_radius; ++i)
        if (approximates(point, points_[static_cast<std::size_t>(i->second)], near_))
            return i->second;
    return std::nullopt;
}

int SolutionSet::add(const CameraPoint& point) {
    points_.push_back(point);
    by_key_.emplace(key(point), size() - 1);
    return size() - 1;
}

} // namespace plprove
