#include "checker/bounds/template_equations.h"

namespace checker {
static const IntegerVector origin{0, 0, 0};
static const IntegerVector first_axis{1, 0, 0};
static const IntegerVector third_axis{0, 0, 1};

/// Frame `points`: the first two stars are on the first axis, and their images on its image.
static void check_points(const Constraints& constraints) {
    if (constraints.stars.size() < 2) throw Refused("the frame `points` needs two stars");
    for (std::size_t i = 0; i < 2; ++i) {
        const auto& [point, image, pins] = constraints.stars[i];
        if (point[1] != 0 || point[2] != 0 || image[2] != 0)
            throw Refused("star ", i + 1, " is not on the axis");
    }
}

/// Frames `line` and `lines`: the first line is the first axis, but may be away from the origin.
static void check_first_line(const Constraints& constraints) {
    if (constraints.lines.empty()) throw Refused("the frame needs a line");
    const KnownLine& line = constraints.lines[0];
    if (line.direction != first_axis || line.image != third_axis)
        throw Refused("the first line is not the axis");
}

/// Frame `lines`: two lines, whose common perpendicular is the third axis, and two rays.
static void check_lines(const Constraints& constraints) {
    std::size_t rays = 0;
    for (const Group& group : constraints.groups)
        rays += group.rays.size();
    const bool fits = constraints.stars.empty() && constraints.incidences.empty() &&
                      constraints.lines.size() == 2 && rays == 2;
    if (!fits) throw Refused("the frame `lines` needs two lines and two rays, and nothing else");
    const KnownLine& second = constraints.lines[1];
    if (constraints.lines[0].point != origin || second.point[0] != 0 || second.point[1] != 0 ||
        second.direction[2] != 0)
        throw Refused("the third axis is not the common perpendicular");
}

void check_frame(const Constraints& constraints) {
    const unsigned weight = weight_of(constraints);
    if (weight != 6 && type_of(constraints) != relative_pose)
        throw Refused("the constraints have weight ", weight, ", not 6");
    if (!constraints.stars.empty() && constraints.stars[0].point != origin)
        throw Refused("the first star is not at the origin");
    const Frame frame = constraints.frame;
    if (frame == Frame::points) check_points(constraints);
    if (frame == Frame::line || frame == Frame::lines) check_first_line(constraints);
    if (frame == Frame::lines) check_lines(constraints);
}

/// In the frame `line`: the first line, through this point, determines the depths of two stars, so
/// their distance. With the heights a, b of their images x, y: a b R (Y - X) = w.
static Polynomial distance_polynomial(const Constraints& constraints,
                                      const FrameRotations& rotations) {
    const IntegerVector& point = constraints.lines[0].point;
    const Star& first = constraints.stars[0];
    const Star& second = constraints.stars[1];
    const mpz_class a = first.image[2];
    const mpz_class b = second.image[2];
    Polynomial sum;
    for (std::size_t i = 0; i < 3; ++i) {
        const mpz_class at_second = a * second.image[i];
        const mpz_class at_line = b * first.image[i] - at_second;
        Polynomial w = rotations.rotated({0, 0, at_line}, point);
        rotations.ring.add(w, rotations.rotated({0, 0, at_second}, second.point), {1});
        rotations.ring.add_product(sum, w, w, {1});
        const mpz_class distance = a * b * second.point[i];
        rotations.ring.add(sum, constant(residue(distance * distance)), -Residue{1});
    }
    return sum;
}

/// In the frame `lines`: a multiple of the determinant of the four conditions, of a smaller degree.
/// The letters are those of FORMAT.md.
static Polynomial reduced_determinant(const Constraints& constraints,
                                      const std::vector<Condition>& conditions,
                                      const FrameRotations& rotations) {
    std::vector<Ray> rays;
    for (const Group& group : constraints.groups)
        rays.insert(rays.end(), group.rays.begin(), group.rays.end());
    const auto& [D, x] = rays[0];
    const auto& [E, y] = rays[1];
    const IntegerVector& l = constraints.lines[1].image;
    const mpz_class& a = constraints.lines[1].direction[0];
    const mpz_class& b = constraints.lines[1].direction[1];
    const mpz_class& h = constraints.lines[1].point[2];
    const RotationRing& ring = rotations.ring;
    const Determinants determinants(ring, conditions);

    // h E_2 b (l_1 s - l_2 c) + h E_3 b l_3 + l · R e_1 times h (0, a E_3, -a E_2) · R^T e_3
    Polynomial g = rotations.rotated({-b * E[1] * h * l[1], b * E[1] * h * l[0], 0}, first_axis);
    ring.add(g, constant(residue(b * E[2] * h * l[2])), {1});
    const IntegerVector around{0, a * E[2] * h, -a * E[1] * h};
    ring.add_product(g, rotations.rotated(l, first_axis), rotations.rotated(third_axis, around),
                     {1});

    Polynomial sum;
    ring.add_product(sum, g, rotations.rotated(cross(x, y), D), {1});
    ring.add_product(sum, conditions[1].row[3], rotations.rotated(x, cross(E, D)),
                     -residue(b * y[2]));
    ring.add_product(sum, conditions[2].row[3], determinants.of(0b1011), -residue(b));
    ring.add_product(sum, conditions[3].row[3], determinants.of(0b0111), residue(b));
    return sum;
}

void TemplateEquations::add(const std::vector<RotationEquation>& more) {
    equations_.insert(equations_.end(), more.begin(), more.end());
}

/// The equations of single constraints, and of groups.
void TemplateEquations::add_constraints_alone() {
    const Frame frame = constraints_.frame;
    const Bidegree unit = rotations_.ring.unit();
    for (const Star& star : constraints_.stars)
        for (const KnownPin& pin : star.pins)
            equations_.push_back({[this, &star, &pin] {
                                      const IntegerVector line = cross(star.image, pin.toward);
                                      return rotations_.rotated(line, pin.direction);
                                  },
                                  unit});
    const bool first_is_axis = frame == Frame::line || frame == Frame::lines;
    for (std::size_t i = 0; i < constraints_.lines.size(); ++i) {
        const KnownLine& line = constraints_.lines[i];
        if (i > 0 || !first_is_axis)
            equations_.push_back(
                {[this, &line] { return rotations_.rotated(line.image, line.direction); }, unit});
        else if (frame == Frame::line && constraints_.stars.size() >= 2)
            equations_.push_back(
                {[this] { return distance_polynomial(constraints_, rotations_); }, {0, 2}});
    }
    std::size_t end = conditions_.size(); // of the conditions of a group
    for (const Group& group : constraints_.groups)
        end -= group.rays.size();
    for (const Group& group : constraints_.groups) {
        const std::size_t first = end;
        end += group.rays.size();
        add(determinants_.all(3, first, end));
    }
}

TemplateEquations::TemplateEquations(const Constraints& constraints,
                                     const FrameRotations& rotations)
    : constraints_(constraints), rotations_(rotations),
      conditions_(conditions_of(constraints, rotations)),
      determinants_(rotations.ring, conditions_) {
    add_constraints_alone();
    if (constraints.frame == Frame::lines)
        equations_.push_back(
            {[this] { return reduced_determinant(constraints_, conditions_, rotations_); },
             {2, 2}});
    add(determinants_.all(4, 0, conditions_.size()));
}
} // namespace checker
