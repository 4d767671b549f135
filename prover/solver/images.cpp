#include "prover/solver/images.h"

#include "prover/solver/consistency.h"
#include "prover/solver/exact_vector.h"
#include "prover/system/exit.h"

namespace plprove {

namespace {

Eigen::Vector3d rounded(const ExactVector& x) {
    return {x[0].get_d(), x[1].get_d(), x[2].get_d()};
}

/// Scaled so that doubles hold it, whatever its size.
Eigen::Vector3d rounded_direction(ExactVector x) {
    mpq_class largest = 0;
    for (const mpq_class& coordinate : x)
        if (abs(coordinate) > largest) largest = abs(coordinate);
    for (mpq_class& coordinate : x)
        coordinate /= largest;
    return rounded(x);
}

bool meet(const GivenSighting& sighting) {
    for (const auto& line : sighting.lines)
        if (line && dot(line->coefficients, *sighting.point) != 0) return false;
    return true;
}

/// Moves the point and the lines of the sighting together. Returns by how much.
double make_meet(GivenSighting& sighting) {
    std::vector<PixelLine> lines;
    for (const auto& line : sighting.lines) {
        if (!line) continue;
        PixelLine& pixel = lines.emplace_back();
        pixel.coefficients = rounded_direction(line->coefficients);
        for (const auto& [x, y] : line->points)
            pixel.points.emplace_back(x.get_d(), y.get_d());
    }
    const PixelStar star = nearest_star(rounded(*sighting.point).head<2>(), lines);
    sighting.point = ExactVector{mpq_class(star.point[0]), mpq_class(star.point[1]), 1};
    auto moved = star.lines.begin();
    for (auto& line : sighting.lines) {
        if (!line) continue;
        const Eigen::Vector3d& l = *moved++;
        line->coefficients = {mpq_class(l[0]), mpq_class(l[1]), mpq_class(l[2])};
    }
    return star.moved;
}

using Calibration = std::array<ExactVector, 3>;

/// K^-1 x for an upper triangular K.
ExactVector normalised_point(const Calibration& K, const ExactVector& x) {
    ExactVector result;
    for (int i = 2; i >= 0; --i) {
        const auto row = static_cast<std::size_t>(i);
        mpq_class rest = x[row];
        for (std::size_t k = row + 1; k < 3; ++k)
            rest -= K[row][k] * result[k];
        result[row] = rest / K[row][row];
    }
    return result;
}

/// K^T l.
ExactVector normalised_line(const Calibration& K, const ExactVector& l) {
    ExactVector result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = K[0][i] * l[0] + K[1][i] * l[1] + K[2][i] * l[2];
    return result;
}

ExactSighting normalised(const Calibration& K, const GivenSighting& sighting) {
    ExactSighting result;
    if (sighting.point) result.point = normalised_point(K, *sighting.point);
    for (const auto& line : sighting.lines) {
        result.lines.emplace_back();
        if (line) result.lines.back() = normalised_line(K, line->coefficients);
    }
    return result;
}

} // namespace

ConsistentImages consistent(const GivenImages& images) {
    ConsistentImages result;
    for (const auto& views : images.features) {
        auto& feature = result.features.emplace_back();
        for (std::size_t v = 0; v < views.size(); ++v) {
            GivenSighting sighting = views[v];
            if (sighting.point && !meet(sighting))
                result.moved = std::max(result.moved, make_meet(sighting));
            feature.push_back(normalised(images.calibration[v], sighting));
        }
    }
    return result;
}

SeenImages rounded(const GivenImages& images, const ConsistentImages& consistent) {
    SeenImages result;
    for (const auto& views : consistent.features) {
        auto& feature = result.observation.emplace_back();
        for (const ExactSighting& exact : views) {
            Sighting& sighting = feature.emplace_back();
            if (exact.point) sighting.point = rounded(*exact.point);
            for (const auto& line : exact.lines) {
                sighting.lines.emplace_back();
                if (line) sighting.lines.back() = rounded_direction(*line);
            }
        }
    }
    for (const Calibration& exact : images.calibration) {
        Eigen::Matrix3d& K = result.calibration.emplace_back();
        for (int i = 0; i < 3; ++i)
            K.row(i) = rounded(exact[static_cast<std::size_t>(i)]);
    }
    return result;
}

std::string name_of(const GivenImages& images, std::size_t feature) {
    std::string name =
        "feature " + std::to_string(feature + 1) + " (" + notation(images.problem[feature]);
    if (!images.names[feature].empty()) name += ", " + images.names[feature];
    return name + ")";
}

namespace {

bool parallel(const ExactVector& a, const ExactVector& b) {
    return a[0] * b[1] == a[1] * b[0] && a[0] * b[2] == a[2] * b[0] && a[1] * b[2] == a[2] * b[1];
}

bool parallel(const std::optional<ExactVector>& a, const std::optional<ExactVector>& b) {
    return a && b ? parallel(*a, *b) : a.has_value() == b.has_value();
}

/// All points, or all lines, that a view sees, with the features that they belong to.
using Seen = std::vector<std::pair<std::size_t, ExactVector>>;

void refuse_equal(const GivenImages& images, const Seen& seen, std::size_t view,
                  const std::string& what) {
    for (std::size_t i = 0; i < seen.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (parallel(seen[i].second, seen[j].second))
                throw BadInput("view " + std::to_string(view + 1) + " sees " +
                               name_of(images, seen[j].first) + " and " +
                               name_of(images, seen[i].first) + " at the same " + what +
                               ": give images with different ones");
}

/// The images as given, in normalised coordinates: [feature][view].
using NormalisedImages = std::vector<std::vector<ExactSighting>>;

NormalisedImages normalised(const GivenImages& images) {
    NormalisedImages result;
    for (const auto& views : images.features) {
        auto& feature = result.emplace_back();
        for (std::size_t v = 0; v < views.size(); ++v)
            feature.push_back(normalised(images.calibration[v], views[v]));
    }
    return result;
}

bool see_the_same(const NormalisedImages& images, std::size_t view, std::size_t other) {
    for (const auto& feature : images) {
        const ExactSighting &a = feature[view], &b = feature[other];
        if (!parallel(a.point, b.point)) return false;
        for (std::size_t line = 0; line < a.lines.size(); ++line)
            if (!parallel(a.lines[line], b.lines[line])) return false;
    }
    return true;
}

} // namespace

void refuse_degenerate(const GivenImages& images) {
    const std::size_t views = images.calibration.size();
    const NormalisedImages sightings = normalised(images);
    for (std::size_t v = 0; v < views; ++v) {
        Seen points, lines;
        for (std::size_t f = 0; f < sightings.size(); ++f) {
            const ExactSighting& sighting = sightings[f][v];
            if (sighting.point) points.emplace_back(f, *sighting.point);
            for (const auto& line : sighting.lines)
                if (line) lines.emplace_back(f, *line);
        }
        refuse_equal(images, points, v, "point");
        refuse_equal(images, lines, v, "line");
        for (std::size_t other = 0; other < v; ++other)
            if (see_the_same(sightings, v, other))
                throw BadInput("views " + std::to_string(other + 1) + " and " +
                               std::to_string(v + 1) +
                               " see the same: all rays are parallel, and nothing fixes the "
                               "distance of the cameras: give images from different places");
    }
}

} // namespace plprove
