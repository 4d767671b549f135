#include "prover/solver/certificate.h"

#include <cmath>

namespace plprove {

namespace {

constexpr std::int64_t largest = 999'999'999'999'999'999; // as FORMAT.md allows for images

IntegerVector integers(const std::array<mpz_class, 3>& x) {
    return {x[0].get_si(), x[1].get_si(), x[2].get_si()};
}

/// The proportional integer vector without a common divisor; nothing if it has more digits.
std::optional<IntegerVector> proportional(const ExactVector& x) {
    mpz_class denominator = 1, divisor = 0;
    for (const mpq_class& coordinate : x)
        denominator = lcm(denominator, coordinate.get_den());
    std::array<mpz_class, 3> result;
    for (std::size_t k = 0; k < 3; ++k) {
        result[k] = x[k].get_num() * (denominator / x[k].get_den());
        divisor = gcd(divisor, result[k]);
    }
    for (mpz_class& coordinate : result) {
        coordinate /= divisor;
        if (abs(coordinate) > largest) return std::nullopt;
    }
    return integers(result);
}

/// The vector of the same direction whose largest coordinate has all digits, rounded.
IntegerVector nearest(const ExactVector& x) {
    mpq_class size = 0;
    for (const mpq_class& coordinate : x)
        size = std::max<mpq_class>(size, abs(coordinate));
    std::array<mpz_class, 3> result;
    for (std::size_t k = 0; k < 3; ++k) {
        const mpq_class twice = 2 * largest * x[k] / size + 1;
        mpz_fdiv_q(result[k].get_mpz_t(), twice.get_num_mpz_t(),
                   mpz_class(2 * twice.get_den()).get_mpz_t());
    }
    return integers(result);
}

mpq_class dot(const ExactVector& a, const ExactVector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

ExactVector exact_cross(const ExactVector& a, const ExactVector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

ExactVector exact(const IntegerVector& x) {
    return {mpq_class(x[0]), mpq_class(x[1]), mpq_class(x[2])};
}

double angle(const ExactVector& a, const ExactVector& b) {
    const ExactVector normal = exact_cross(a, b);
    const mpq_class squared_sine = dot(normal, normal) / (dot(a, a) * dot(b, b));
    return std::asin(std::min(1.0, std::sqrt(squared_sine.get_d())));
}

/// Any other point: it gives a line through this one.
IntegerVector other_than(const IntegerVector& point) {
    const IntegerVector usual{3, -5, 7}, other{5, 7, 3};
    return exact_cross(exact(point), exact(usual)) == ExactVector{0, 0, 0} ? other : usual;
}

/// Makes integer vectors, and remembers how far they are from what was given.
class Rounding {
public:
    IntegerVector of(const ExactVector& x) {
        if (const auto same = proportional(x)) return *same;
        const IntegerVector near = nearest(x);
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
        const IntegerVector second = nearest(exact_cross(line, through));
        note(angle(exact_cross(through, exact(second)), line));
        return second;
    }

    bool exact_so_far() const { return exact_; }
    double moved() const { return moved_; }

private:
    /// The meet of two lines, if it has few digits and is not `through`.
    static std::optional<IntegerVector>
    meeting_point(const ExactVector& line, const ExactVector& other, const ExactVector& through) {
        const ExactVector meet = exact_cross(line, other);
        if (exact_cross(meet, through) == ExactVector{0, 0, 0}) return std::nullopt;
        return proportional(meet);
    }

    void note(double by) {
        exact_ = false;
        moved_ = std::max(moved_, by);
    }

    bool exact_ = true;
    double moved_ = 0;
};

Eigen::Vector3d vector(const IntegerVector& x) {
    return {static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2])};
}

} // namespace

IntegerImages integer_images(const SolvePlan& plan, const CameraSystem& system,
                             const ConsistentImages& images) {
    Rounding rounding;
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
    if (certificate.degree() == start.degree()) certificate.evidence = start.evidence;
    return certificate;
}

} // namespace plprove
