// Theorem C of proofs/common_centres.md: to which signatures it applies, and their degrees, which
// are integrals over a third blow-up of the space M of calibrated cameras, in the loci where two
// views have a common centre. By the fixed points of the second blow-up (blown_up_cameras.h).
#pragma once

#include "proofs/computations/blown_up_cameras.h"

#include <optional>

namespace proofs::blown_up {

/// Whether Theorem C speaks of a signature.
inline bool has_degree_by_common_centres(const checker::Signature& signature) {
    return most_pins(signature) <= 3;
}

/// The locus where two views have a common centre, at a fixed point in it: the roots of its normal
/// bundle, and the class of the centre, a line of V.
struct CommonCentre {
    Triple normal{};
    Residue centre{};
};

inline bool is_null(const FixedPoint& at, std::size_t view) {
    return at.null_y[view] != Residue{};
}

/// That of two null views. If both maps D_v are 0 on V / H, the lines k_u and k_v meet. If both
/// have the direction of kappa kappa', there are special points, if the ratio of delta_u and
/// delta_v is right. This ratio is a section of the bundle of null_u - both.
inline std::optional<CommonCentre> centre_of_null(const Chart& chart, std::size_t u,
                                                  std::size_t v) {
    constexpr std::size_t delta = 0, in_tangent = 1;
    const FixedPoint& at = *chart.at;
    if (at.direction[u] != at.direction[v]) return std::nullopt;
    const Residue y_u = -twice(at.null_y[u]), y_v = -twice(at.null_y[v]), s = at.x[3];
    if (at.direction[u] == delta) return CommonCentre{{-s, y_u - s, y_v - s}, s};
    if (at.direction[u] != in_tangent) return std::nullopt;
    return CommonCentre{{chart.null[u] - chart.both[3 - u - v], y_u, y_v}, {}};
}

/// That of a null view and the regular one: its centre is on k_u if D_u and P_u are 0 on V / H.
inline std::optional<CommonCentre> centre_of_regular(const FixedPoint& at, std::size_t null) {
    if (at.direction[null] != 0 || at.translated == null) return std::nullopt;
    const Residue s = at.x[3];
    return CommonCentre{{at.w[null][0] - s, -s, -twice(at.null_y[null]) - s}, s};
}

/// That of the other two views than this one.
inline std::optional<CommonCentre> centre_without(const Chart& chart, std::size_t view) {
    const std::size_t u = (view + 1) % 3, v = (view + 2) % 3;
    if (!is_null(*chart.at, u)) return centre_of_regular(*chart.at, v);
    if (!is_null(*chart.at, v)) return centre_of_regular(*chart.at, u);
    return centre_of_null(chart, u, v);
}

/// The same chart with each root of the normal bundle as the class of the exceptional divisor. One
/// root may be 0, where the ratio of two equations is; others count 0 times then.
inline std::vector<Chart> blown_up_in(const CommonCentre& locus, std::size_t view,
                                      const Chart& chart) {
    std::vector<Chart> charts;
    for (std::size_t i = 0; i < 3; ++i) {
        const Residue n = locus.normal[i];
        const Residue a = locus.normal[(i + 1) % 3], b = locus.normal[(i + 2) % 3];
        Chart blown = chart;
        blown.factor = chart.factor * a * b * inverse(a - n) * inverse(b - n);
        blown.same_centre[view] = n;
        blown.centre[view] = locus.centre;
        if (blown.factor != Residue{}) charts.push_back(blown);
    }
    return charts;
}

/// The fixed points of the third blow-up over one of the first. The push-forward of a product of
/// powers of the exceptional divisors of different pairs is the product of their push-forwards.
inline std::vector<Chart> charts_of_third_blow_up(const FixedPoint& at) {
    std::vector<Chart> charts;
    for (const Chart& start : charts_over(at)) {
        std::vector<Chart> above{start};
        for (std::size_t view = 0; view < 3; ++view) {
            const std::optional<CommonCentre> locus = centre_without(start, view);
            if (!locus) continue;
            std::vector<Chart> next;
            for (const Chart& chart : above)
                for (const Chart& blown : blown_up_in(*locus, view, chart))
                    next.push_back(blown);
            above = next;
        }
        charts.insert(charts.end(), above.begin(), above.end());
    }
    return charts;
}

inline Integrals integrals_over_third_blow_up(std::uint64_t seed = 5) {
    return Integrals(seed, charts_of_third_blow_up);
}

} // namespace proofs::blown_up
