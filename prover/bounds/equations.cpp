#include "prover/bounds/equations.h"

#include "prover/minimal/pool.h"

#include <algorithm>
#include <optional>

namespace plprove::bounds {

namespace {

/// l · (R x + t) = 0, or the like: coefficients at t, and what is without t.
struct Condition {
    std::array<Polynomial, 3> linear;
    Polynomial free;
    std::optional<BiDegree> free_degree; // for arbitrary data; nothing if there is no such term
    bool is_ray = false;                 // the coefficients at t have the degree of R, else 0
    bool is_axis = false;                // they are those of the line that fixes the frame
};

constexpr Vector3 first_axis{1, 0, 0};
constexpr Vector3 third_axis{0, 0, 1};

/// Collects conditions and equations in the order of FORMAT.
class System {
public:
    explicit System(Frame frame)
        : frame_(frame), ring_(rotation_ring(frame)), matrix_(ring_.matrix()) {}

    void add(const RegistrationData::Star& star, std::size_t index) {
        stars_.push_back(star);
        const Vector3& x = star.image;
        const std::optional<BiDegree> degree =
            index == 0 ? std::nullopt : std::optional(ring_.unit());
        if (frame_ == Frame::points && index < 2) {
            if (index == 0) add_incidence(star.point, third_axis, {}).is_axis = true;
            add_incidence(star.point, {-x[1], x[0], 0},
                          index == 0 ? std::nullopt : std::optional(BiDegree{1, 0}));
        } else {
            add_incidence(star.point, {0, x[2], -x[1]}, degree);
            add_incidence(star.point, {-x[2], 0, x[0]}, degree);
        }
        for (const RegistrationData::Pin& pin : star.pins)
            equations_.push_back({turned(cross(x, pin.toward), pin.direction), ring_.unit()});
    }

    void add(const RegistrationData::Line& line, std::size_t index) {
        lines_.push_back(line);
        if (frame_ == Frame::lines && index == 0) {
            add_incidence(line.point, line.image, {}).is_axis = true;
            return;
        }
        if (frame_ == Frame::line && index == 0) {
            // The rotations of the frame take the direction into the plane of the image.
            add_incidence(line.point, line.image, BiDegree{0, 1}).is_axis = true;
            if (stars_.size() >= 2) add_distance(line);
            return;
        }
        add_incidence(line.point, line.image, ring_.unit());
        equations_.push_back({turned(line.image, line.direction), ring_.unit()});
    }

    void add(const RegistrationData::Incidence& incidence) {
        add_incidence(incidence.point, incidence.line, ring_.unit());
    }

    void add(const RegistrationData::Group& group) {
        const std::size_t first = conditions_.size();
        for (const RegistrationData::Ray& ray : group.rays) {
            Condition& condition = conditions_.emplace_back();
            const Vector3& x = ray.image;
            const std::array<Vector3, 3> at{{{0, x[2], -x[1]}, {-x[2], 0, x[0]}, {x[1], -x[0], 0}}};
            for (std::size_t i = 0; i < 3; ++i)
                condition.linear[i] = turned(at[i], ray.direction);
            condition.free = turned(x, cross(group.point, ray.direction));
            condition.free_degree = ring_.unit();
            condition.is_ray = true;
            rays_.push_back(ray);
        }
        // A camera in the point that the lines share would satisfy their conditions.
        for (std::size_t k = first; k < conditions_.size(); ++k)
            for (std::size_t j = first; j < k; ++j)
                for (std::size_t i = first; i < j; ++i)
                    equations_.push_back(linear_minor({i, j, k}));
    }

    std::vector<Equation> take() {
        if (frame_ == Frame::lines) add_reduced_minor();
        for (std::size_t l = 0; l < conditions_.size(); ++l)
            for (std::size_t k = 0; k < l; ++k)
                for (std::size_t j = 0; j < k; ++j)
                    for (std::size_t i = 0; i < j; ++i)
                        equations_.push_back(minor({i, j, k, l}));
        return std::move(equations_);
    }

private:
    /// l · R x
    Polynomial turned(const Vector3& l, const Vector3& x) const {
        Polynomial total;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                total = sum(total, scaled(matrix_[3 * i + j], l[i] * x[j]));
        return total;
    }

    Condition& add_incidence(const Vector3& x, const Vector3& l, std::optional<BiDegree> degree) {
        Condition& condition = conditions_.emplace_back();
        for (std::size_t i = 0; i < 3; ++i)
            condition.linear[i] = constant(l[i]);
        condition.free = turned(l, x);
        condition.free_degree = degree;
        return condition;
    }

    /// The line determines the depths of the first two stars, and so the image of the vector from
    /// one to the other, whose length is known.
    void add_distance(const RegistrationData::Line& line) {
        const RegistrationData::Star& first = stars_[0];
        const RegistrationData::Star& second = stars_[1];
        const Polynomial depth = turned(third_axis, line.point);
        const Polynomial difference_of_depths = difference(turned(third_axis, second.point), depth);
        const std::int64_t factor = first.image[2] * second.image[2];
        std::int64_t length = 0;
        Polynomial total;
        for (std::size_t i = 0; i < 3; ++i) {
            const Polynomial w = sum(scaled(difference_of_depths, first.image[2] * second.image[i]),
                                     scaled(depth, second.image[2] * first.image[i]));
            total = sum(total, ring_.product(w, w));
            length += second.point[i] * second.point[i];
        }
        equations_.push_back(
            {difference(total, scaled(scaled(constant(length), factor), factor)), {0, 2}});
    }

    /// A multiple of the determinant of the conditions of two lines and two rays, made smaller in
    /// degree by a multiple of the second line's other equation (proofs/templates.md, Lemma U4).
    void add_reduced_minor() {
        const auto times = [&](const Polynomial& a, const Polynomial& b) {
            return ring_.product(a, b);
        };
        const auto ray_minor = [&](std::size_t ray) { // of both lines and a ray
            return linear_minor({0, 1, ray}).polynomial;
        };
        const std::int64_t a = lines_[1].direction[0];
        const std::int64_t b = lines_[1].direction[1];
        const std::int64_t height = lines_[1].point[2];
        const Vector3& l = lines_[1].image;
        const Vector3& x = rays_[0].image;
        const Vector3& y = rays_[1].image;
        const Vector3& d = rays_[0].direction;
        const Vector3& e = rays_[1].direction;
        const Polynomial along = turned(l, first_axis); // l · S (1, 0, 0)
        const Polynomial across = difference(scaled(matrix_[0], l[1]), scaled(matrix_[3], l[0]));
        const Polynomial& s2 = matrix_[7];
        const Polynomial& c2 = matrix_[8];
        const Polynomial sine = sum(scaled(across, -b), scaled(times(along, c2), -a));
        const Polynomial cosine = sum(constant(b * l[2]), scaled(times(along, s2), a));
        const Polynomial reduced = scaled(sum(scaled(sine, e[1]), scaled(cosine, e[2])), height);
        Polynomial total = times(reduced, turned(cross(x, y), d));
        total =
            difference(total, scaled(times(conditions_[1].free, turned(x, cross(e, d))), b * y[2]));
        total = difference(total, scaled(times(conditions_[2].free, ray_minor(3)), b));
        total = sum(total, scaled(times(conditions_[3].free, ray_minor(2)), b));
        equations_.push_back({total, {2, 2}});
    }

    /// The determinant of the coefficients of three conditions at t.
    Equation linear_minor(const std::array<std::size_t, 3>& chosen) const {
        const auto entry = [&](std::size_t row, std::size_t column) -> const Polynomial& {
            return conditions_[chosen[row]].linear[column % 3];
        };
        Equation minor{{}, {0, 0}};
        for (std::size_t i = 0; i < 3; ++i)
            minor.polynomial =
                sum(minor.polynomial,
                    ring_.product(entry(0, i),
                                  difference(ring_.product(entry(1, i + 1), entry(2, i + 2)),
                                             ring_.product(entry(1, i + 2), entry(2, i + 1)))));
        int rays = 0;
        bool axis = false;
        for (const std::size_t i : chosen) {
            rays += conditions_[i].is_ray ? 1 : 0;
            axis |= conditions_[i].is_axis;
        }
        // Less than one for each ray: see proofs/templates.md, Lemma U5.
        const int all = rays - (rays == 3 ? 1 : 0);
        minor.degree = {(all - (rays == 2 && axis ? 1 : 0)) * ring_.unit()[0],
                        all * ring_.unit()[1]};
        return minor;
    }

    /// The determinant of four conditions.
    Equation minor(const std::array<std::size_t, 4>& chosen) const {
        Equation total{{}, {0, 0}};
        for (std::size_t i = 0; i < 4; ++i) {
            const Condition& condition = conditions_[chosen[i]];
            if (!condition.free_degree) continue;
            std::array<std::size_t, 3> rest{};
            std::remove_copy(chosen.begin(), chosen.end(), rest.begin(), chosen[i]);
            const Equation three = linear_minor(rest);
            const Polynomial term = ring_.product(condition.free, three.polynomial);
            total.polynomial =
                i % 2 == 1 ? sum(total.polynomial, term) : difference(total.polynomial, term);
            const BiDegree degree = sum(*condition.free_degree, three.degree);
            total.degree = {std::max(total.degree[0], degree[0]),
                            std::max(total.degree[1], degree[1])};
        }
        return total;
    }

    Frame frame_;
    RotationRing ring_;
    std::array<Polynomial, 9> matrix_;
    std::vector<RegistrationData::Star> stars_;
    std::vector<RegistrationData::Line> lines_;
    std::vector<RegistrationData::Ray> rays_;
    std::vector<Condition> conditions_;
    std::vector<Equation> equations_;
};

/// A vector without zeros.
Vector3 draw_vector(SmallIntegers& integers) {
    Vector3 v{};
    for (std::int64_t& coordinate : v)
        do
            coordinate = integers.next();
        while (coordinate == 0);
    return v;
}

RegistrationData::Star draw_star(Frame frame, std::size_t index, int pins,
                                 SmallIntegers& integers) {
    RegistrationData::Star star{draw_vector(integers), draw_vector(integers), {}};
    if (frame == Frame::points && index < 2) {
        star.point = {star.point[0], 0, 0};
        star.image[2] = 0;
    }
    if (index == 0) star.point = {};
    for (int i = 0; i < pins; ++i)
        star.pins.push_back({draw_vector(integers), draw_vector(integers)});
    return star;
}

RegistrationData::Line draw_line(Frame frame, int index, SmallIntegers& integers) {
    const RegistrationData::Line line{draw_vector(integers), draw_vector(integers),
                                      draw_vector(integers)};
    if (frame == Frame::line && index == 0) return {line.point, first_axis, third_axis};
    if (frame == Frame::lines && index == 0) return {{}, first_axis, third_axis};
    if (frame == Frame::lines && index == 1)
        return {{0, 0, line.point[2]}, {line.direction[0], line.direction[1], 0}, line.image};
    return line;
}

} // namespace

std::string name(Frame frame) {
    switch (frame) {
    case Frame::general:
        return "general";
    case Frame::line:
        return "line";
    case Frame::points:
        return "points";
    case Frame::lines:
        return "lines";
    }
    return {};
}

bool suits(Frame frame, const Registration& type) {
    if (frame == Frame::line) return type.lines > 0;
    if (frame == Frame::lines) return type.lines == 2 && type.stars.empty() && type.incidences == 0;
    return frame == Frame::general || type.stars.size() >= 2;
}

RotationRing rotation_ring(Frame frame) {
    return RotationRing(frame == Frame::general ? Rotations::all : Rotations::two_circles);
}

RegistrationData draw_data(const Registration& type, Frame frame, std::uint64_t seed) {
    SmallIntegers integers(seed, 99);
    RegistrationData data;
    for (const int pins : type.stars)
        data.stars.push_back(draw_star(frame, data.stars.size(), pins, integers));
    for (int i = 0; i < type.lines; ++i)
        data.lines.push_back(draw_line(frame, i, integers));
    for (int i = 0; i < type.incidences; ++i)
        data.incidences.push_back({draw_vector(integers), draw_vector(integers)});
    for (const int rays : type.groups) {
        RegistrationData::Group group{draw_vector(integers), {}};
        for (int i = 0; i < rays; ++i)
            group.rays.push_back({draw_vector(integers), draw_vector(integers)});
        data.groups.push_back(std::move(group));
    }
    return data;
}

std::vector<Equation> equations(const RegistrationData& data, Frame frame) {
    System system(frame);
    for (std::size_t i = 0; i < data.stars.size(); ++i)
        system.add(data.stars[i], i);
    for (std::size_t i = 0; i < data.lines.size(); ++i)
        system.add(data.lines[i], i);
    for (const RegistrationData::Incidence& incidence : data.incidences)
        system.add(incidence);
    for (const RegistrationData::Group& group : data.groups)
        system.add(group);
    return system.take();
}

} // namespace plprove::bounds
