#include "checker/permutations/moving_views.h"

namespace checker {
namespace {
/// Collects the derivatives of an equation. Those by the motion of view 1 are left out.
class Derivatives {
public:
    /// Where a vector that turns with a view has these derivatives: a small turn w of the view adds
    /// the vector times w.
    void turn(const Seen& seen, const ResidueVector& derivatives) {
        add(seen.view, 0, cross(derivatives, seen.vector));
    }

    /// Of the turn itself.
    void turn_view(std::size_t view, const ResidueVector& derivatives) {
        add(view, 0, derivatives);
    }

    /// Where the difference of two centres has these derivatives.
    void move(std::size_t from, std::size_t to, const ResidueVector& derivatives) {
        add(to, 6, derivatives);
        add(from, 6, times(-Residue{1}, derivatives));
    }

    const Motion& sums() const { return sums_; }

private:
    void add(std::size_t view, std::size_t offset, const ResidueVector& derivatives) {
        if (view == 0) return;
        for (std::size_t i = 0; i < 3; ++i) {
            Residue& sum = sums_[offset + 3 * (view - 1) + i];
            sum = sum + derivatives[i];
        }
    }

    Motion sums_{};
};
} // namespace

ResidueVector turn_of(std::size_t view, const Motion& motion) {
    if (view == 0) return {};
    const std::size_t first = 3 * (view - 1);
    return {motion[first], motion[first + 1], motion[first + 2]};
}

Residue Equation::along(const Motion& motion) const {
    Residue sum{};
    for (std::size_t i = 0; i < motion.size(); ++i)
        sum = sum + derivatives[i] * motion[i];
    return sum;
}

Residue Drawn::number() {
    state_ = 6364136223846793005U * state_ + 1442695040888963407U; // Knuth's, modulo 2^64
    return Residue::of(state_);
}

ResidueVector Drawn::vector() {
    const Residue x = number(), y = number(), z = number();
    return {x, y, z};
}

ResidueVector Drawn::normal_to(const ResidueVector& direction) {
    return cross(direction, vector());
}

MovingViews::MovingViews(Drawn& drawn) {
    for (ResidueVector& centre : centres_)
        centre = drawn.vector();
}

std::array<ResidueVector, 3> MovingViews::planes(Drawn& drawn, const ResidueVector& point) const {
    const ResidueVector direction = drawn.vector();
    std::array<ResidueVector, 3> normals;
    for (std::size_t view = 0; view < 3; ++view)
        normals[view] = cross(direction, from(view, point));
    return normals;
}

Equation MovingViews::epipolar(const Seen& ray, const Seen& other) const {
    const ResidueVector base = baseline(ray.view, other.view);
    const ResidueVector product = cross(ray.vector, other.vector);
    Derivatives sums;
    sums.turn(ray, cross(other.vector, base));
    sums.turn(other, cross(base, ray.vector));
    sums.move(ray.view, other.view, product);
    return {dot(base, product), sums.sums()};
}

Equation MovingViews::incidence(const Seen& ray, const Seen& plane, const Seen& other) const {
    const ResidueVector to_plane = baseline(plane.view, ray.view);
    const ResidueVector to_other = baseline(other.view, ray.view);
    const Residue height = dot(plane.vector, to_plane), slope = dot(plane.vector, ray.vector);
    const Residue other_height = dot(other.vector, to_other);
    const Residue other_slope = dot(other.vector, ray.vector);
    Derivatives sums;
    sums.turn(plane, minus(times(other_slope, to_plane), times(other_height, ray.vector)));
    sums.turn(other, minus(times(height, ray.vector), times(slope, to_other)));
    sums.turn(ray, minus(times(height, other.vector), times(other_height, plane.vector)));
    sums.move(plane.view, ray.view, times(other_slope, plane.vector));
    sums.move(ray.view, other.view, times(slope, other.vector));
    return {height * other_slope - other_height * slope, sums.sums()};
}

Equation MovingViews::pencil(const std::array<ResidueVector, 3>& normals) {
    Derivatives sums;
    for (std::size_t view = 0; view < 3; ++view)
        sums.turn({view, normals[view]}, cross(normals[(view + 1) % 3], normals[(view + 2) % 3]));
    return {dot(normals[0], cross(normals[1], normals[2])), sums.sums()};
}

std::array<Motion, 6> MovingViews::relative_pose(std::size_t first, std::size_t second) const {
    const ResidueVector base = baseline(first, second);
    std::array<Motion, 6> result;
    for (std::size_t i = 0; i < 3; ++i) {
        ResidueVector axis{};
        axis[i] = Residue{1};
        Derivatives turns; // the views turn differently
        turns.turn_view(second, axis);
        turns.turn_view(first, times(-Residue{1}, axis));
        // The baseline turns relative to the first view.
        const ResidueVector across = cross(base, axis);
        Derivatives direction;
        direction.turn_view(first, cross(base, across));
        direction.move(first, second, across);
        result[i] = turns.sums();
        result[3 + i] = direction.sums();
    }
    return result;
}
} // namespace checker
