// Theorem O (proofs/one_focal_length.md): cameras modulo a prime with one focal length, seven lines
// through a point, and three points on a line with another line.
#include "tests/theorems/residue_vectors.h"

#include <doctest/doctest.h>

using namespace checker;
using namespace residue_vectors;
using proofs::Residues;

namespace {

constexpr Residue true_focal{3};

/// A view of the origin, and of other points.
class View {
public:
    View(Residue focal, Residues& random) : focal_(focal), origin_(random_vector(random)) {
        const Residue a = random.next(), two{2};
        const Vector b = random_vector(random);
        const Residue scale = (a * a + dot(b, b)).inverse();
        for (std::size_t i = 0; i < 3; ++i) {
            Vector unit{};
            unit[i] = {1};
            const Vector turned = plus(plus(times(a * a - dot(b, b), unit), times(two * b[i], b)),
                                       times(two * a, cross(b, unit)));
            columns_[i] = times(scale, turned);
        }
    }

    /// The image vector of a direction.
    Vector image(const Vector& direction) const {
        Vector turned{};
        for (std::size_t i = 0; i < 3; ++i)
            turned = plus(turned, times(direction[i], columns_[i]));
        return calibrated(turned);
    }

    /// The image vector of a point.
    Vector point(const Vector& point) const { return plus(image(point), origin_); }

    /// The normal of the plane that the view sees on an image line.
    Vector normal(const Vector& line) const {
        const Vector turned = calibrated(line);
        return {dot(columns_[0], turned), dot(columns_[1], turned), dot(columns_[2], turned)};
    }

    /// The direction of the ray to the origin.
    Vector ray() const {
        const Residue inverse = focal_.inverse();
        const Vector turned{inverse * origin_[0], inverse * origin_[1], origin_[2]};
        return {dot(columns_[0], turned), dot(columns_[1], turned), dot(columns_[2], turned)};
    }

    /// The image of the line through the origin with a direction.
    Vector line(const Vector& direction) const { return cross(origin_, image(direction)); }

    /// The square of the normal, for this focal length or another.
    static Residue square(const Vector& line, Residue focal) {
        return focal * focal * (line[0] * line[0] + line[1] * line[1]) + line[2] * line[2];
    }

private:
    Vector calibrated(const Vector& a) const { return {focal_ * a[0], focal_ * a[1], a[2]}; }

    Residue focal_;
    Vector origin_;
    std::array<Vector, 3> columns_; ///< of the rotation
};

/// Residues with a root of -1.
struct Complex {
    Residue real, imaginary;

    Complex operator*(const Complex& b) const {
        return {real * b.real - imaginary * b.imaginary, real * b.imaginary + imaginary * b.real};
    }
    Complex operator-(const Complex& b) const { return {real - b.real, imaginary - b.imaginary}; }
    Complex conjugate() const { return {real, -imaginary}; }
    bool operator==(const Complex&) const = default;
};

/// What a view sees of a line, beside three points on another one (section 5).
struct LineInView {
    Complex omega;
    Residue p, q, square_of_nu;
};

LineInView line_in_view(const View& view, const std::array<Vector, 2>& points_of_axis,
                        Residue distance, const Vector& y) {
    const auto calibrated = [](const Vector& a) {
        return Vector{true_focal * a[0], true_focal * a[1], a[2]};
    };
    const Vector a = view.point(points_of_axis[0]), b = view.point(points_of_axis[1]);
    const Vector normal = calibrated(cross(a, b)), difference = minus(b, a);
    const Vector r{difference[0], difference[1], true_focal * difference[2]};
    return {
        {dot(calibrated(y), cross(normal, r)), true_focal * distance * dot(calibrated(y), normal)},
        dot(y, b),
        dot(y, a),
        dot(normal, normal)};
}

struct Views {
    std::array<View, 3> views;
    std::array<Vector, 3> rays;

    /// The trilinear form T of equation (1).
    Residue form(const std::array<Vector, 3>& lines) const {
        return determinant(views[0].normal(lines[0]), views[1].normal(lines[1]),
                           views[2].normal(lines[2]));
    }

    /// The coordinate i of the normal of an image line in view v.
    Residue coordinate(std::size_t v, std::size_t i, const Vector& line) const {
        return dot(views[v].normal(line), rays[i]);
    }
};

Views three_views(Residues& random) {
    const View one(true_focal, random), two(true_focal, random), three(true_focal, random);
    return {{one, two, three}, {one.ray(), two.ray(), three.ray()}};
}

} // namespace

TEST_CASE("seven lines through a point determine a trilinear form, which has two products") {
    Residues random(1);
    const Views all = three_views(random);
    proofs::ResidueMatrix conditions;
    for (int line = 0; line < 7; ++line) {
        const Vector direction = random_vector(random);
        std::array<Vector, 3> lines;
        for (std::size_t v = 0; v < 3; ++v) {
            lines[v] = all.views[v].line(direction);
            CHECK(dot(all.views[v].normal(lines[v]), direction) == Residue{});
            CHECK(all.coordinate(v, v, lines[v]) == Residue{});
        }
        CHECK(all.form(lines) == Residue{});
        proofs::ResidueRow row;
        for (std::size_t term = 0; term < 8; ++term) // two coordinates of a line are enough
            row.push_back(lines[0][term & 1] * lines[1][term >> 1 & 1] * lines[2][term >> 2]);
        conditions.push_back(row);
    }
    CHECK(proofs::rank_of(conditions) == 7);

    std::array<Vector, 3> lines;
    for (std::size_t v = 0; v < 3; ++v)
        lines[v] = all.views[v].line(random_vector(random));
    const auto n = [&](std::size_t v, std::size_t i) { return all.coordinate(v, i, lines[v]); };
    CHECK(all.form(lines) * determinant(all.rays[0], all.rays[1], all.rays[2]) ==
          n(0, 1) * n(1, 2) * n(2, 0) + n(0, 2) * n(1, 0) * n(2, 1));
}

TEST_CASE("the focal length of a star satisfies the cubic equation, another one does not") {
    Residues random(2);
    const Views all = three_views(random);
    std::array<Vector, 3> first, second; // where all factors of a product but one kind are 0
    for (std::size_t v = 0; v < 3; ++v) {
        first[v] = all.views[v].line(all.rays[(v + 2) % 3]);
        second[v] = all.views[v].line(all.rays[(v + 1) % 3]);
    }
    const auto product = [](const std::array<Vector, 3>& lines, Residue f) {
        return View::square(lines[0], f) * View::square(lines[1], f) * View::square(lines[2], f);
    };
    const Residue one = all.form(first), other = all.form(second);
    const auto difference = [&](Residue f) {
        return product(first, f) * other * other - product(second, f) * one * one;
    };
    CHECK(difference(true_focal) == Residue{});
    CHECK(difference(Residue{4}) != Residue{});
}

TEST_CASE(
    "five views of three collinear points and a line satisfy two equations of degree two in the "
    "square of the focal length") {
    Residues random(3);
    const Vector a = random_vector(random), b = random_vector(random);
    const Vector one = random_vector(random), other = random_vector(random);
    const Residue x = true_focal * true_focal, two{2};
    proofs::ResidueMatrix rows; // of K, p^2, pq, q^2, with rho = (1 : 1)
    for (int v = 0; v < 5; ++v) {
        const View view(true_focal, random);
        const Vector image_a = view.point(a), image_b = view.point(b);
        const Vector y = cross(view.point(one), view.point(other)), r = minus(image_b, image_a);
        const Vector product =
            cross(Vector{true_focal * y[0], true_focal * y[1], y[2]},
                  Vector{r[0], r[1], true_focal * r[2]}); // times the focal length
        const Residue minor = y[0] * r[1] - y[1] * r[0];
        const Residue scaled =
            x * x * r[2] * r[2] * (y[0] * y[0] + y[1] * y[1]) +
            x * (minor * minor - two * r[2] * y[2] * (y[0] * r[0] + y[1] * r[1])) +
            y[2] * y[2] * (r[0] * r[0] + r[1] * r[1]);
        CHECK(scaled == dot(product, product));
        const Residue p = dot(y, image_b), q = dot(y, image_a);
        rows.push_back({scaled, p * p, p * q, q * q});
    }
    CHECK(proofs::rank_of(rows) == 3);
    for (proofs::ResidueRow& row : rows)
        row.erase(row.begin());
    CHECK(proofs::rank_of(rows) == 3);
}

TEST_CASE("three products are equal where three views see three collinear points and two lines") {
    Residues random(4);
    const Residue distance{5};
    const Vector a = random_vector(random), b = plus(a, Vector{Residue{3}, Residue{4}, {}});
    std::array<std::array<LineInView, 3>, 2> lines;
    std::array<Vector, 2> k;
    const Views all = three_views(random);
    for (std::size_t line = 0; line < 2; ++line) {
        const Vector one = random_vector(random), other = random_vector(random);
        Vector p, q;
        for (std::size_t v = 0; v < 3; ++v) {
            const View& view = all.views[v];
            lines[line][v] =
                line_in_view(view, {a, b}, distance, cross(view.point(one), view.point(other)));
            p[v] = lines[line][v].p;
            q[v] = lines[line][v].q;
        }
        k[line] = cross(p, q);
    }
    std::array<Complex, 3> products;
    for (std::size_t v = 0; v < 3; ++v) {
        const std::size_t u = (v + 1) % 3, w = (v + 2) % 3;
        const auto omega = [&](std::size_t line, std::size_t view) {
            return Complex{k[line][view], {}} * lines[line][view].omega;
        };
        const Complex theta = omega(0, u) * omega(1, w) - omega(0, w) * omega(1, u);
        products[v] = theta * theta.conjugate() * Complex{lines[0][v].square_of_nu, {}};
    }
    CHECK(products[0] == products[1]);
    CHECK(products[0] == products[2]);
    CHECK(products[0].real != Residue{});
}

TEST_CASE("intersection numbers in three views: 80 solutions with two lines, 260 with one and two "
          "pins") {
    // Classes on S: multiples of alpha and beta, and of the three E.
    struct Class {
        long alpha, beta;
        std::array<long, 3> e;

        Class operator+(const Class& b) const {
            return {alpha + b.alpha, beta + b.beta, {e[0] + b.e[0], e[1] + b.e[1], e[2] + b.e[2]}};
        }
        long operator*(const Class& b) const {
            long sum = 8 * (alpha * b.beta + beta * b.alpha);
            for (std::size_t v = 0; v < 3; ++v)
                sum += 8 * (alpha * b.e[v] + e[v] * b.alpha) - 8 * e[v] * b.e[v];
            return sum;
        }
    };
    const std::array<Class, 3> d{{{1, 3, {-1, 0, 0}}, {1, 3, {0, -1, 0}}, {1, 3, {0, 0, -1}}}};
    // As the class of E and of its other half is 2 beta.
    const std::array<Class, 3> bar{{{1, 1, {1, 0, 0}}, {1, 1, {0, 1, 0}}, {1, 1, {0, 0, 1}}}};
    const Class delta = d[0] + bar[0];
    const Class sum = d[0] + d[1] + d[2], bar_sum = bar[0] + bar[1] + bar[2];
    const auto h = [](const std::array<Class, 3>& all) {
        long products = 0;
        for (std::size_t u = 0; u < 3; ++u)
            for (std::size_t v = u; v < 3; ++v)
                products += all[u] * all[v];
        return products;
    };
    CHECK(h(d) == h(bar));
    CHECK(delta * sum == delta * bar_sum);
    const long two_lines =
        h(d) + h(bar) + 2 * (sum * bar_sum) + delta * delta - 2 * (delta * (sum + bar_sum));
    const long cubed = sum * bar_sum + 2 * h(d) - 2 * (delta * sum); // T^3 T'
    CHECK(two_lines == 4 * 80);
    CHECK(2 * cubed + 2 * two_lines - 32 - 48 - 2 * 24 == 4 * 260);
}
