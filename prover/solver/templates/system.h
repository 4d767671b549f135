// The equations of a registration problem, the translation eliminated (proofs/registrations.md), in
// the order of certs/FORMAT.md, section 10. The entries of the rotation are polynomials, and
// the data integers, where a template is sought; they are numbers where a camera is.
#pragma once

#include "prover/solver/templates/frame.h"
#include "prover/solver/templates/rotation_ring.h"

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace plprove::templates {

template <class A, class B>
auto dot(const A& a, const B& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class A, class B>
auto cross_product(const A& a, const B& b) {
    return std::array{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                      a[0] * b[1] - a[1] * b[0]};
}

/// linear · t + free = 0, on the translation t.
template <class Function>
struct Condition {
    std::array<Function, 3> linear;
    Function free;
    std::optional<BiDegree> free_degree; ///< for arbitrary data; nothing if there is no such term
    bool is_ray = false;                 ///< `linear` has the degree of the rotation, else 0
    bool is_axis = false;                ///< `linear` is the line that fixes the frame
};

/// `Data` has stars, lines, incidences and groups, with vectors of coefficients; line_of() gives
/// the line that the camera sees of a pin. A function times a coefficient is a function.
template <class Function, class Data>
class System {
public:
    /// `matrix`: the entries of the rotation, row by row. `one`: the constant.
    System(const Data& data, Frame frame, const std::array<Function, 9>& matrix,
           const Function& one)
        : data_(data), frame_(frame), unit_(unit(frame)), matrix_(matrix), one_(one) {
        for (std::size_t i = 0; i < data.stars.size(); ++i)
            add_star(i);
        for (std::size_t i = 0; i < data.lines.size(); ++i)
            add_line(i);
        for (const auto& incidence : data.incidences)
            add_incidence(incidence.point, incidence.image, unit_);
        for (const auto& group : data.groups)
            add_group(group);
    }

    const std::vector<Condition<Function>>& conditions() const { return conditions_; }

    /// Adds the equations on all conditions, which are the last ones.
    void add_minors() {
        if (frame_ == Frame::lines) add(reduced_minor(), [] { return BiDegree{2, 2}; });
        for (std::size_t l = 0; l < conditions_.size(); ++l)
            for (std::size_t k = 0; k < l; ++k)
                for (std::size_t j = 0; j < k; ++j)
                    for (std::size_t i = 0; i < j; ++i)
                        add(minor({i, j, k, l}), [&] { return minor_degree({i, j, k, l}); });
    }

    /// What vanishes at the rotations of all solutions.
    const std::vector<Function>& equations() const { return equations_; }
    /// Bounds of their degrees, for arbitrary data; none where functions are numbers.
    const std::vector<BiDegree>& degrees() const { return degrees_; }

private:
    static constexpr bool has_degrees = std::is_same_v<Function, RotationFunction>;
    using Three = std::array<std::size_t, 3>;
    using Four = std::array<std::size_t, 4>;

    template <class Degree>
    void add(Function equation, const Degree& degree) {
        equations_.push_back(std::move(equation));
        if constexpr (has_degrees) degrees_.push_back(degree());
    }

    template <class Vector>
    std::array<Function, 3> turned(const Vector& x) const {
        const auto row = [&](std::size_t i) {
            return matrix_[i] * x[0] + matrix_[i + 1] * x[1] + matrix_[i + 2] * x[2];
        };
        return {row(0), row(3), row(6)};
    }

    /// The point x is on the line l of the image.
    template <class Point, class Line>
    Condition<Function>& add_incidence(const Point& x, const Line& l,
                                       std::optional<BiDegree> degree) {
        return conditions_.emplace_back(Condition<Function>{
            {one_ * l[0], one_ * l[1], one_ * l[2]}, dot(turned(x), l), degree});
    }

    void add_star(std::size_t index) {
        const auto& star = data_.stars[index];
        const auto& x = star.image;
        using Coefficient = std::decay_t<decltype(x[0])>;
        using Line = std::array<Coefficient, 3>;
        const Coefficient zero(0), one(1);
        const bool is_origin = index == 0;
        if (frame_ == Frame::points && index < 2) {
            if (is_origin) add_incidence(star.point, Line{zero, zero, one}, {}).is_axis = true;
            add_incidence(star.point, Line{-x[1], x[0], zero},
                          is_origin ? std::nullopt : std::optional(BiDegree{1, 0}));
        } else {
            const auto degree = is_origin ? std::nullopt : std::optional(unit_);
            add_incidence(star.point, Line{zero, x[2], -x[1]}, degree);
            add_incidence(star.point, Line{-x[2], zero, x[0]}, degree);
        }
        for (const auto& pin : star.pins)
            add(dot(turned(pin.direction), line_of(star, pin)), [&] { return unit_; });
    }

    void add_line(std::size_t index) {
        const auto& line = data_.lines[index];
        if (index == 0 && frame_ == Frame::lines) {
            add_incidence(line.point, line.image, {}).is_axis = true;
        } else if (index == 0 && frame_ == Frame::line) {
            // The rotations of the frame take the direction into the plane of the image.
            add_incidence(line.point, line.image, BiDegree{0, 1}).is_axis = true;
            if (data_.stars.size() >= 2) add(distance(line), [] { return BiDegree{0, 2}; });
        } else {
            add_incidence(line.point, line.image, unit_);
            add(dot(turned(line.direction), line.image), [&] { return unit_; });
        }
    }

    template <class Group>
    void add_group(const Group& group) {
        const std::size_t first = conditions_.size();
        for (const auto& ray : group.rays)
            conditions_.push_back(
                {cross_product(turned(ray.direction), ray.image),
                 dot(turned(cross_product(group.point, ray.direction)), ray.image), unit_, true});
        // A camera in the point that the lines share would satisfy their conditions.
        for (std::size_t k = first; k < conditions_.size(); ++k)
            for (std::size_t j = first; j < k; ++j)
                for (std::size_t i = first; i < j; ++i)
                    add(linear_minor({i, j, k}), [&] { return linear_degree({i, j, k}); });
    }

    /// The line determines the depths of the first two stars, and so the image of the vector from
    /// one to the other, whose length is known.
    template <class Line>
    Function distance(const Line& line) const {
        const auto& x = data_.stars[0].image;
        const auto& y = data_.stars[1].image;
        const auto& point = data_.stars[1].point;
        const Function depth = turned(line.point)[2];
        const Function difference = turned(point)[2] - depth;
        const auto between = [&](std::size_t i) {
            return difference * (x[2] * y[i]) + depth * (y[2] * x[i]);
        };
        const std::array<Function, 3> w{between(0), between(1), between(2)};
        const auto factor = x[2] * y[2];
        return dot(w, w) - one_ * dot(point, point) * factor * factor;
    }

    /// A multiple of the determinant of the conditions of two lines and two rays, made smaller in
    /// degree by a multiple of the second line's other equation (proofs/registrations.md, Lemma
    /// U4).
    Function reduced_minor() const {
        const auto& line = data_.lines[1];
        const auto& first = data_.groups.front().rays.front();
        const auto& second = data_.groups.back().rays.back();
        const auto& l = line.image;
        const auto& d = first.direction;
        const auto& e = second.direction;
        const auto a = line.direction[0], b = line.direction[1], height = line.point[2];
        const Function &c = matrix_[0], &s = matrix_[3], &s2 = matrix_[7], &c2 = matrix_[8];
        const Function along = c * l[0] + s * l[1];
        const Function sine = (s * l[0] - c * l[1]) * b - along * c2 * a;
        const Function cosine = one_ * (b * l[2]) + along * s2 * a;
        const Function reduced = (sine * e[1] + cosine * e[2]) * height;
        return reduced * dot(turned(d), cross_product(first.image, second.image)) -
               conditions_[1].free * dot(turned(cross_product(e, d)), first.image) *
                   (b * second.image[2]) -
               conditions_[2].free * linear_minor({0, 1, 3}) * b +
               conditions_[3].free * linear_minor({0, 1, 2}) * b;
    }

    /// The determinant of the coefficients of three conditions at t.
    Function linear_minor(const Three& chosen) const {
        return dot(conditions_[chosen[0]].linear,
                   cross_product(conditions_[chosen[1]].linear, conditions_[chosen[2]].linear));
    }

    BiDegree linear_degree(const Three& chosen) const {
        int rays = 0;
        bool axis = false;
        for (const std::size_t i : chosen) {
            rays += conditions_[i].is_ray ? 1 : 0;
            axis |= conditions_[i].is_axis;
        }
        // Less than one for each ray: see proofs/registrations.md, Lemma U5.
        const int all = rays - (rays == 3 ? 1 : 0);
        return {(all - (rays == 2 && axis ? 1 : 0)) * unit_[0], all * unit_[1]};
    }

    static Three without(const Four& chosen, std::size_t i) {
        Three rest{};
        std::remove_copy(chosen.begin(), chosen.end(), rest.begin(), chosen[i]);
        return rest;
    }

    /// The determinant of four conditions.
    Function minor(const Four& chosen) const {
        Function total = one_ - one_;
        for (std::size_t i = 0; i < 4; ++i) {
            const Condition<Function>& condition = conditions_[chosen[i]];
            if (!condition.free_degree) continue; // the term is zero
            const Function term = condition.free * linear_minor(without(chosen, i));
            total = i % 2 == 1 ? total + term : total - term;
        }
        return total;
    }

    BiDegree minor_degree(const Four& chosen) const {
        BiDegree largest{};
        for (std::size_t i = 0; i < 4; ++i)
            if (const auto& free = conditions_[chosen[i]].free_degree) {
                const BiDegree degree = sum(*free, linear_degree(without(chosen, i)));
                largest = {std::max(largest[0], degree[0]), std::max(largest[1], degree[1])};
            }
        return largest;
    }

    const Data& data_;
    Frame frame_;
    BiDegree unit_;
    std::array<Function, 9> matrix_;
    Function one_;
    std::vector<Condition<Function>> conditions_;
    std::vector<Function> equations_;
    std::vector<BiDegree> degrees_;
};

} // namespace plprove::templates
