#include "checker/exactly/fixed_points.h"

#include <algorithm>
#include <random>
#include <stdexcept>

namespace checker::exactly {
/// A view in which the quaternion is kappa w at a fixed point of A. The weights of kappa^2, kappa
/// kappa', kappa'^2 in W, less that of the second, are twice y, 0 and minus twice y.
struct NullView {
    std::size_t view = 0;
    Residue y{};
};

/// A fixed point of the space A of quaternions.
struct Quaternions {
    Residue z{}; // the roots of S are z and -z
    Triple h{};
    std::vector<Residue> tangents{};
    std::vector<NullView> nulls{};
};

/// A coordinate of W / H, which V / H is at a fixed point of M: its view, and whether it is that of
/// kappa^2, kappa kappa' or kappa'^2.
struct Translation {
    std::size_t view = 0, power = 0;
    Residue weight{};
};

static Residue twice(Residue x) {
    return x + x;
}

Residue inverse(Residue x) {
    if (x == Residue{}) throw std::logic_error("the weights are not generic");
    return x.inverse();
}

/// The weights of kappa^2, kappa kappa', kappa'^2 in a null view.
static Triple image_vectors(const Quaternions& at, const NullView& null) {
    const Residue h = at.h[null.view];
    return {h + twice(null.y), h, h - twice(null.y)};
}

/// The tangents at a point with a regular view: the coordinates of the quaternions, but those of
/// weight 0, as scales are divided out, and but the roots of SL_2, which is divided out, too.
static std::vector<Residue> tangents_of_regular(const Quaternions& at, const Triple& y) {
    std::vector<Residue> tangents;
    for (std::size_t view = 0; view < 3; ++view) {
        const Residue scale = at.h[view] * Residue{2}.inverse();
        for (const Residue root : {at.z, -at.z})
            for (const Residue shift : {y[view], -y[view]})
                if (scale + root + shift != Residue{}) tangents.push_back(scale + root + shift);
    }
    for (const Residue root : {twice(at.z), -twice(at.z)}) {
        const auto found = std::ranges::find(tangents, root);
        if (found == tangents.end()) throw std::logic_error("a root of SL_2 is missing");
        tangents.erase(found);
    }
    return tangents;
}

/// The eight points where this view has an invertible quaternion and the others are null. Its root
/// z is y or -y: the Weyl group of SL_2 makes one point of both.
static void append_regular(std::vector<Quaternions>& all, const Triple& y, std::size_t regular) {
    for (unsigned signs = 0; signs < 8; ++signs) {
        const auto signed_by = [&](unsigned bit, Residue x) { return signs >> bit & 1 ? x : -x; };
        Quaternions at{.z = y[regular]};
        for (unsigned k = 1; k <= 2; ++k) {
            const std::size_t view = (regular + k) % 3;
            const Residue null_y = signed_by(k, y[view]);
            at.h[view] = -twice(signed_by(0, k == 1 ? at.z : -at.z) + null_y);
            at.nulls.push_back({view, null_y});
        }
        at.tangents = tangents_of_regular(at, y);
        all.push_back(at);
    }
}

/// The eight points where no quaternion is invertible: SL_2 keeps three different kernels, so z =
/// 0.
static void append_null(std::vector<Quaternions>& all, const Triple& y) {
    for (unsigned signs = 0; signs < 8; ++signs) {
        Quaternions at;
        for (std::size_t view = 0; view < 3; ++view) {
            const Residue null_y = signs >> view & 1 ? y[view] : -y[view];
            at.h[view] = -twice(null_y);
            at.tangents.insert(at.tangents.end(), 2, at.h[view]);
            at.nulls.push_back({view, null_y});
        }
        all.push_back(at);
    }
}

/// The coordinates of W / H. H is the image of the regular view, or all kappa^2.
static std::vector<Translation> translations(const Quaternions& at) {
    std::vector<Translation> result;
    for (const NullView& null : at.nulls) {
        const Triple weights = image_vectors(at, null);
        for (std::size_t power = at.nulls.size() == 3 ? 1 : 0; power < 3; ++power)
            result.push_back({null.view, power, weights[power]});
    }
    return result;
}

/// The fixed point of M at the line `chosen` of W / H.
static FixedPoint point_of_moduli(const Quaternions& at, const Translation& chosen,
                                  const Triple& y) {
    FixedPoint point{.x = {twice(at.z), {}, -twice(at.z), chosen.weight}, .h = at.h};
    point.image = at.h;
    for (std::size_t view = 0; view < 3; ++view)
        point.w[view] = image_vectors(at, {view, y[view]});
    for (const NullView& null : at.nulls)
        point.w[null.view] = image_vectors(at, null);
    Residue normal{1};
    for (const Residue tangent : at.tangents)
        normal = normal * tangent;
    for (const Translation& other : translations(at))
        if (other.view != chosen.view || other.power != chosen.power)
            normal = normal * (other.weight - chosen.weight);
    point.weight = inverse(normal);
    return point;
}

/// The three points of the blow-up in Y_v over one in Y_v. The normal coordinates are delta and the
/// coefficients of kappa kappa' and kappa'^2 in the image of V / H.
static void append_blown_up(std::vector<FixedPoint>& points, const FixedPoint& at,
                            std::size_t view) {
    const Triple& w = at.w[view];
    const Triple normals{at.h[view], w[1] - at.x[3], w[2] - at.x[3]};
    for (std::size_t i = 0; i < 3; ++i) {
        const Residue e = normals[i];
        FixedPoint blown = at;
        for (std::size_t j = 0; j < 3; ++j)
            if (j != i) blown.weight = blown.weight * normals[j] * inverse(normals[j] - e);
        blown.w[view] = {w[0], w[1] - e, w[2] - e};
        blown.image[view] = at.h[view] - e;
        blown.exceptional[view] = e;
        points.push_back(blown);
    }
}

/// The fixed points of the first blow-up over one of M.
static std::vector<FixedPoint> points_over(const Quaternions& at, const Translation& chosen,
                                           const Triple& y) {
    std::vector<FixedPoint> points{point_of_moduli(at, chosen, y)};
    for (const NullView& null : at.nulls) {
        const bool rank_two = chosen.view == null.view && chosen.power > 0; // so not in Y_v
        if (rank_two) continue;
        std::vector<FixedPoint> above;
        for (const FixedPoint& point : points)
            append_blown_up(above, point, null.view);
        points = above;
    }
    return points;
}

std::vector<FixedPoint> fixed_points(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Triple y{};
    for (Residue& shift : y)
        shift = Residue::of(random());
    std::vector<Quaternions> quaternions;
    for (std::size_t regular = 0; regular < 3; ++regular)
        append_regular(quaternions, y, regular);
    append_null(quaternions, y);
    std::vector<FixedPoint> points;
    for (const Quaternions& at : quaternions)
        for (const Translation& chosen : translations(at)) {
            const std::vector<FixedPoint> above = points_over(at, chosen, y);
            points.insert(points.end(), above.begin(), above.end());
        }
    return points;
}

/// The fixed points of the second blow-up over one of the first, if the classes d_v of the divisors
/// of null cameras are not the same, unless they are 0. The blow-up is toric: there is a point for
/// each order i, j, k, with the tangents d_i, d_j - d_i, d_k - d_j.
static void append_toric(std::vector<Chart>& charts, const FixedPoint& at) {
    const Triple& d = at.image;
    std::vector<std::size_t> views;
    for (std::size_t view = 0; view < 3; ++view)
        if (d[view] != Residue{}) views.push_back(view);
    do {
        Chart chart{at};
        for (std::size_t i = 0; i + 1 < views.size(); ++i) {
            const Residue own = d[views[i]], next = d[views[i + 1]];
            chart.at.weight = chart.at.weight * next * inverse(next - own);
            for (std::size_t j = i + 1; j < views.size(); ++j)
                chart.both[3 - views[i] - views[j]] = own;
        }
        charts.push_back(chart);
    } while (std::ranges::next_permutation(views).found);
}

/// The factors by which a polynomial's value at 0 is a sum of those at 1, 2, ..., `samples`.
static std::vector<Residue> lagrange_factors(std::uint64_t samples) {
    std::vector<Residue> factors;
    for (std::uint64_t t = 1; t <= samples; ++t) {
        Residue factor{1};
        for (std::uint64_t u = 1; u <= samples; ++u)
            if (u != t) factor = factor * Residue{u} * (Residue{u} - Residue{t}).inverse();
        factors.push_back(factor);
    }
    return factors;
}

/// The directions in which classes d_v move apart: 0 for the first of those that are the same.
static Triple moves_of(const Triple& d) {
    Triple moves{};
    for (std::size_t view = 1; view < 3; ++view)
        for (std::size_t other = 0; other < view; ++other)
            if (d[view] != Residue{} && d[view] == d[other]) moves[view] = Residue{view};
    return moves;
}

static void append_charts(std::vector<Chart>& charts, const FixedPoint& at) {
    const Triple moves = moves_of(at.image);
    if (moves == Triple{}) return append_toric(charts, at);
    constexpr std::uint64_t samples = 12;
    static const std::vector<Residue> factors = lagrange_factors(samples);
    for (std::uint64_t t = 1; t <= samples; ++t) {
        FixedPoint sample = at;
        sample.weight = at.weight * factors[t - 1];
        for (std::size_t view = 0; view < 3; ++view) {
            if (moves[view] == Residue{}) continue;
            sample.image[view] = at.image[view] + Residue{t} * moves[view];
            sample.w[view][1] = sample.image[view]; // the class of kappa kappa', the same one
        }
        append_toric(charts, sample);
    }
}

std::vector<Chart> charts_of_second_blow_up(std::uint64_t seed) {
    std::vector<Chart> charts;
    for (const FixedPoint& at : fixed_points(seed))
        append_charts(charts, at);
    return charts;
}
} // namespace checker::exactly
