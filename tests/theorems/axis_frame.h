// The frame of an axis (proofs/three_collinear_points.md, section 1), modulo a small prime: cameras
// and pins that are planted in space, and random images with their conditions on a plane.
#pragma once

#include "tests/theorems/small_elimination.h"

#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace axis {

using Vector3 = std::array<Number, 3>;
using Form = std::array<Number, 2>;

/// A vector of W modulo U: in view v, h_v(z[v]) and w[v] times the vector outside the axis.
struct FrameVector {
    std::array<std::array<Number, 2>, 3> z;
    Vector3 w;
    bool operator==(const FrameVector&) const = default;
};

using Plane = std::array<FrameVector, 2>;

/// phi_{i + 1}, zero at (1, 0), (0, 1), (1, 1) for i = 0, 1, 2.
inline Form phi(std::size_t i) {
    const Number minus = -Number(1);
    return i == 0 ? Form{0, 1} : i == 1 ? Form{minus, 0} : Form{minus, 1};
}

inline Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Number det(const std::array<Vector3, 3>& m) {
    const Vector3 normal = cross(m[1], m[2]);
    return m[0][0] * normal[0] + m[0][1] * normal[1] + m[0][2] * normal[2];
}

/// Gauss: brings rows to reduced form, and returns the rank.
inline std::size_t reduce(std::vector<std::vector<Number>>& rows) {
    std::size_t rank = 0;
    for (std::size_t c = 0; c < rows.front().size() && rank < rows.size(); ++c) {
        std::size_t place = rank;
        while (place < rows.size() && rows[place][c] == Number(0))
            ++place;
        if (place == rows.size()) continue;
        std::swap(rows[rank], rows[place]);
        const Number scale = rows[rank][c].inverse();
        for (Number& x : rows[rank])
            x = x * scale;
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const Number factor = rows[r][c];
            for (std::size_t k = 0; r != rank && k < rows[r].size(); ++k)
                rows[r][k] = rows[r][k] - factor * rows[rank][k];
        }
        ++rank;
    }
    return rank;
}

inline std::size_t rank(std::vector<std::vector<Number>> rows) {
    return reduce(rows);
}

/// The solution of a regular system, whose last column is the right side.
inline std::vector<Number> solve(std::vector<std::vector<Number>> rows) {
    reduce(rows);
    std::vector<Number> x;
    for (const auto& row : rows)
        x.push_back(row.back());
    return x;
}

template <class Random>
Number random_number(Random& random) {
    return Number(static_cast<std::uint32_t>(1 + random() % (Number::prime - 1)));
}

template <class Random>
Vector3 random_vector(Random& random) {
    return {random_number(random), random_number(random), random_number(random)};
}

/// Random cameras, three points of an axis, and pins, in space; then their images in the frame that
/// the images of the points define.
class Scene {
public:
    template <class Random>
    Scene(Random& random, std::size_t pins_of_a_point) {
        for (auto& camera : cameras_)
            for (Point& row : camera)
                row = random_point(random);
        points_ = {random_point(random), random_point(random), {}};
        const Number a = random_number(random), b = random_number(random);
        for (std::size_t k = 0; k < 4; ++k)
            points_[2][k] = a * points_[0][k] + b * points_[1][k];
        for (std::size_t v = 0; v < 3; ++v)
            choose_frame(random, v);
        for (FrameVector& x : plane)
            x = place(random_point(random));
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < pins_of_a_point; ++j)
                pins[i].push_back(pin(i, random_point(random)));
    }

    Plane plane;
    std::array<std::vector<Vector3>, 3> pins; // the numbers alpha of the pins of each point

private:
    using Point = std::array<Number, 4>;

    template <class Random>
    static Point random_point(Random& random) {
        return {random_number(random), random_number(random), random_number(random),
                random_number(random)};
    }

    Vector3 image(std::size_t v, const Point& p) const {
        Vector3 x;
        for (std::size_t r = 0; r < 3; ++r)
            x[r] = cameras_[v][r][0] * p[0] + cameras_[v][r][1] * p[1] + cameras_[v][r][2] * p[2] +
                   cameras_[v][r][3] * p[3];
        return x;
    }

    /// The coefficients of x by three vectors.
    static Vector3 coefficients(const std::array<Vector3, 3>& basis, const Vector3& x) {
        const Number scale = det(basis).inverse();
        return {det({x, basis[1], basis[2]}) * scale, det({basis[0], x, basis[2]}) * scale,
                det({basis[0], basis[1], x}) * scale};
    }

    /// Uses the images of the three points only up to scale.
    template <class Random>
    void choose_frame(Random& random, std::size_t v) {
        std::array<Vector3, 3> x;
        for (std::size_t i = 0; i < 3; ++i) {
            x[i] = image(v, points_[i]);
            const Number scale = random_number(random);
            for (Number& entry : x[i])
                entry = entry * scale;
        }
        frames_[v] = {x[0], x[1], random_vector(random)};
        const Vector3 third = coefficients(frames_[v], x[2]);
        for (std::size_t k = 0; k < 2; ++k)
            for (Number& entry : frames_[v][k])
                entry = entry * third[k];
        scales_[v] = coefficients(frames_[v], image(v, points_[0]))[0];
    }

    /// The camera is scaled so that it is h_v on the axis.
    FrameVector place(const Point& p) const {
        FrameVector result;
        for (std::size_t v = 0; v < 3; ++v) {
            const Vector3 x = coefficients(frames_[v], image(v, p));
            const Number scale = scales_[v].inverse();
            result.z[v] = {x[0] * scale, x[1] * scale};
            result.w[v] = x[2] * scale;
        }
        for (std::size_t v = 0; v < 3; ++v)
            for (std::size_t k = 0; k < 2; ++k)
                result.z[v][k] = v < 2 ? result.z[v][k] - result.z[2][k] : Number(0);
        return result;
    }

    Vector3 pin(std::size_t i, const Point& p) const {
        Vector3 alpha;
        for (std::size_t v = 0; v < 3; ++v) {
            const Vector3 x = coefficients(frames_[v], image(v, p));
            alpha[v] = (phi(i)[0] * x[0] + phi(i)[1] * x[1]) * x[2].inverse();
        }
        return alpha;
    }

    std::array<std::array<Point, 3>, 3> cameras_;
    std::array<Point, 3> points_;
    std::array<std::array<Vector3, 3>, 3> frames_; // h_v of both basis vectors, and one outside
    Vector3 scales_;
};

/// The pins of each point of the axis, free lines, and the number of lines of each point off it.
struct Features {
    std::array<std::size_t, 3> pins;
    std::size_t free_lines;
    std::vector<std::size_t> lines_of_points;
};

/// A linear form on W that is 0 on U: mu[v] on z[v], with sum 0, and nu[v] on w[v].
struct FrameForm {
    std::array<Form, 3> mu;
    Vector3 nu;

    /// At one of two vectors that span the plane: w = (1, 0, x) and (0, 1, y), z[0] = 0; the
    /// unknowns are z[1], z[2] and the last entry of w, of both vectors.
    Affine at(std::size_t vector) const {
        Affine result{};
        for (std::size_t k = 0; k < 4; ++k)
            result[5 * vector + k] = mu[1 + k / 2][k % 2];
        result[5 * vector + 4] = nu[2];
        result[unknowns] = nu[vector];
        return result;
    }
};

/// That some combination of both vectors is a zero of both forms.
inline Condition common_zero(const FrameForm& a, const FrameForm& b) {
    return {a.at(0), a.at(1), b.at(0), b.at(1)};
}

/// The form that is f in view a and -f in view b, for f = phi(z) - alpha w.
inline FrameForm pin_form(const Form& f, const Vector3& alpha, std::size_t a, std::size_t b) {
    FrameForm form{};
    form.mu[a] = f;
    form.mu[b] = {-f[0], -f[1]};
    form.nu[a] = -alpha[a];
    form.nu[b] = alpha[b];
    return form;
}

/// The form with these mu that is 0 at the image vectors (z, 1) of all views.
inline FrameForm form_through(const Form& first, const Form& second,
                              const std::array<Form, 3>& point) {
    FrameForm form{};
    form.mu = {first, second, {-(first[0] + second[0]), -(first[1] + second[1])}};
    for (std::size_t v = 0; v < 3; ++v)
        form.nu[v] = -(form.mu[v][0] * point[v][0] + form.mu[v][1] * point[v][1]);
    return form;
}

template <class Random>
Form random_pair(Random& random) {
    return {random_number(random), random_number(random)};
}

/// That the plane is in the hyperplane of a line through the point with these images.
template <class Random>
void add_line(std::vector<Condition>& all, Random& random, const std::array<Form, 3>& point) {
    const FrameForm form = form_through(random_pair(random), random_pair(random), point);
    Affine one{};
    one[unknowns] = 1;
    for (std::size_t vector = 0; vector < 2; ++vector)
        all.push_back({form.at(vector), {}, {}, one});
}

/// The conditions of Lemma L2 for random images.
template <class Random>
std::vector<Condition> conditions(const Features& features, Random& random) {
    std::vector<Condition> all;
    const auto point = [&]() -> std::array<Form, 3> {
        return {random_pair(random), random_pair(random), random_pair(random)};
    };
    for (std::size_t line = 0; line < features.free_lines; ++line)
        add_line(all, random, point());
    for (const std::size_t lines : features.lines_of_points) {
        const auto images = point();
        for (std::size_t line = 0; line < lines; ++line)
            add_line(all, random, images);
        const std::array<FrameForm, 4> forms = {
            form_through({1, 0}, {0, 0}, images), form_through({0, 1}, {0, 0}, images),
            form_through({0, 0}, {1, 0}, images), form_through({0, 0}, {0, 1}, images)};
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = 0; b < a; ++b)
                all.push_back(common_zero(forms[a], forms[b]));
    }
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < features.pins[i]; ++j) {
            const Vector3 alpha = random_vector(random);
            all.push_back(
                common_zero(pin_form(phi(i), alpha, 0, 1), pin_form(phi(i), alpha, 0, 2)));
        }
    return all;
}

} // namespace axis
