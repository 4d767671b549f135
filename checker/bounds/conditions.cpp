#include "checker/bounds/conditions.h"

#include <bit>

namespace checker {
/// The conditions of a star: its image point is a multiple of R X + t.
static void add_star(std::vector<Condition>& conditions, const Star& star, std::size_t number,
                     Frame frame, const FrameRotations& rotations) {
    const IntegerVector& x = star.image;
    const bool first = number == 0; // at the origin
    std::optional<Bidegree> free_degree = rotations.ring.unit();
    if (first) free_degree = std::nullopt;
    if (frame != Frame::points || number > 1) {
        conditions.push_back(rotations.incident(star.point, {0, x[2], -x[1]}, free_degree));
        conditions.push_back(rotations.incident(star.point, {-x[2], 0, x[0]}, free_degree));
        return;
    }
    if (first) { // the same for the second star: both are on the axis
        conditions.push_back(rotations.incident(star.point, {0, 0, 1}, std::nullopt));
        conditions.back().axis = true;
    }
    if (!first) free_degree = Bidegree{1, 0};
    conditions.push_back(rotations.incident(star.point, {-x[1], x[0], 0}, free_degree));
}

static void add_line(std::vector<Condition>& conditions, const KnownLine& line, bool first,
                     Frame frame, const FrameRotations& rotations) {
    const bool axis = first && (frame == Frame::line || frame == Frame::lines);
    std::optional<Bidegree> free_degree = rotations.ring.unit();
    if (axis && frame == Frame::line) free_degree = Bidegree{0, 1};
    if (axis && frame == Frame::lines) free_degree = std::nullopt;
    conditions.push_back(rotations.incident(line.point, line.image, free_degree));
    conditions.back().axis = axis;
}

std::vector<Condition> conditions_of(const Constraints& constraints,
                                     const FrameRotations& rotations) {
    std::vector<Condition> conditions;
    const Frame frame = constraints.frame;
    for (std::size_t i = 0; i < constraints.stars.size(); ++i)
        add_star(conditions, constraints.stars[i], i, frame, rotations);
    for (std::size_t i = 0; i < constraints.lines.size(); ++i)
        add_line(conditions, constraints.lines[i], i == 0, frame, rotations);
    for (const Incidence& incidence : constraints.incidences)
        conditions.push_back(
            rotations.incident(incidence.point, incidence.line, rotations.ring.unit()));
    for (const Group& group : constraints.groups)
        for (const Ray& ray : group.rays)
            conditions.push_back(rotations.meeting(group.point, ray));
    return conditions;
}

Polynomial Determinants::of(unsigned set) const {
    if (set == 0) return constant({1});
    const auto last = static_cast<std::size_t>(std::popcount(set) - 1);
    // Expanded by the last column, whose entry in the last row has the sign +.
    Residue sign = last % 2 == 0 ? Residue{1} : -Residue{1};
    Polynomial sum;
    for (std::size_t i = 0; i < conditions_.size(); ++i) {
        const unsigned rest = set & ~(1U << i);
        if (rest == set) continue;
        ring_.add_product(sum, conditions_[i].row[last], of(rest), sign);
        sign = -sign;
    }
    return sum;
}

/// Where R becomes infinite, the coefficients of rays are orthogonal to one isotropic vector, hence
/// three dependent; so are those of the axis, if the first degree does.
Bidegree Determinants::degree_of_three(unsigned set) const {
    unsigned rays = 0, axes = 0;
    for (std::size_t i = 0; i < conditions_.size(); ++i) {
        if ((set >> i & 1) == 0) continue;
        rays += conditions_[i].ray ? 1 : 0;
        axes += conditions_[i].axis ? 1 : 0;
    }
    const bool first_drops = rays > 1 && rays + axes == 3;
    const bool second_drops = rays == 3;
    const auto [first, second] = ring_.unit();
    return {(rays - (first_drops ? 1 : 0)) * first, (rays - (second_drops ? 1 : 0)) * second};
}

Bidegree Determinants::degree(unsigned set) const {
    if (std::popcount(set) == 3) return degree_of_three(set);
    Bidegree most{};
    for (std::size_t i = 0; i < conditions_.size(); ++i) {
        const unsigned rest = set & ~(1U << i);
        const std::optional<Bidegree>& free_degree = conditions_[i].free_degree;
        if (rest == set || !free_degree) continue;
        const Bidegree others = degree_of_three(rest);
        for (std::size_t d = 0; d < 2; ++d)
            most[d] = std::max(most[d], (*free_degree)[d] + others[d]);
    }
    return most;
}

std::vector<RotationEquation> Determinants::all(int size, std::size_t first,
                                                std::size_t end) const {
    std::vector<RotationEquation> equations;
    // Numbers put sets of bits of one size into colexicographic order.
    for (unsigned set = 0; set < 1U << end; set += 1U << first)
        if (std::popcount(set) == size)
            equations.push_back({[this, set] { return of(set); }, degree(set)});
    return equations;
}
} // namespace checker
