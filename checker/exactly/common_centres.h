// The third blow-up, in the loci C_uv where two views have a common centre, and the classes of
// features on it (Theorem C of proofs/three_views/). A class is linear in the exceptional divisors
// Gamma_uv. What a product of powers of these is on the space below, Lemma C2 says.
#pragma once

#include "checker/exactly/fixed_points.h"
#include "checker/exactly/polynomial.h"
#include "checker/problem/features.h"

namespace checker::exactly {
/// A class at a chart: the constant, and the factors of the three Gamma_uv.
struct LinearClass {
    Residue constant{};
    Triple common{};
};

/// The class of the common centre of the other two views than the third one, a line of V.
Residue common_centre(const Chart& chart, std::size_t third);

/// The class S_v of the condition that X is where the view sees it, in the class of X.
Polynomial point_seen(const FixedPoint& at, std::size_t view);

/// The product S^f of all that the views in `views` see of a feature with a point.
Polynomial feature_seen(const FixedPoint& at, const Feature& feature, Views views);

/// The class of a feature without Gamma: Lemma C6, where no two views have a common centre.
Residue class_without_centres(const Chart& chart, const Feature& feature);

/// The class of a feature with at most three pins (Lemma C6).
LinearClass class_of(const Chart& chart, const Feature& feature);

/// The numbers rho^0, ..., rho^most of Lemma C2, which replace the powers of Gamma_uv.
std::vector<Residue> powers_of_common_centres(const Chart& chart, std::size_t third,
                                              std::size_t most);
} // namespace checker::exactly
