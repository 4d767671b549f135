// Estimators in numpy arrays. pointline/__init__.py checks what is given, and names what is found.
#include "convert.h"

#include <pointline/estimator.h>

namespace {

/// Integer indices: pairs of a point and a line.
using Pairs = py::array_t<long long, py::array::c_style | py::array::forcecast>;

/// nan where a view does not see it. Shapes: (points, views, 2), (lines, views, 2, 2), (n, 2),
/// (views, 4), (views, 5).
pointline::Matches matches_of(const Array& points, const Array& lines, const Pairs& incidences,
                              const Array& K, const Array& distortions) {
    pointline::Matches matches;
    const auto k = K.unchecked<2>(), d = distortions.unchecked<2>();
    const py::ssize_t views = k.shape(0);
    for (py::ssize_t v = 0; v < views; ++v) {
        matches.cameras.push_back({k(v, 0), k(v, 1), k(v, 2), k(v, 3)});
        matches.distortions.push_back({d(v, 0), d(v, 1), d(v, 2), d(v, 3), d(v, 4)});
    }
    const auto is_number = [](double x) { return x == x; };
    const auto point = points.unchecked<3>();
    for (py::ssize_t p = 0; p < point.shape(0); ++p) {
        auto& seen = matches.points.emplace_back(static_cast<std::size_t>(views));
        for (py::ssize_t v = 0; v < views; ++v)
            if (is_number(point(p, v, 0)))
                seen[static_cast<std::size_t>(v)] = {point(p, v, 0), point(p, v, 1)};
    }
    const auto line = lines.unchecked<4>();
    for (py::ssize_t l = 0; l < line.shape(0); ++l) {
        auto& seen = matches.lines.emplace_back(static_cast<std::size_t>(views));
        for (py::ssize_t v = 0; v < views; ++v)
            if (is_number(line(l, v, 0, 0)))
                seen[static_cast<std::size_t>(v)] = {{line(l, v, 0, 0), line(l, v, 0, 1)},
                                                     {line(l, v, 1, 0), line(l, v, 1, 1)}};
    }
    const auto pair = incidences.unchecked<2>();
    for (py::ssize_t i = 0; i < pair.shape(0); ++i)
        matches.incidences.push_back(
            {static_cast<std::size_t>(pair(i, 0)), static_cast<std::size_t>(pair(i, 1))});
    return matches;
}

py::dict arrays_of(const pointline::Estimate& estimate) {
    const auto count = [](const auto& entries) { return static_cast<py::ssize_t>(entries.size()); };
    const py::ssize_t views = count(estimate.cameras);
    Array R({views, py::ssize_t{3}, py::ssize_t{3}}), t({views, py::ssize_t{3}});
    Array points({count(estimate.points), py::ssize_t{3}});
    Array line_points({count(estimate.lines), py::ssize_t{3}});
    Array directions({count(estimate.lines), py::ssize_t{3}});
    Writer writer{R.mutable_data(), t.mutable_data(), points.mutable_data(),
                  line_points.mutable_data(), directions.mutable_data()};
    writer.write(estimate.cameras);
    for (const auto& point : estimate.points)
        writer.write(point);
    for (const auto& line : estimate.lines)
        writer.write(line);
    py::dict result;
    result["R"] = R;
    result["t"] = t;
    result["points"] = points;
    result["line_points"] = line_points;
    result["line_directions"] = directions;
    result["problem"] = estimate.problem;
    result["samples"] = estimate.samples;
    result["rms"] = estimate.rms;
    result["covariance"] = estimate.covariance;
    return result;
}

/// Keeps the solvers that were made.
struct Estimator {
    pointline::Estimator estimator;

    py::dict estimate(const Array& points, const Array& lines, const Pairs& incidences,
                      const Array& K, const Array& distortions, const std::string& problem,
                      double threshold, double confidence, int least_samples, int most_samples,
                      std::uint64_t seed, unsigned threads, bool covariance) const {
        const pointline::Matches matches = matches_of(points, lines, incidences, K, distortions);
        auto found = [&] {
            const py::gil_scoped_release release;
            return estimator.estimate(matches, {problem, threshold, confidence, least_samples,
                                                most_samples, seed, threads, covariance});
        }();
        return arrays_of(value(std::move(found)));
    }
};

/// Notation, degree, milliseconds, expected milliseconds of each.
std::vector<std::tuple<std::string, int, double, double>>
offers(const Array& points, const Array& lines, const Pairs& incidences, const Array& K,
       const Array& distortions) {
    std::vector<std::tuple<std::string, int, double, double>> result;
    for (const pointline::Offer& offer :
         value(pointline::Estimator::offers(matches_of(points, lines, incidences, K, distortions))))
        result.emplace_back(offer.problem, offer.degree, offer.milliseconds, offer.expected);
    return result;
}

} // namespace

void add_estimator(py::module_& module) {
    py::class_<Estimator>(module, "Estimator")
        .def(py::init<>())
        .def("estimate", &Estimator::estimate);
    module.def("offers", offers);
}
