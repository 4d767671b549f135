// Lemma R13 and Proposition R14 of proofs/relations.md by a second method: at a random common point
// in the stratum (ii) or (iv), modulo q = 2^61 - 1, the equations of all features have 11
// independent derivatives. So the common point is simple, for each class of R14 that avoids (i).
#include "checker/algebra/modular.h"
#include "proofs/computations/feature_classes.h"
#include "tests/support/all_classes.h"
#include "tests/support/minimal_classes.h"

#include <doctest/doctest.h>

#include <random>
#include <set>

using checker::Residue;

namespace {
/// A number and its derivative by one coordinate.
struct Dual {
    Residue value{}, slope{};
};

Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.slope + b.slope};
}
Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.slope - b.slope};
}
Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.value * b.slope + a.slope * b.value};
}

using Numbers = std::array<Residue, 3>;
using Vector = std::array<Dual, 3>; // coordinates in a basis u, w, u-bar, or v, w', v-bar

Vector operator+(const Vector& a, const Vector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator*(const Dual& factor, const Vector& a) {
    return {factor * a[0], factor * a[1], factor * a[2]};
}

/// The product of rows: of an image line and a vector.
Dual on_line(const Numbers& line, const Vector& x) {
    Dual sum;
    for (std::size_t i = 0; i < 3; ++i)
        sum = sum + Dual{line[i]} * x[i];
    return sum;
}

/// The quadratic form, in a basis with u . u-bar = w . w = 1 and else 0.
Dual form(const Vector& a, const Numbers& b) {
    return on_line({b[2], b[1], b[0]}, a);
}

Numbers cross(const Numbers& a, const Numbers& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Dual determinant(const Numbers& x, const Vector& a, const Vector& b) {
    Dual sum;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        sum = sum + Dual{x[i]} * (a[j] * b[k] - a[k] * b[j]);
    }
    return sum;
}

/// The basis u, w, u-bar at the point of C with this parameter.
struct Basis {
    Vector u, w, above;

    explicit Basis(const Dual& t)
        : u{Dual{Residue{1}}, t, Dual{} - half() * t * t}, w{Dual{}, Dual{Residue{1}}, Dual{} - t},
          above{Dual{}, Dual{}, Dual{Residue{1}}} {}

    static Dual half() { return {Residue{2}.inverse()}; }
};

/// The coordinates of section 8, near a point of e with n_2 = n_3 = eta_3 = 1; the last three are
/// parameters of u_2, u_3 and v.
enum Coordinate : std::size_t { epsilon, sigma, delta, eta2, a2, b2, a3, b3, in2, in3, in1 };
using Point = std::array<Residue, 11>;

/// F_2, F_3 and T, with the derivatives by one coordinate.
class Forms {
public:
    Forms(const Point& at, std::size_t coordinate) {
        for (std::size_t i = 0; i < at.size(); ++i)
            at_[i] = {at[i], Residue{i == coordinate ? 1U : 0U}};
    }

    /// F_v(x_1, x_v).
    Dual epipolar(std::size_t view, const Numbers& x1, const Numbers& x) const {
        const Basis b(at_[view == 2 ? in2 : in3]);
        const Vector next = rotated(view, x1), tau = epipole(view);
        const Dual p = form(in_view_1(view).u, x1);
        return determinant(x, b.u, next) + p * determinant(x, tau, b.u) +
               scale(view) * determinant(x, tau, next);
    }

    /// T(x_1, l_2, l_3), from (3) divided by epsilon.
    Dual trifocal(const Numbers& x1, const Numbers& l2, const Numbers& l3) const {
        const Dual one{Residue{1}}, half = Basis::half();
        const Basis first = in_view_1(2);
        const Dual p2 = form(first.u, x1), p3 = form(in_view_1(3).u, x1);
        const Dual difference =
            at_[delta] * form(first.w, x1) + half * at_[delta] * at_[delta] * at_[epsilon] *
                                                 form(first.above, x1); // (p_2 - p_3) / epsilon
        const Dual u2 = on_line(l2, Basis(at_[in2]).u), u3 = on_line(l3, Basis(at_[in3]).u);
        const Dual next2 = on_line(l2, rotated(2, x1)), next3 = on_line(l3, rotated(3, x1));
        const Dual tau2 = on_line(l2, epipole(2)), tau3 = on_line(l3, epipole(3));
        const Dual s3 = one + at_[epsilon] * at_[sigma];
        const Dual both = at_[epsilon] * at_[eta2];
        return u2 * u3 * (at_[sigma] * p2 + difference) + s3 * at_[eta2] * next2 * u3 +
               s3 * p2 * u2 * tau3 + s3 * both * next2 * tau3 - u2 * next3 -
               at_[eta2] * p3 * tau2 * u3 - both * tau2 * next3;
    }

private:
    Dual scale(std::size_t view) const {
        return view == 2 ? at_[epsilon] * at_[eta2] : at_[epsilon];
    }

    /// v, w' and v-bar of R_v.
    Basis in_view_1(std::size_t view) const {
        return Basis(view == 2 ? at_[in1] : at_[in1] - at_[delta] * at_[epsilon]);
    }

    /// (R_v x_1 - (v . x_1) u_v) / epsilon_v.
    Vector rotated(std::size_t view, const Numbers& x1) const {
        const Basis b(at_[view == 2 ? in2 : in3]), first = in_view_1(view);
        return form(first.w, x1) * b.w + scale(view) * form(first.above, x1) * b.above;
    }

    /// (t_v - u_v) / epsilon_v.
    Vector epipole(std::size_t view) const {
        const Basis b(at_[view == 2 ? in2 : in3]);
        return at_[view == 2 ? a2 : a3] * b.w + at_[view == 2 ? b2 : b3] * b.above;
    }

    std::array<Dual, 11> at_{};
};

/// An equation of a feature: T(x_1, second, third), or F_v(x_1, second).
struct Equation {
    std::size_t view; // 2 or 3 for F_v, 1 for T
    Numbers x1, second, third;

    Dual operator()(const Forms& forms) const {
        return view == 1 ? forms.trifocal(x1, second, third) : forms.epipolar(view, x1, second);
    }
};

/// Random data of features at a point, and their equations.
class Data {
public:
    Data(const Point& at, bool in_iv, std::uint64_t seed)
        : forms_(at, 11), v_prime_{Residue{} - at[a3], Residue{1}, Residue{}}, in_iv_(in_iv),
          random_(seed) {}

    std::vector<Equation> equations;

    /// P/P/P or Pa/a/P with v' . x_1 = 0, where all data will do.
    void at_v_prime(std::string_view feature) {
        const Numbers line = {v_prime_[2], v_prime_[1], v_prime_[0]};
        const Numbers x1 = cross(line, any()), x2 = any(), x3 = any();
        if (feature == "P/P/P") equations.push_back({2, x1, x2, {}});
        equations.push_back({3, x1, x3, {}});
        equations.push_back({1, x1, cross(x2, any()), cross(x3, any())});
    }

    /// The others. In (iv), of the two conditions P/a/a has l_2 . u_2 = 0, the others l_3 . p_3 =
    /// 0.
    void elsewhere(std::string_view feature) {
        const bool sees2 = feature == "P/P/-" || feature == "P/P/P" || feature == "Pa/Pa/Pa" ||
                           feature == "P/Pa/a" || feature == "Pa/Pa/a";
        const bool sees3 = feature == "P/-/P" || feature == "P/P/P" || feature == "Pa/Pa/Pa" ||
                           feature == "P/a/Pa" || feature == "Pa/a/Pa";
        const bool line = feature == "a/a/a" || feature.starts_with("Pa");
        const Numbers x1 = any();
        Numbers x2 = any(), x3 = any();
        if (sees2) x2 = cross(epipolar_line(2, x1), any());
        if (sees3 && !sees2) x3 = cross(epipolar_line(3, x1), any());
        Numbers l2 = cross(x2, any()), l3 = cross(x3, any());
        const bool of_weight_one = feature == "P/-/P" || feature == "P/P/-";
        if (in_iv_ && feature == "P/a/a") {
            l2 = cross(left_over(x1, l3, 2), any());
        } else if (sees2 && !sees3 && !of_weight_one && !in_iv_) {
            x2 = left_over(x1, l3, 2);
            l2 = cross(x2, any());
        } else if (!of_weight_one) {
            x3 = left_over(x1, l2, 3);
            l3 = cross(x3, any());
        }
        if (sees2) equations.push_back({2, x1, x2, {}});
        if (sees3) equations.push_back({3, x1, x3, {}});
        if (!of_weight_one) equations.push_back({1, x1, l2, l3});
        if (line) equations.push_back({1, any(), l2, l3});
    }

private:
    Numbers any() {
        return {Residue{random_() % checker::modulus}, Residue{random_() % checker::modulus},
                Residue{random_() % checker::modulus}};
    }

    /// F_v(x_1, .) as a line.
    Numbers epipolar_line(std::size_t view, const Numbers& x1) const {
        Numbers line;
        for (std::size_t i = 0; i < 3; ++i)
            line[i] = forms_.epipolar(view, x1, unit(i)).value;
        return line;
    }

    /// T(x_1, ., l_3) or T(x_1, l_2, .) as a point of the view.
    Numbers left_over(const Numbers& x1, const Numbers& line, std::size_t view) const {
        Numbers point;
        for (std::size_t i = 0; i < 3; ++i)
            point[i] = (view == 2 ? forms_.trifocal(x1, unit(i), line)
                                  : forms_.trifocal(x1, line, unit(i)))
                           .value;
        return point;
    }

    static Numbers unit(std::size_t i) {
        Numbers result{};
        result[i] = Residue{1};
        return result;
    }

    Forms forms_;
    Numbers v_prime_;
    bool in_iv_;
    std::mt19937_64 random_;
};

/// A random point of the stratum (ii) or (iv), where F_3 = u_3 (w' - a_3 v).
Point point_of(bool in_iv, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Point at{};
    for (const Coordinate i : {delta, eta2, a2, b2, a3})
        at[i] = Residue{random() % checker::modulus};
    at[sigma] = Residue{} - at[a3] * at[delta];
    if (in_iv) {
        at[eta2] = Residue{};
    } else {
        at[a2] = at[a3];
        at[b2] = Residue{};
    }
    return at;
}

/// The equations of features at a point of a stratum; the first two of a kind have v' . x_1 = 0.
std::vector<Equation> equations_at(const Point& at, std::vector<std::string_view> features,
                                   bool in_iv) {
    const std::string_view first = in_iv ? "P/a/Pa" : "P/P/P";
    Data data(at, in_iv, 7);
    unsigned at_v_prime = 0;
    for (const std::string_view feature : features) {
        if (feature == first && at_v_prime < 2) {
            data.at_v_prime(feature);
            ++at_v_prime;
        } else {
            data.elsewhere(feature);
        }
    }
    return data.equations;
}

/// Whether all equations hold at the point, and whether their derivatives are independent.
struct CommonPoint {
    bool solves = true, simple = false;
};

CommonPoint common_point(const Point& at, const std::vector<Equation>& equations) {
    CommonPoint found;
    std::vector<std::vector<Residue>> derivatives;
    for (const Equation& equation : equations) {
        derivatives.emplace_back();
        for (std::size_t i = 0; i < at.size(); ++i) {
            const Dual side = equation(Forms(at, i));
            found.solves = found.solves && side.value == Residue{};
            derivatives.back().push_back(side.slope);
        }
    }
    found.simple = checker::determinant(std::move(derivatives)) != Residue{};
    return found;
}
} // namespace

TEST_CASE("the common points at the boundary that Theorem R (b) counts are simple") {
    std::set<checker::Signature> classes;
    for (std::size_t n = 0; n < all_classes().representatives.size(); ++n) {
        const checker::Signature& signature = all_classes().representatives[n];
        if (!is_minimal_class(n) || classes.contains(checker::constraint_class(signature)))
            continue;
        for (const checker::FeatureMap& map : checker::relabelings) {
            const checker::Signature relabeled = proofs::merged(permuted(signature, map));
            if (!proofs::has_classes(relabeled) || proofs::meets_stratum_i(relabeled)) continue;
            const auto [features, mirrored] = proofs::feature_lists(relabeled);
            const auto points = proofs::isolated_points(features);
            if (!points || !proofs::isolated_points(mirrored)) continue;
            CAPTURE(checker::notation(relabeled));
            for (const bool in_iv : {false, true}) {
                if ((in_iv ? points->in_iv : points->in_ii) == 0) continue;
                const Point at = point_of(in_iv, 5);
                const auto equations = equations_at(at, features, in_iv);
                REQUIRE(equations.size() == at.size());
                const CommonPoint found = common_point(at, equations);
                CHECK(found.solves);
                CHECK(found.simple);
                classes.insert(checker::constraint_class(signature));
            }
        }
    }
    CHECK(classes.size() == 16);
}
