// Lemma R7 of proofs/relations.md by a second method: how many conditions features meet at a point
// of each stratum, by counting the data over two finite fields. All strata have points on e, where
// (2) and (4) are F_v and T.
#include "proofs/computations/boundary_strata.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace {
using Vector = std::array<int, 3>;
using Matrix = std::array<Vector, 3>; // by the coordinate of view 1
using Tensor = std::array<Matrix, 3>; // by those of views 1, 2, 3

/// F_2, F_3 and T at a point of M.
struct Point {
    Matrix f2{}, f3{};
    Tensor t{};
};

/// The coordinates n, a, b on Y_2 or Y_3.
struct OnY {
    int n, a, b;
};

/// The coordinates of a point of e.
struct OnE {
    OnY in2, in3;
    int sigma, delta, eta2, eta3;
};

/// The numbers modulo p, where root^2 = -1.
struct Field {
    int p, root;

    int reduced(int value) const { return ((value % p) + p) % p; }

    int dot(const Vector& x, const Vector& y) const {
        return reduced(x[0] * y[0] + x[1] * y[1] + x[2] * y[2]);
    }

    Vector cross(const Vector& x, const Vector& y) const {
        return {reduced(x[1] * y[2] - x[2] * y[1]), reduced(x[2] * y[0] - x[0] * y[2]),
                reduced(x[0] * y[1] - x[1] * y[0])};
    }

    /// The points of the plane, and its lines.
    std::vector<Vector> plane() const {
        std::vector<Vector> points{{0, 0, 1}};
        for (int y = 0; y < p; ++y)
            points.push_back({0, 1, y});
        for (int x = 0; x < p; ++x)
            for (int y = 0; y < p; ++y)
                points.push_back({1, x, y});
        return points;
    }

    Vector applied(const Matrix& m, const Vector& x1) const {
        Vector result{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                result[j] = reduced(result[j] + x1[i] * m[i][j]);
        return result;
    }

    /// T(x_1, ., .)
    Matrix applied(const Tensor& t, const Vector& x1) const {
        Matrix result{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                for (std::size_t k = 0; k < 3; ++k)
                    result[j][k] = reduced(result[j][k] + x1[i] * t[i][j][k]);
        return result;
    }

    void add(Matrix& m, int factor, const Vector& x, const Vector& y) const {
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                m[i][j] = reduced(m[i][j] + reduced(factor * x[i]) * y[j]);
    }

    void add(Tensor& t, int factor, const Vector& x, const Vector& y, const Vector& z) const {
        for (std::size_t i = 0; i < 3; ++i)
            add(t[i], reduced(factor * x[i]), y, z);
    }

    /// F_v and T by (2) and (4), at u_2 = u_3 = v.
    Point point(const OnE& e) const {
        const int quarter = p == 5 ? 4 : 10;
        const Vector u{1, root, 0}, w{0, 0, 1}, above{quarter, reduced(-root * quarter), 0};
        const Vector &v = u, &w_in_1 = w;
        Point s;
        for (auto& [f, y] : {std::pair{&s.f2, e.in2}, std::pair{&s.f3, e.in3}}) {
            add(*f, y.a, v, cross(w, u));
            add(*f, y.b, v, cross(above, u));
            add(*f, y.n, w_in_1, cross(u, w));
        }
        add(s.t, e.sigma, v, u, u);
        add(s.t, e.delta, w_in_1, u, u);
        add(s.t, e.eta2 * e.in2.n, w_in_1, w, u);
        add(s.t, -e.eta2 * e.in2.a, v, w, u);
        add(s.t, -e.eta2 * e.in2.b, v, above, u);
        add(s.t, e.eta3 * e.in3.a, v, u, w);
        add(s.t, e.eta3 * e.in3.b, v, u, above);
        add(s.t, -e.eta3 * e.in3.n, w_in_1, u, w);
        return s;
    }
};

constexpr Field small{5, 2}, large{13, 5};

/// A point of a stratum.
OnE in_stratum(std::string_view name) {
    if (name == "i") return {{0, 1, 2}, {0, 1, 1}, 1, 0, 1, 2};
    if (name == "ii") return {{1, 1, 0}, {1, 1, 0}, 1, -1, 1, 2};
    if (name == "iii") return {{1, 1, 2}, {0, 1, 1}, 1, 0, 0, 1};
    return {{1, 2, 1}, {1, 1, 0}, 1, -1, 0, 1};
}

/// A vector of view 2 or 3 that T(x_1, ., .) makes of a line of the other view.
Vector left_over(const Field& field, const Matrix& tau, const Vector& line, bool of_view_3) {
    Vector result{};
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k)
            result[of_view_3 ? k : j] += line[of_view_3 ? j : k] * tau[j][k];
    for (int& coordinate : result)
        coordinate = field.reduced(coordinate);
    return result;
}

bool proportional(const Field& field, const Vector& x, const Vector& y) {
    return field.cross(x, y) == Vector{};
}

/// Pa/a/P, or Pa/P/a with the views 2 and 3 exchanged: x_1, a line, and the other point.
std::size_t points_with_a_line(const Field& field, const Point& s, bool point_in_view_3) {
    std::size_t count = 0;
    for (const Vector& x1 : field.plane()) {
        const Vector epipolar = field.applied(point_in_view_3 ? s.f3 : s.f2, x1);
        const Matrix tau = field.applied(s.t, x1);
        for (const Vector& line : field.plane()) {
            const Vector only = left_over(field, tau, line, point_in_view_3);
            for (const Vector& x : field.plane())
                if (field.dot(epipolar, x) == 0 && proportional(field, only, x)) ++count;
        }
    }
    return count;
}

/// P/P/P: T(x_1, l_2, l_3) = 0 for all lines through x_2 and x_3.
std::size_t triples_of_points(const Field& field, const Point& s) {
    constexpr std::array<Vector, 3> units{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    std::size_t count = 0;
    for (const Vector& x1 : field.plane()) {
        const Vector in2 = field.applied(s.f2, x1), in3 = field.applied(s.f3, x1);
        const Matrix tau = field.applied(s.t, x1);
        for (const Vector& x2 : field.plane()) {
            if (field.dot(in2, x2) != 0) continue;
            for (const Vector& x3 : field.plane()) {
                if (field.dot(in3, x3) != 0) continue;
                count += std::ranges::all_of(units, [&](const Vector& unit) {
                    const Vector line = field.cross(x2, unit);
                    return proportional(field, left_over(field, tau, line, true), x3);
                });
            }
        }
    }
    return count;
}

/// a/a/a: T(., l_2, l_3) is l_1 or 0.
std::size_t free_lines(const Field& field, const Point& s) {
    std::size_t count = 0;
    for (const Vector& l2 : field.plane()) {
        for (const Vector& l3 : field.plane()) {
            Vector c{};
            for (std::size_t i = 0; i < 3; ++i)
                c[i] = field.dot(l3, left_over(field, s.t[i], l2, true));
            for (const Vector& l1 : field.plane())
                count += proportional(field, c, l1);
        }
    }
    return count;
}

std::size_t data(const Field& field, const Point& s, std::string_view feature) {
    if (feature == "P/a/Pa") return points_with_a_line(field, s, true);
    if (feature == "P/Pa/a") return points_with_a_line(field, s, false);
    return feature == "P/P/P" ? triples_of_points(field, s) : free_lines(field, s);
}

/// How many conditions the data meet: the share of all data is about p to minus this number.
long conditions(const OnE& at, std::string_view feature) {
    const auto share = [&](const Field& field) {
        const double all = std::pow(field.plane().size(), 3);
        return static_cast<double>(data(field, field.point(at), feature)) / all;
    };
    return std::lround(std::log(share(small) / share(large)) / std::log(13.0 / 5.0));
}
} // namespace

TEST_CASE("points of the strata: features meet as many conditions as Lemma R7 says") {
    for (const proofs::Stratum& stratum : proofs::boundary_strata) {
        for (const std::string_view feature : {"P/a/Pa", "P/Pa/a", "P/P/P", "a/a/a"}) {
            unsigned least = 9;
            for (const proofs::Way& way : stratum.ways)
                if (way.feature == feature) least = std::min(least, way.conditions[0]);
            CAPTURE(stratum.name);
            CAPTURE(feature);
            CHECK(conditions(in_stratum(stratum.name), feature) == least);
        }
    }
}

TEST_CASE("at a generic point of e, features other than P/P/P meet their weight in conditions") {
    const OnE generic{{1, 2, 1}, {1, 1, 2}, 1, 1, 1, 2};
    for (const std::string_view feature : {"P/a/Pa", "P/Pa/a", "a/a/a"}) {
        CAPTURE(feature);
        CHECK(conditions(generic, feature) == 2);
    }
}
