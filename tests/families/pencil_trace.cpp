#include "tests/families/pencil_trace.h"

#include "prover/many_views/distinct.h"
#include "prover/many_views/path.h"
#include "prover/monodromy/path_ends.h"

#include <algorithm>
#include <optional>

namespace plprove::many_views {

namespace {

using Vector3 = Eigen::Vector3cd;

Vector3 vector(const Vector<Complex>& x) {
    return {x[0], x[1], x[2]};
}

Vector<Complex> entry(const Vector3& x) {
    return {x[0], x[1], x[2]};
}

/// Bilinear, as the next one: no conjugates.
Complex product(const Vector3& x, const Vector3& y) {
    return x.transpose() * y;
}

Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector3 random_vector(Random& random) {
    return vector(random.complex3());
}

} // namespace

ImagesInPencil::ImagesInPencil(const System& system, const Images<Complex>& images, Random& random)
    : system_(system), images_(images), depth_(1) {
    const auto& lines = system.problem().lines;
    while (lines[line_].points.empty()) {
        ++line_;
        depth_ += 2; // those of a free line
    }
    const ViewImages<Complex>& view = images.back();
    std::vector<Vector3> free;
    for (std::size_t line = 0; line < lines.size(); ++line)
        if (line != line_)
            free.push_back(cross(vector(view.lines[line][0]), vector(view.lines[line][1])));
    const Vector3 x = vector(view.points[0]);
    l0_ = cross(x, vector(view.lines[line_][1]));
    l1_ = random_vector(random);
    k_ = product(free[1], x) * free[0] - product(free[0], x) * free[1];
    other_ = random_vector(random);
    w_ = random_vector(random);
}

Images<Complex> ImagesInPencil::at(const Complex& time) const {
    Images<Complex> images = images_;
    images.back().points[0] = entry(cross(line_at(time), k_));
    images.back().lines[line_][1] = entry(cross(line_at(time), other_));
    return images;
}

Vector3 ImagesInPencil::direction(const Point& solution) const {
    const auto view = static_cast<std::size_t>(system_.problem().views) - 1;
    const CameraChart& chart = system_.chart();
    const Camera camera = chart.camera(view, solution.tail(chart.dimension())).camera;
    const Vector3 point = vector(images_[0].points[0]);
    const Vector3 second = vector(images_[0].lines[line_][1]);
    return camera.leftCols<3>() * (solution[0] * second - solution[depth_] * point);
}

Complex ImagesInPencil::coordinate(const Point& solution) const {
    const Vector3 z = direction(solution);
    return product(w_, z) / product(l1_, z);
}

namespace {

using Ends = PathEnds<Point>;

/// Follows solutions to a time, by the way of another one. Where this fails for some, they keep
/// their ends.
class Followed {
public:
    Followed(const System& system, const ImagesInPencil& pencil, const std::vector<Point>& starts,
             int threads)
        : system_(system), pencil_(pencil), starts_(starts), threads_(threads) {}

    /// The ends: none of a path that gets lost however carefully it is followed.
    Ends to(const Complex& time) const {
        Ends ends(starts_.size());
        follow_again(ends, time, time, Care::usual);
        for (const Complex& between : {time, Complex(1.1, -0.9), Complex(1.4, -0.2)})
            follow_again(ends, between, time, Care::careful);
        return ends;
    }

private:
    /// Follows those that have no end.
    void follow_again(Ends& ends, const Complex& between, const Complex& time, Care care) const {
        const auto leg = [&](const Complex& from, const Complex& to, const auto& starts) {
            return follow_all(system_, pencil_.at(from), pencil_.at(to), starts, care, threads_);
        };
        fill(ends, starts_, [&](const auto& open) {
            Ends found = leg(Complex(0), between, open);
            if (between != time)
                found =
                    follow_on(found, [&](const auto& from) { return leg(between, time, from); });
            for (std::optional<Point>& end : found)
                if (end && !system_.has_cameras(*end)) end.reset();
            return found;
        });
    }

    const System& system_;
    const ImagesInPencil& pencil_;
    const std::vector<Point>& starts_;
    int threads_;
};

/// How many different points there are.
int count_distinct(const System& system, const Images<Complex>& images, const Ends& ends) {
    std::vector<Point> points;
    for (const std::optional<Point>& end : ends)
        if (end) points.push_back(*end);
    return static_cast<int>(distinct_solutions(system, images, points).size());
}

} // namespace

PencilTrace trace_in_pencil(const System& system, const Images<Complex>& images,
                            const std::vector<Point>& solutions, std::uint64_t seed, int threads) {
    constexpr std::uint64_t stream = 3; // another one than those of monodromy and certificates
    const Complex first(0.7, 0.4), second(-0.5, 0.6);
    Random random(seed, stream);
    const ImagesInPencil pencil(system, images, random);
    const Followed followed(system, pencil, solutions, threads);
    const Ends to_first = followed.to(first), to_second = followed.to(second);
    PencilTrace trace;
    trace.solutions = std::min(count_distinct(system, pencil.at(first), to_first),
                               count_distinct(system, pencil.at(second), to_second));
    trace.lost = static_cast<int>(solutions.size()) - trace.solutions;
    Complex difference = 0;
    std::vector<double> parts;
    for (std::size_t i = 0; i < solutions.size(); ++i) {
        if (!to_first[i] || !to_second[i]) continue;
        const Complex start = pencil.coordinate(solutions[i]);
        const Complex slope = (pencil.coordinate(*to_first[i]) - start) / first;
        const Complex other = (pencil.coordinate(*to_second[i]) - start) / second;
        trace.slope += slope;
        difference += slope - other;
        parts.push_back(std::abs(slope - other));
    }
    trace.difference = std::abs(difference);
    std::ranges::sort(parts);
    if (!parts.empty()) trace.if_one_missing = parts[parts.size() / 2];
    return trace;
}

} // namespace plprove::many_views
