#include "prover/solver/zero_set.h"

#include <cmath>

namespace plprove {

namespace {

double norm(const CameraPoint& zero) {
    double sum = 1;
    for (const Complex& x : zero)
        sum += std::norm(x);
    return std::sqrt(sum);
}

/// Nearly the same for zeros that are nearly the same.
double key(const CameraPoint& zero) {
    double sum = 0;
    for (const Complex& x : zero)
        sum += x.real();
    return sum;
}

} // namespace

std::optional<std::size_t> ZeroSet::find(const CameraPoint& zero) const {
    const double radius = same * norm(zero);
    const double key_radius = 4 * radius; // above the square root of 11, the number of terms
    const double centre = key(zero);
    for (auto i = by_key_.lower_bound(centre - key_radius);
         i != by_key_.end() && i->first <= centre + key_radius; ++i) {
        double distance = 0;
        for (std::size_t k = 0; k < zero.size(); ++k)
            distance += std::norm(zero[k] - zeros_[i->second][k]);
        if (distance < radius * radius) return i->second;
    }
    return std::nullopt;
}

bool ZeroSet::add(const CameraPoint& zero) {
    if (find(zero)) return false;
    by_key_.emplace(key(zero), zeros_.size());
    zeros_.push_back(zero);
    return true;
}

} // namespace plprove
