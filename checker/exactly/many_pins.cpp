#include "checker/exactly/many_pins.h"

#include <stdexcept>

namespace checker::exactly {
using Roots = std::vector<Residue>;

/// The polynomial x, or l, or y.
static const Polynomial variable{{Residue{}, Residue{1}}};

static Polynomial constant(Residue value) {
    return {{value}};
}

static Roots without(const Roots& roots, Residue root) {
    Roots rest = roots;
    const auto found = std::ranges::find(rest, root);
    if (found == rest.end()) throw std::logic_error("a root is missing");
    rest.erase(found);
    return rest;
}

/// f / y, for a polynomial f in y that is 0 at 0.
static Polynomial divided_by_variable(Polynomial f) {
    if (!f.at.empty()) f.at.erase(f.at.begin());
    return f;
}

/// A linear polynomial in the classes x of X and l of a line modulo X.
struct LinearForm {
    Residue constant{}, x{}, l{};
};

/// The numbers Theta at one chart. In the names of its parts u, v are two views, and w the third.
class Star {
public:
    Star(const Chart& chart, unsigned pins) : chart_(chart), at_(chart.at), pins_(pins) {
        for (const Residue h : at_.h)
            sum_h_ = sum_h_ + h;
        for (const Residue x : at_.x)
            c1_ = c1_ + x;
        for (std::size_t view = 0; view < 3; ++view)
            seen_[view] = point_seen(at_, view);
    }

    /// Theta_u: camera u has rank one, and the line of the other two centres is in its kernel.
    Residue rank_one(std::size_t u) const {
        if (at_.exceptional[u] == Residue{}) return {};
        const std::size_t v = (u + 1) % 3, w = (u + 2) % 3;
        const Roots kernel = kernel_of_rank_one(u);
        const LinearForm part = part_of_rank_one(u);
        const Polynomial line = seen_[v] * seen_[w];
        const Polynomial point = line * (constant(rest_of_image(u)) - variable);
        const Residue all =
            integral_over_flags(point * Polynomial{{part.constant, part.x}}, line, kernel) +
            integral_over_flags(point, line * Polynomial{{Residue{}, part.l}}, kernel);
        return at_.exceptional[u] *
               (all - isotropic_part(u, v, w, part) - isotropic_part(u, w, v, part));
    }

    /// Theta_uv: two cameras are null, and a line through their common kernel is seen as the point.
    Residue two_null(std::size_t w) const {
        if (chart_.both[w] == Residue{}) return {};
        const Polynomial at_kernel = part_of_two_null(w, {}, variable);
        const Polynomial at_other = part_of_two_null(w, variable, {});
        const Polynomial points = divided_by_variable(at_kernel - at_other);
        return chart_.both[w] *
               integral_over_points(lines_through_kernel(w) * points, roots_without_kernel());
    }

    /// Theta_0, with five pins: the three centres are on a line.
    Residue centres_on_a_line() const {
        const Polynomial line = seen_[0] * seen_[1] * seen_[2];
        const Polynomial point = line * (constant({}) - variable); // -x is 1 on lines
        Residue sum = integral_over_flags(point, line, at_.x);
        for (std::size_t w = 0; w < 3; ++w)
            if (chart_.both[w] != Residue{}) sum = sum - excess_of_two_null(w);
        return sum;
    }

    /// Theta of a common centre, with four pins: the factor of Gamma_uv.
    Residue common_centre_of_star(std::size_t w) const {
        const Residue c = common_centre(chart_, w);
        const std::size_t u = (w + 1) % 3, v = (w + 2) % 3;
        const auto over_lines_through_c = [&](const Polynomial& f, std::span<const Residue> roots) {
            return value_at(integral_over_quotient(f, roots), c);
        };
        Residue sum = over_lines_through_c(seen_[u] * seen_[v] * seen_[w], at_.x);
        for (const auto& [null, other] : {std::pair{u, v}, std::pair{v, u}}) {
            if (at_.exceptional[null] == Residue{}) continue;
            const Residue part =
                over_lines_through_c(seen_[other] * seen_[w], kernel_of_rank_one(null));
            sum = sum + at_.exceptional[null] * part;
        }
        return value_at(seen_[w], c) * sum;
    }

private:
    Roots roots_without_kernel() const { return without({at_.x.begin(), at_.x.end()}, {}); }

    Residue square_of_kappa(std::size_t u) const { return at_.w[u][0]; }

    Roots kernel_of_rank_one(std::size_t u) const {
        return without({at_.x.begin(), at_.x.end()}, square_of_kappa(u));
    }

    /// Of image vectors modulo kappa squared and an image of a point, on E_u.
    Residue rest_of_image(std::size_t u) const { return at_.w[u][1] + at_.w[u][2] - at_.image[u]; }

    /// The class of the line bundle of a pin, in x.
    Polynomial bundle_of_pins(const Polynomial& x) const { return constant(sum_h_ - c1_) + x; }

    /// The part of degree pins - 4 of (1 + L)^pins / c(N_u).
    LinearForm part_of_rank_one(std::size_t u) const {
        if (pins_ == 4) return {Residue{1}, {}, {}};
        const Residue two{2}, k{pins_};
        const Residue normal = at_.exceptional[u] + two * (sum_h_ - at_.h[u]) + square_of_kappa(u);
        return {k * (sum_h_ - c1_) - (normal - c1_), k - Residue{1}, two};
    }

    /// The part of degree pins - 3 of (1 + L)^pins / c(N_uv).
    Polynomial part_of_two_null(std::size_t w, const Polynomial& x, const Polynomial& l) const {
        const Polynomial a = constant(chart_.both[w] - c1_) + x;
        const Polynomial b = constant(square_of_kappa((w + 1) % 3)) - l;
        const Polynomial c = constant(square_of_kappa((w + 2) % 3)) - l;
        const Polynomial n1 = a + b + c, n2 = a * b + a * c + b * c;
        const Polynomial k = constant({pins_}), bundle = bundle_of_pins(x);
        if (pins_ == 4) return k * bundle - n1;
        const Polynomial pairs = constant({pins_ * (pins_ - 1) / 2});
        return pairs * bundle * bundle - k * bundle * n1 + n1 * n1 - n2;
    }

    /// That all views see a line through the kernel of u and v as a given point, in the class of
    /// the line modulo the kernel.
    Polynomial lines_through_kernel(std::size_t w) const {
        return seen_[0] * seen_[1] * seen_[2] * constant(value_at(seen_[w], {}));
    }

    /// What the integral of rank_one has over two null views u, v.
    Residue isotropic_part(std::size_t u, std::size_t v, std::size_t w,
                           const LinearForm& part) const {
        if (chart_.both[w] == Residue{}) return {};
        const Residue points = (rest_of_image(u) - c1_) * (part.l - part.x);
        const Polynomial f = seen_[v] * seen_[w] * constant(value_at(seen_[w], {})) *
                             Polynomial{{part.constant + points, part.l}};
        return chart_.both[w] * integral_over_points(f, without(kernel_of_rank_one(u), {}));
    }

    /// What the integral of centres_on_a_line has over two null views.
    Residue excess_of_two_null(std::size_t w) const {
        Residue rest = -chart_.both[w] - c1_;
        for (std::size_t view = 0; view < 3; ++view)
            if (view != w) rest = rest + square_of_kappa(view) + rest_of_image(view);
        const Polynomial f = lines_through_kernel(w) * Polynomial{{rest, Residue{1}}};
        return chart_.both[w] * integral_over_points(f, roots_without_kernel());
    }

    const Chart& chart_;
    const FixedPoint& at_;
    unsigned pins_ = 0;
    Residue sum_h_{}, c1_{};
    std::array<Polynomial, 3> seen_{};
};

bool is_star(const Feature& feature) {
    return feature.pins == 4 || feature.pins == 5;
}

/// The theorem's condition on the points other than the star that two views share: at most one; or
/// two, and the third view sees only a line of one of them.
static bool views_share_few_points(const Signature& signature) {
    for (std::size_t third = 0; third < 3; ++third) {
        const Views pair = all_views ^ 1U << third;
        std::size_t shared = 0, with_line = 0;
        for (std::size_t i = 0; i < feature_count; ++i) {
            const Feature& feature = features[i];
            if ((feature.point & pair) != pair || is_star(feature)) continue;
            shared += signature[i];
            if (!has_view(feature.point, third) && has_view(feature.views, third))
                with_line += signature[i];
        }
        if (shared > 2 || (shared == 2 && with_line == 0)) return false;
    }
    return true;
}

bool theorem_k_applies(const Signature& signature) {
    unsigned stars = 0, pins = 0;
    for (std::size_t i = 0; i < feature_count; ++i) {
        const Feature& feature = features[i];
        if (signature[i] == 0) continue;
        if (!is_star(feature) && feature.pins > 1) return false;
        if (is_star(feature)) {
            stars += signature[i];
            pins = feature.pins;
        }
    }
    return stars == 1 && (pins == 4 || views_share_few_points(signature));
}

LinearClass class_of_star(const Chart& chart, const Feature& star) {
    const Star corrections(chart, star.pins);
    LinearClass result = class_of(chart, star);
    if (star.pins == 5) result.constant = result.constant + corrections.centres_on_a_line();
    for (std::size_t view = 0; view < 3; ++view) {
        result.constant = result.constant - corrections.rank_one(view) - corrections.two_null(view);
        if (star.pins == 4)
            result.common[view] = result.common[view] + corrections.common_centre_of_star(view);
    }
    return result;
}
} // namespace checker::exactly
