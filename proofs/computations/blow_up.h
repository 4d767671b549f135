// Products of classes on the blow-up of the space M of cameras in the stratum (i), for Theorem R of
// proofs/relations.md (section 9 there). Sigma is the closed stratum, of dimension 8, and X the
// exceptional divisor.
#pragma once

#include "proofs/computations/camera_space.h"

namespace proofs {

/// The part of this degree of 1 / (1 + 6 a_v), the Segre class of the curve t = u in the plane.
inline CubeClass segre_class_of_curve(unsigned view, unsigned degree) {
    CubeClass result{};
    if (degree == 0) result[0] = 1;
    if (degree == 1) result[bit_of(view)] = -6;
    return result;
}

inline CubeClass operator*(std::int64_t factor, CubeClass cube) {
    for (std::int64_t& coefficient : cube)
        coefficient *= factor;
    return cube;
}

/// k^i y^j on N_v, the relative poses with n_v = 0, pushed forward to C x C.
inline CubeClass from_degenerate_poses(unsigned view, unsigned k, unsigned y) {
    if (y == 0) return k == 2 ? CubeClass{1} : CubeClass{};
    if (y == 1) return {};
    return sign(y - 1) * (segre_class_of_curve(view, y - 2) * power(epipole_class(view), k));
}

/// h_2, h_3 and b of a monomial.
inline CubeClass rotations_of(const Monomial& m) {
    const CubeClass point{0, 0, 0, 0, 1};
    return power(rotation_class(2), m[h2]) * power(rotation_class(3), m[h3]) * power(point, m[b]);
}

/// A monomial without e and x, on the bundle of lines over N_2 x N_3 with v_2 = v_3.
inline std::int64_t on_degenerate_bundle(const Monomial& m) {
    const auto on_both = [](const Monomial& term) {
        const CubeClass poses = from_degenerate_poses(2, term[k2], term[y2]) *
                                from_degenerate_poses(3, term[k3], term[y3]);
        return (rotations_of(term) * poses)[7];
    };
    return on_bundle_over(on_both, m);
}

/// y^j on the curve bundle that is exceptional in N_v, pushed forward to C x C.
inline CubeClass from_exceptional_curve(unsigned view, unsigned y) {
    if (y == 0) return {};
    return sign(y) * segre_class_of_curve(view, y - 1);
}

/// A monomial without e and x, on the part of B in the proper transform of Sigma: y_2 = y_3 = 0
/// and s_2 = s_3.
inline std::int64_t on_degenerate_centre(const Monomial& m) {
    const CubeClass of_xi{0, 2, 2, 0, 2};
    const CubeClass epipoles =
        power(epipole_class(2), m[k2]) * power(epipole_class(3), m[k3]) * power(of_xi, m[xi]);
    const CubeClass of_blow_ups =
        from_exceptional_curve(2, m[y2]) * from_exceptional_curve(3, m[y3]);
    return (rotations_of(m) * epipoles * of_blow_ups)[7];
}

/// A monomial without x, on Sigma.
inline std::int64_t on_sigma(const Monomial& m) {
    if (m[e] == 0) return on_degenerate_bundle(m);
    if (m[e] < 3) return 0;
    const unsigned degree = m[e] - 3; // the Segre class of the centre is 1 / (1 + y_2) (1 + y_3)
    std::int64_t sum = 0;
    for (unsigned i = 0; i <= degree; ++i) {
        Monomial with_segre = m;
        with_segre[y2] += i;
        with_segre[y3] += degree - i;
        sum += on_degenerate_centre(with_segre);
    }
    return sign(m[e] - 1) * sign(degree) * sum;
}

/// The part of this degree of the Segre class of Sigma in M.
inline Cycle segre_class_of_sigma(unsigned degree) {
    const Cycle of_n2 = 2 * class_of(h2) - class_of(y2), of_n3 = 2 * class_of(h3) - class_of(y3);
    const Cycle of_delta = 2 * class_of(b) - class_of(e);
    Cycle sum;
    for (unsigned i = 0; i <= degree; ++i)
        for (unsigned j = 0; i + j <= degree; ++j)
            sum = sum + power(of_n2, i) * power(of_n3, j) * power(of_delta, degree - i - j);
    return sign(degree) * sum;
}

/// The degree of a class on X, of dimension 10, where x is the class of X itself.
inline std::int64_t degree_on_blow_up(const Cycle& cycle) {
    std::map<unsigned, Cycle> by_power; // of x
    for (const auto& [monomial, coefficient] : cycle) {
        Monomial rest = monomial;
        rest[x] = 0;
        by_power[monomial[x]][rest] += coefficient;
    }
    std::int64_t sum = 0;
    for (const auto& [exponent, rest] : by_power) {
        if (exponent < 2) continue;
        for (const auto& [monomial, coefficient] : rest* segre_class_of_sigma(exponent - 2))
            sum += sign(exponent) * coefficient * on_sigma(monomial);
    }
    return sum;
}

/// The class on X whose product with x this is.
inline Cycle divided_by_x(const Cycle& cycle) {
    Cycle quotient;
    for (const auto& [monomial, coefficient] : cycle) {
        if (coefficient == 0) continue;
        Monomial less = monomial;
        --less[x];
        quotient[less] += coefficient;
    }
    return quotient;
}

} // namespace proofs
