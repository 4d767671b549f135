// Certified solutions against the scenes that they must come from, in exact arithmetic.
#include "prover/three_views/degree.h"
#include "prover/three_views/integer_images.h"
#include "tests/support/solved_class.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <gmpxx.h>

using namespace plprove;

namespace {

/// Numbers a + b i with rational a and b.
struct Gaussian {
    mpq_class re, im;
};
Gaussian operator+(const Gaussian& a, const Gaussian& b) {
    return {a.re + b.re, a.im + b.im};
}
Gaussian operator-(const Gaussian& a, const Gaussian& b) {
    return {a.re - b.re, a.im - b.im};
}
Gaussian operator*(const Gaussian& a, const Gaussian& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
Gaussian operator/(const Gaussian& a, const Gaussian& b) {
    const mpq_class square = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / square, (a.im * b.re - a.re * b.im) / square};
}
Gaussian exactly(const Complex& z) {
    return {mpq_class(z.real()), mpq_class(z.imag())};
}
double size(const Gaussian& a) {
    return std::hypot(a.re.get_d(), a.im.get_d());
}

using Exact3 = std::array<Gaussian, 3>;

Gaussian dot(const Exact3& a, const Exact3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Exact3 exact_cross(const Exact3& a, const Exact3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Exact3 difference(const Exact3& a, const Exact3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double size(const Exact3& a) {
    return size(a[0]) + size(a[1]) + size(a[2]);
}

using Quaternion = std::array<Gaussian, 4>;

Quaternion product(const Quaternion& a, const Quaternion& b) {
    return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
            a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
}

/// A camera with rational coordinates: x -> R (x - c).
struct ExactCamera {
    std::array<Exact3, 3> rows;
    Exact3 centre;

    ExactCamera(const std::array<Complex, 4>& quaternion, const Complex3& at) {
        for (std::size_t k = 0; k < 3; ++k)
            centre[k] = exactly(at[k]);
        Quaternion q;
        for (std::size_t k = 0; k < 4; ++k)
            q[k] = exactly(quaternion[k]);
        // The rotation of v is the imaginary part of q v q^*.
        const Gaussian zero{}, one{1, 0};
        const Quaternion adjoint{q[0], zero - q[1], zero - q[2], zero - q[3]};
        for (std::size_t column = 0; column < 3; ++column) {
            Quaternion unit{};
            unit[column + 1] = one;
            const Quaternion image = product(product(q, unit), adjoint);
            for (std::size_t row = 0; row < 3; ++row)
                rows[row][column] = image[row + 1];
        }
    }
    Exact3 turn(const Exact3& d) const {
        return {dot(rows[0], d), dot(rows[1], d), dot(rows[2], d)};
    }
    /// R^T x.
    Exact3 back(const Exact3& x) const {
        Exact3 result;
        for (std::size_t k = 0; k < 3; ++k)
            result[k] = rows[0][k] * x[0] + rows[1][k] * x[1] + rows[2][k] * x[2];
        return result;
    }
};

Exact3 exactly(const IntegerVector& x) {
    return {Gaussian{x[0], 0}, Gaussian{x[1], 0}, Gaussian{x[2], 0}};
}

using ExactCameras = std::array<ExactCamera, 3>;

/// The image lines that each view sees, in the order of the pins.
using ImageLines = std::array<std::vector<Exact3>, 3>;

ImageLines image_lines(const FeatureImage& image) {
    ImageLines lines;
    for (std::size_t v = 0; v < 3; ++v) {
        const ViewImage& view = image.views[v];
        for (const auto& line : view.lines)
            lines[v].push_back(view.point ? exact_cross(exactly(*view.point), exactly(line))
                                          : exactly(line));
    }
    return lines;
}

/// A vector of an image: a point that gives a ray, or a line that gives a plane.
struct InView {
    std::size_t view;
    Exact3 vector;
};

/// A line through the image point, or a point of the image line; any will do.
Exact3 auxiliary(const Exact3& x) {
    return exact_cross(x, exactly(IntegerVector{3, 1, 4}));
}

/// The image point of the first view that sees one, or else a point of the first image line.
InView ray_of(const FeatureImage& image, const ImageLines& lines) {
    for (std::size_t v = 0; v < 3; ++v)
        if (image.views[v].point) return {v, exactly(*image.views[v].point)};
    for (std::size_t v = 0; v < 3; ++v)
        if (!lines[v].empty()) return {v, auxiliary(lines[v][0])};
    throw std::logic_error("no view sees the feature");
}

/// An image line that contains the image of the point, in the first other view that has one.
InView plane_of(const FeatureImage& image, const ImageLines& lines, std::size_t other_than) {
    for (std::size_t v = 0; v < 3; ++v) {
        if (v == other_than) continue;
        if (image.views[v].point) return {v, auxiliary(exactly(*image.views[v].point))};
        if (!lines[v].empty()) return {v, lines[v][0]};
    }
    throw std::logic_error("only one view sees the feature");
}

/// The point of the feature in space, where a ray and a plane meet.
Exact3 triangulated(const FeatureImage& image, const ImageLines& lines,
                    const ExactCameras& cameras) {
    const InView of_ray = ray_of(image, lines);
    const InView of_plane = plane_of(image, lines, of_ray.view);
    const Exact3& from = cameras[of_ray.view].centre;
    const Exact3 ray = cameras[of_ray.view].back(of_ray.vector);
    const Exact3 normal = cameras[of_plane.view].back(of_plane.vector);
    const Gaussian depth =
        dot(normal, difference(cameras[of_plane.view].centre, from)) / dot(normal, ray);
    Exact3 point;
    for (std::size_t k = 0; k < 3; ++k)
        point[k] = from[k] + depth * ray[k];
    return point;
}

/// The images of one line of the feature, in the views that see it.
std::vector<InView> images_of_line(const FeatureImage& image, const ImageLines& lines, int line) {
    std::vector<InView> result;
    for (int view = 0; view < 3; ++view) {
        if (!image.feature.sees_line(view, line)) continue;
        const auto v = static_cast<std::size_t>(view);
        std::size_t before = 0;
        for (int other = 0; other < line; ++other)
            before += image.feature.sees_line(view, other);
        result.push_back({v, lines[v][before]});
    }
    return result;
}

/// Makes the scene of one feature from two views and sees it in all of them: how far the images are
/// from the given ones, relative to their size.
double reprojection_error(const FeatureImage& image, const ExactCameras& cameras) {
    const ImageLines lines = image_lines(image);
    const Exact3 point = triangulated(image, lines, cameras);
    const auto seen_from = [&](std::size_t v) {
        return cameras[v].turn(difference(point, cameras[v].centre));
    };
    double worst = 0;
    const auto vanish = [&](double value, double scale) { worst = std::max(worst, value / scale); };
    for (std::size_t v = 0; v < 3; ++v) {
        if (!image.views[v].point) continue;
        const Exact3 given = exactly(*image.views[v].point), x = seen_from(v);
        vanish(size(exact_cross(x, given)), size(x) * size(given));
    }
    for (int line = 0; line < image.feature.lines; ++line) {
        const std::vector<InView> seen = images_of_line(image, lines, line);
        const Exact3 direction = exact_cross(cameras[seen[0].view].back(seen[0].vector),
                                             cameras[seen[1].view].back(seen[1].vector));
        for (const auto& [v, given] : seen) {
            const Exact3 x = seen_from(v), d = cameras[v].turn(direction);
            vanish(size(dot(given, x)), size(given) * size(x));
            vanish(size(dot(given, d)), size(given) * size(d));
        }
    }
    return worst;
}

/// The images of the certificate, in the order of the free vectors of the system.
Images images_of(const DegreeCertificate& certificate) {
    Images images;
    const auto add = [&](const IntegerVector& x) {
        images.push_back(
            {static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2])});
    };
    for (const FeatureImage& image : certificate.images)
        for (const ViewImage& view : image.views) {
            if (view.point) add(*view.point);
            for (const auto& line : view.lines)
                add(line);
        }
    return images;
}

CameraPoint starting_value(const StartingValues& solution) {
    const auto value = [&](std::size_t i) {
        return std::ldexp(static_cast<double>(solution.values[i]), -solution.bits);
    };
    CameraPoint start;
    for (std::size_t k = 0; k < start.size(); ++k) {
        const std::size_t at = solution.real ? k : 2 * k;
        start[k] = {value(at), solution.real ? 0 : value(at + 1)};
    }
    return start;
}

/// The solutions that the certificate approximates, as close as doubles can be.
std::vector<CameraPoint> polished(const CameraSystem& system,
                                  const DegreeCertificate& certificate) {
    std::vector<CameraPoint> starts;
    for (const StartingValues& solution : certificate.solutions)
        starts.push_back(starting_value(solution));
    TrackSettings settings;
    settings.first_step = settings.largest_step = 1;
    const Images images = images_of(certificate);
    std::vector<CameraPoint> ends(starts.size());
    std::vector<TrackOutcome> outcomes(starts.size());
    fastest_double_double_tracker()(
        tracked_system(system, standard_chart()),
        moving_images(system, standard_constants(system), images, images), settings, starts.size(),
        starts.data(), ends.data(), outcomes.data());
    for (const TrackOutcome outcome : outcomes)
        REQUIRE(outcome == TrackOutcome::arrived);
    return ends;
}

ExactCameras exact_cameras(const CameraPoint& point) {
    const QuaternionCameras cameras = standard_chart().cameras(point);
    return {ExactCamera({1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}),
            ExactCamera(cameras.quaternion[0], cameras.centre[0]),
            ExactCamera(cameras.quaternion[1], cameras.centre[1])};
}

} // namespace

TEST_CASE("certified cameras see the scene that they come from, in exact arithmetic") {
    for (const char* notation :
         {"2*P/P/P + a/P/Pa + 2*-/P/P + P/-/P", "3*P/P/P + a/a/a", "Pab/Pab/Pab + 2*Pa/a/Pa"}) {
        CAPTURE(notation);
        const std::size_t number = number_of(notation);
        const DegreeRun result = compute_degree(number, {.at_least = 40});
        REQUIRE(result.certificate);
        REQUIRE(result.certificate->degree() >= 40);
        const CameraSystem system = camera_system(label_classes()[number]);
        const std::vector<CameraPoint> solutions = polished(system, *result.certificate);
        for (std::size_t i = 0; i < solutions.size(); i += 5) {
            const ExactCameras cameras = exact_cameras(solutions[i]);
            for (const FeatureImage& image : result.certificate->images)
                CHECK(reprojection_error(image, cameras) < 1e-8);
        }
    }
}
