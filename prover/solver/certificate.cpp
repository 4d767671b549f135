#include "prover/solver/certificate.h"

#include "prover/solver/exact_vector.h"

#include <algorithm>
#include <cmath>

namespace plprove {

namespace {

/// Any other point: it gives a line through this one.
IntegerVector other_than(const IntegerVector& point) {
    const IntegerVector usual{3, -5, 7}, other{5, 7, 3};
    return exact_cross(exact(point), exact(usual)) == ExactVector{0, 0, 0} ? other : usual;
}

/// Makes vectors of integers up to `largest`, and remembers how far they are from what was given.
class Rounding {
public:
    explicit Rounding(std::int64_t largest) : largest_(largest) {}

    IntegerVector of(const ExactVector& x) {
        if (const auto same = proportional(x, largest_)) return *same;
        const IntegerVector near = nearest(x, largest_);
        note(angle(exact(near), x));
        return near;
    }

    /// Another point of the line through the point that is nearest to `line`.
    IntegerVector point_on(const ExactVector& line, const IntegerVector& point) {
        const ExactVector through = exact(point);
        if (dot(line, through) == 0)
            for (const ExactVector& other :
                 {ExactVector{0, 0, 1}, ExactVector{0, 1, 0}, ExactVector{1, 0, 0}, through})
                if (const auto meet = meeting_point(line, other, through)) return *meet;
        const IntegerVector second = nearest(exact_cross(line, through), largest_);
        note(angle(exact_cross(through, exact(second)), line));
        return second;
    }

    bool exact_so_far() const { return exact_; }
    double moved() const { return moved_; }

private:
    /// The meet of two lines, if it has few digits and is not `through`.
    std::optional<IntegerVector> meeting_point(const ExactVector& line, const ExactVector& other,
                                               const ExactVector& through) const {
        const ExactVector meet = exact_cross(line, other);
        if (exact_cross(meet, through) == ExactVector{0, 0, 0}) return std::nullopt;
        return proportional(meet, largest_);
    }

    void note(double by) {
        exact_ = false;
        moved_ = std::max(moved_, by);
    }

    std::int64_t largest_;
    bool exact_ = true;
    double moved_ = 0;
};

Eigen::Vector3d vector(const IntegerVector& x) {
    return {static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2])};
}

} // namespace

IntegerImages integer_images(const SolvePlan& plan, const CameraSystem& system,
                             const ConsistentImages& images) {
    Rounding rounding(999'999'999'999'999'999); // as FORMAT.md, section 9, allows
    IntegerImages result;
    IntegerVector point{};
    for (const FreeVector& free : system.free) {
        const SourceFeature& source = plan.sources[static_cast<std::size_t>(free.feature)];
        const auto view =
            static_cast<std::size_t>(plan.view_of[static_cast<std::size_t>(free.view)]);
        const ExactSighting& sighting = images.features[source.feature][view];
        if (free.line < 0) { // the point precedes its lines
            point = rounding.of(*sighting.point);
            result.vectors.push_back(point);
            continue;
        }
        const int pin = source.pins[static_cast<std::size_t>(free.line)];
        const auto& line = sighting.lines[static_cast<std::size_t>(pin)];
        if (!free.toward)
            result.vectors.push_back(rounding.of(*line));
        else if (line)
            result.vectors.push_back(rounding.point_on(*line, point));
        else
            result.vectors.push_back(other_than(point));
    }
    result.exact = rounding.exact_so_far();
    result.moved = rounding.moved();
    return result;
}

FivePointImages five_point_images(const SolvePlan& plan, const ConsistentImages& images) {
    constexpr std::int64_t largest = 999'999'999; // as FORMAT.md, section 14, allows
    Rounding rounding(largest);
    FivePointImages result;
    for (std::size_t view = 0; view < 2; ++view) {
        std::vector<int>& numbers = result.views.emplace_back();
        for (const SourceFeature& source : plan.sources) {
            const ExactSighting& sighting = images.features[source.feature][view];
            const IntegerVector vector = rounding.of(*sighting.point);
            // Vectors of about the same length suit Newton's method.
            const std::int64_t factor =
                largest / std::max({std::abs(vector[0]), std::abs(vector[1]), std::abs(vector[2])});
            for (const std::int64_t coordinate : vector)
                numbers.push_back(static_cast<int>(factor * coordinate));
        }
    }
    result.exact = rounding.exact_so_far();
    result.moved = rounding.moved();
    return result;
}

std::vector<Eigen::Vector3d> unit_vectors(const IntegerImages& images) {
    std::vector<Eigen::Vector3d> result;
    for (const IntegerVector& x : images.vectors)
        result.push_back(vector(x).normalized());
    return result;
}

DegreeCertificate certify_images(const Start& start, const CameraSystem& system,
                                 const IntegerImages& images,
                                 const std::vector<CameraPoint>& zeros) {
    DegreeCertificate certificate = certify_zeros(system, images.vectors, zeros);
    certificate.number = start.number;
    return certificate;
}

} // namespace plprove
