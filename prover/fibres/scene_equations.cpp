#include "prover/fibres/scene_equations.h"

#include "prover/minimal/placement.h"

#include <map>

namespace plprove {

namespace {

using many_views::Images;
using Depth = decltype(ScenePlace::depth);

NumberPolynomial constant(std::int64_t value) {
    if (value == 0) return {};
    return NumberPolynomial::constant(static_cast<int>(value));
}

CameraMatrix<NumberPolynomial> derivative(const CameraMatrix<NumberPolynomial>& matrix,
                                          std::size_t unknown) {
    CameraMatrix<NumberPolynomial> result;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            result[i][j] = matrix[i][j].derivative(static_cast<int>(unknown));
    return result;
}

/// The normalised camera whose own coordinates are the unknowns from `first` on.
SceneCamera scene_camera(const CameraModel& model, bool second, std::size_t first) {
    std::vector<NumberPolynomial> numbers(static_cast<std::size_t>(model.numbers));
    std::vector<std::size_t> unknowns;
    if (second) std::ranges::transform(model.start_of_second, numbers.begin(), constant);
    for (const ScaledRun& run : model.scaled_runs(second))
        numbers[static_cast<std::size_t>(run.first)] = constant(1);
    const auto add_unknown = [&](NumberPolynomial& number, std::size_t unknown) {
        number = NumberPolynomial::number(static_cast<int>(unknown));
        unknowns.push_back(unknown);
    };
    for (const int k : model.coordinates(second))
        add_unknown(numbers[static_cast<std::size_t>(k)], first++);
    for (int k = 0; k < model.shared; ++k)
        add_unknown(numbers.emplace_back(), static_cast<std::size_t>(k));
    SceneCamera camera{model.polynomials(numbers.data()), {}};
    for (const std::size_t unknown : unknowns)
        camera.derivatives.emplace_back(unknown, derivative(camera.matrix, unknown));
    return camera;
}

/// a times the first depth plus b times the second.
Depth combined(std::int64_t a, const Depth& first, std::int64_t b, const Depth& second) {
    std::map<std::size_t, std::int64_t> sum;
    for (const auto& [unknown, factor] : first)
        sum[unknown] += a * factor;
    for (const auto& [unknown, factor] : second)
        sum[unknown] += b * factor;
    return {sum.begin(), sum.end()};
}

/// Adds places, and then the equations of one view after the other.
class Incidences {
public:
    /// The scene has its cameras already.
    Incidences(const Problem& problem, const Images<std::int64_t>& images, SceneEquations& scene)
        : problem_(problem), images_(images), scene_(scene), next_(scene.camera_coordinates) {}

    void add_places() {
        const auto places = many_views::image_vectors(problem_, images_[0]);
        for (std::size_t p = 0; p < places.size(); ++p)
            scene_.points.push_back({places[p], depth_of(p)});
        for (std::size_t line = 0; line < problem_.lines.size(); ++line)
            add_places_of(line);
        scene_.unknowns = next_;
    }

    void add_equations(std::size_t view) {
        const auto seen = many_views::image_vectors(problem_, images_[view]);
        for (std::size_t p = 0; p < seen.size(); ++p)
            add_point(view, p, seen[p]);
        for (std::size_t line = 0; line < problem_.lines.size(); ++line)
            add_line(view, line, seen);
    }

private:
    static std::size_t index(int n) { return static_cast<std::size_t>(n); }

    std::optional<int> carrier_of(std::size_t p) const {
        return carrier(problem_, static_cast<int>(p));
    }

    Depth depth_of(std::size_t p) {
        const auto carrier = carrier_of(p);
        if (!carrier) return {{next_++, 1}};
        const std::vector<int>& on_it = problem_.lines[index(*carrier)].points;
        const IntegerVector& factors = images_[0].points[p];
        return combined(factors[0], scene_.points[index(on_it[0])].depth, factors[1],
                        scene_.points[index(on_it[1])].depth);
    }

    void add_places_of(std::size_t line) {
        const std::vector<int>& points = problem_.lines[line].points;
        auto& ends = scene_.lines.emplace_back();
        for (std::size_t end = 0; end < 2; ++end)
            if (end < points.size())
                ends[end] = scene_.points[index(points[end])];
            else
                ends[end] = {images_[0].lines[line][end], {{next_++, 1}}};
    }

    void add_point(std::size_t view, std::size_t p, const IntegerVector& y) {
        const ScenePlace& place = scene_.points[p];
        scene_.equations.push_back({view, {0, y[2], -y[1]}, place});
        if (!carrier_of(p)) scene_.equations.push_back({view, {-y[2], 0, y[0]}, place});
    }

    /// An equation for each place of the line that has a depth of its own.
    void add_line(std::size_t view, std::size_t line, const std::vector<IntegerVector>& seen) {
        const std::vector<int>& points = problem_.lines[line].points;
        if (points.size() >= 2) return;
        auto ends = images_[view].lines[line];
        if (!points.empty()) ends[0] = seen[index(points[0])];
        const IntegerVector l = cross(ends[0], ends[1]);
        for (std::size_t end = points.size(); end < 2; ++end)
            scene_.equations.push_back({view, l, scene_.lines[line][end]});
    }

    const Problem& problem_;
    const Images<std::int64_t>& images_;
    SceneEquations& scene_;
    std::size_t next_; ///< the next unknown depth
};

} // namespace

SceneEquations scene_equations(const Problem& problem, const many_views::IntegerImages& integers) {
    const CameraModel& model = *problem.cameras;
    SceneEquations result;
    auto first = static_cast<std::size_t>(model.shared);
    for (int view = 1; view < problem.views; ++view) {
        const bool second = view == 1;
        result.cameras.push_back(scene_camera(model, second, first));
        first += static_cast<std::size_t>(second ? model.unknowns_of_second : model.unknowns);
    }
    result.camera_coordinates = first;
    const auto images = many_views::exact_images(problem, integers);
    Incidences incidences(problem, images, result);
    incidences.add_places();
    for (std::size_t view = 1; view < images.size(); ++view)
        incidences.add_equations(view);
    return result;
}

} // namespace plprove
