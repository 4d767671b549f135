#include "prover/solver/images.h"

#include "prover/solver/consistency.h"
#include "prover/solver/exact_vector.h"
#include "prover/system/exit.h"

#include <cmath>

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

std::string notation(const ImagedProblem& problem) {
    return problem.general ? notation(*problem.general) : notation(problem.features);
}

namespace {

/// Moves the point, in pixels, onto the line through two others. Returns by how much.
double move_onto_line(ExactVector& point, const ExactVector& a, const ExactVector& b) {
    const std::array<mpq_class, 2> along{b[0] - a[0], b[1] - a[1]};
    const mpq_class length = along[0] * along[0] + along[1] * along[1];
    if (length == 0) return 0; // refuse_degenerate() says so
    const mpq_class part = ((point[0] - a[0]) * along[0] + (point[1] - a[1]) * along[1]) / length;
    const ExactVector moved{a[0] + part * along[0], a[1] + part * along[1], 1};
    const mpq_class x = moved[0] - point[0], y = moved[1] - point[1];
    point = moved;
    return std::sqrt(mpq_class(x * x + y * y).get_d());
}

/// Makes points of one line lie on one, in each view; their pins pass through them again.
double make_collinear(const Problem& problem, std::vector<std::vector<GivenSighting>>& features) {
    double moved = 0;
    for (std::size_t p = 0; p < problem.points.size(); ++p) {
        const auto line = carrier(problem, static_cast<int>(p));
        if (!line) continue;
        const std::vector<int>& on_it = problem.lines[static_cast<std::size_t>(*line)].points;
        const auto& first = features[static_cast<std::size_t>(on_it[0])];
        const auto& second = features[static_cast<std::size_t>(on_it[1])];
        for (std::size_t view = 0; view < features[p].size(); ++view) {
            auto& [point, lines] = features[p][view];
            if (!point || !first[view].point || !second[view].point) continue;
            moved =
                std::max(moved, move_onto_line(*point, *first[view].point, *second[view].point));
            for (auto& pin : lines)
                if (pin)
                    pin->coefficients[2] =
                        -(pin->coefficients[0] * (*point)[0] + pin->coefficients[1] * (*point)[1]);
        }
    }
    return moved;
}

} // namespace

ConsistentImages consistent(const GivenImages& images) {
    ConsistentImages result;
    auto features = images.features;
    for (auto& views : features)
        for (GivenSighting& sighting : views)
            if (sighting.point && !meet(sighting))
                result.moved = std::max(result.moved, make_meet(sighting));
    if (images.general)
        result.moved = std::max(result.moved, make_collinear(*images.general, features));
    for (const auto& views : features) {
        auto& feature = result.features.emplace_back();
        for (std::size_t v = 0; v < views.size(); ++v)
            feature.push_back(normalised(images.calibration[v], views[v]));
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
