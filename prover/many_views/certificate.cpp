#include "prover/many_views/certificate.h"

#include "prover/many_views/integer_pictures.h"
#include "prover/many_views/path.h"
#include "prover/many_views/standard_chart.h"
#include "prover/monodromy/arrivals.h"
#include "prover/problem/notation.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace plprove::many_views {

namespace {

using Eigen::Index;

/// The equations at the integer images, in the standard chart. Their vectors are divided by the
/// scale.
class IntegerSystem {
public:
    IntegerSystem(const Problem& problem, const IntegerImages& integers, double scale)
        : system_(problem, CameraChart::standard(*problem.cameras, problem.views)), scale_(scale),
          images_(scaled(problem, integers, scale)), still_(on_the_way(images_, images_, 0)) {}

    const Images<Complex>& images() const { return images_; }

    /// See refined().
    std::optional<Point> solve(const Point& point) {
        return refined(system_, still_, point, evaluation_);
    }

    /// Whether a solution is real. Rounding leaves an imaginary part to some that are nearly
    /// double; but Newton's method stays real, and leads back to the solution from its real part.
    bool is_real(const Point& solution) {
        constexpr double near = 1e-6;
        if (many_views::is_real(solution)) return true;
        const auto end = solve(solution.real().cast<Complex>());
        return end && has_near_coordinates(*end, solution, near);
    }

    /// The coordinates in the order of the file, with depths for the integers themselves; and back.
    Point written(const Point& point) const {
        Point result(point.size());
        const Index cameras = point.size() - system_.depths();
        result << point.tail(cameras), point.head(system_.depths()) * scale_;
        return result;
    }
    Point read(const Point& written) const {
        Point result(written.size());
        const Index cameras = written.size() - system_.depths();
        result << written.tail(system_.depths()) / scale_, written.head(cameras);
        return result;
    }

private:
    System system_;
    double scale_;
    Images<Complex> images_;
    Images<Moving> still_;
    Evaluation evaluation_;
};

Eigen::Vector3cd vector(const Vector<Complex>& x) {
    return {x[0], x[1], x[2]};
}

/// The point of the standard chart with this second camera. The depth d of a point is such that
/// the camera sees it where the second view does: M x + d t = s y.
Point second_camera_with_depths(const CameraModel& model, const Images<Complex>& images,
                                const std::vector<Complex>& numbers) {
    const auto chart = CameraChart::standard(model, 2);
    const Eigen::Map<const Eigen::VectorXcd> all(numbers.data(), std::ssize(numbers));
    const Point coordinates = all(model.coordinates(true)); // nothing is shared
    const Camera matrix = chart.camera(1, coordinates).camera;
    const std::size_t count = images[0].points.size();
    Point point(static_cast<Index>(count) + coordinates.size());
    for (std::size_t p = 0; p < count; ++p) {
        Eigen::Matrix<Complex, 3, 2> factors; // of d and s
        factors << matrix.col(3), -vector(images[1].points[p]);
        const Eigen::Vector3cd turned = matrix.leftCols<3>() * vector(images[0].points[p]);
        const Eigen::Vector2cd depths = factors.colPivHouseholderQr().solve(-turned);
        point[static_cast<Index>(p)] = depths[0];
    }
    point.tail(coordinates.size()) = coordinates;
    return point;
}

/// Adds the solution that the point, in the standard chart, approximates, if it is new.
void add(Arrivals<Point>& arrivals, IntegerSystem& system, const Point& approximation) {
    const auto point = system.solve(approximation);
    if (point && !arrivals.has(*point)) arrivals.add(*point, system.is_real(*point));
}

/// For each solution how many bits after the binary point are surely enough; 0: no number is.
std::vector<int> bits_of(const std::vector<Point>& points, IntegerSystem& system) {
    constexpr std::array tried{3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 19, 22, 26, 30, 35, 40, 44};
    constexpr double near = 1e-6;
    std::vector<Point> written;
    for (const Point& point : points)
        written.push_back(system.written(point));
    const auto find_again = [&](int, const auto& starts, const auto& indices) {
        std::vector<bool> again;
        for (std::size_t k = 0; k < starts.size(); ++k) {
            const auto end = system.solve(system.read(starts[k]));
            again.push_back(end && has_near_coordinates(*end, points[indices[k]], near));
        }
        return again;
    };
    std::vector<int> result;
    for (const EnoughBits& enough : enough_bits(written, tried, find_again))
        result.push_back(enough.sure);
    return result;
}

Arrivals<Point> no_arrivals() {
    return Arrivals(SolutionSet<Point>(1e-7, Nearness::of_coordinates));
}

std::vector<StartingValues> written(Arrivals<Point>& arrivals, IntegerSystem& system) {
    return arrivals.written([&](const Point& point) { return system.written(point); },
                            [&](const auto& points) { return bits_of(points, system); });
}

} // namespace

SolutionsRecord certify(const MonodromyResult& found, int wanted, std::uint64_t seed, int threads,
                        int largest) {
    constexpr std::uint64_t stream = 2; // another one than that of monodromy
    constexpr double usual_scale = 64;  // of random integer images
    const double scale = usual_scale * largest / usual_coordinate;
    const Problem& problem = found.system.problem();
    Random random(seed, stream);
    const IntegerImages integers = random_integer_images(problem, problem.views, random, largest);
    IntegerSystem system(problem, integers, scale);
    Arrivals<Point> arrivals = no_arrivals();
    int in_vain = 0;
    for (int way = 0; in_vain < 2 && arrivals.size() < wanted; ++way) {
        const int before = arrivals.size();
        const Images<Complex> to = rephased(problem, system.images(), random);
        const Care care = way == 0 ? Care::usual : Care::careful;
        for (const auto& end :
             follow_all(found.system, found.images, to, found.points, care, threads))
            if (end && found.system.has_cameras(*end))
                add(arrivals, system, in_standard_chart(found.system, *end));
        in_vain = arrivals.size() > before ? 0 : in_vain + 1;
    }
    return {problem, integers, written(arrivals, system)};
}

SolutionsRecord certify(const Problem& points, const IntegerImages& integers, int digits,
                        std::span<const std::vector<Complex>> second_cameras) {
    IntegerSystem system(points, integers, std::pow(10.0, digits));
    Arrivals<Point> arrivals = no_arrivals();
    for (const std::vector<Complex>& numbers : second_cameras)
        add(arrivals, system, second_camera_with_depths(*points.cameras, system.images(), numbers));
    return {points, integers, written(arrivals, system)};
}

void append_images(CertificateText& text, const Problem& problem, const IntegerImages& views) {
    constexpr std::size_t digits = 9;
    text.line("problem", notation(problem));
    for (const std::vector<int>& view : views)
        text.line("view", coordinates(view, digits));
}

std::string write_solutions(std::span<const SolutionsRecord> records) {
    constexpr std::size_t digits_of_solutions = 18;
    CertificateText text;
    for (const SolutionsRecord& record : records) {
        append_images(text, record.problem, record.views);
        for (const StartingValues& solution : record.solutions) {
            std::vector<std::string> words;
            for (const std::int64_t value : solution.values)
                words.push_back(with_digits(value, digits_of_solutions, "a solution"));
            text.line(solution.real ? "real" : "pair", solution.bits, words);
        }
    }
    return certificate_file("solutions", text.take(), "ask for fewer solutions with --target");
}

} // namespace plprove::many_views
