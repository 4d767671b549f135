// The Python module pointline._pointline: the library in numpy arrays. pointline/__init__.py makes
// it what users see.
#include "convert.h"

#include <pointline/model.h>
#include <pointline/problem.h>
#include <pointline/solver.h>

#include <complex>
#include <pybind11/complex.h>
#include <span>

namespace {

/// A solver and what its arrays look like.
struct Solver {
    pointline::Problem problem;
    pointline::Solver solver;

    py::ssize_t features() const { return static_cast<py::ssize_t>(problem.lines.size()); }
    py::ssize_t lines() const {
        std::size_t count = 0;
        for (const std::string& letters : problem.lines)
            count += letters.size();
        return static_cast<py::ssize_t>(count);
    }
};

void require_shape(const Array& array, const std::vector<py::ssize_t>& shape, const char* name) {
    std::vector<py::ssize_t> found(array.shape(), array.shape() + array.ndim());
    if (found == shape) return;
    const auto text = [](const std::vector<py::ssize_t>& sizes) {
        std::string result;
        for (const py::ssize_t size : sizes)
            result += (result.empty() ? "" : ", ") + std::to_string(size);
        return "(" + result + ")";
    };
    throw py::value_error(std::string(name) + " has the shape " + text(found) +
                          ": give the shape " + text(shape));
}

/// The line of a view: by coefficients, or by two points.
pointline::Line line_of(const Array& lines, py::ssize_t line, py::ssize_t view) {
    if (lines.ndim() == 3) {
        const auto entry = lines.unchecked<3>();
        return {{entry(line, view, 0), entry(line, view, 1), entry(line, view, 2)}, {}};
    }
    const auto entry = lines.unchecked<4>();
    return pointline::line_through({entry(line, view, 0, 0), entry(line, view, 0, 1)},
                                   {entry(line, view, 1, 0), entry(line, view, 1, 1)});
}

pointline::Images images_of(const Solver& solver, const Array& points, const Array& lines,
                            const Array& K) {
    const py::ssize_t views = solver.problem.views;
    require_shape(points, {solver.features(), views, 2}, "points");
    if (lines.ndim() == 4)
        require_shape(lines, {solver.lines(), views, 2, 2}, "lines");
    else
        require_shape(lines, {solver.lines(), views, 3}, "lines");
    pointline::Images images;
    if (K.size() > 0) {
        require_shape(K, {views, 4}, "K");
        const auto k = K.unchecked<2>();
        for (py::ssize_t v = 0; v < views; ++v)
            images.cameras.push_back({k(v, 0), k(v, 1), k(v, 2), k(v, 3)});
    }
    const auto point = points.unchecked<3>();
    py::ssize_t line = 0;
    for (py::ssize_t f = 0; f < solver.features(); ++f) {
        const std::string& letters = solver.problem.lines[static_cast<std::size_t>(f)];
        auto& sightings = images.features.emplace_back(static_cast<std::size_t>(views));
        for (py::ssize_t v = 0; v < views; ++v) {
            pointline::Sighting& sighting = sightings[static_cast<std::size_t>(v)];
            if (point(f, v, 0) == point(f, v, 0)) // else not a number: not seen
                sighting.point = {point(f, v, 0), point(f, v, 1)};
            for (std::size_t i = 0; i < letters.size(); ++i) {
                const auto found = line_of(lines, line + static_cast<py::ssize_t>(i), v);
                if (found.coefficients[0] == found.coefficients[0])
                    sighting.lines[letters[i]] = found;
            }
        }
        line += static_cast<py::ssize_t>(letters.size());
    }
    return images;
}

/// The real solutions as arrays: R, t, points, directions, in front, residuals, conditions.
py::dict arrays_of(const Solver& solver, const pointline::Answer& answer) {
    const auto count = static_cast<py::ssize_t>(answer.solutions.size());
    const py::ssize_t views = solver.problem.views;
    Array R({count, views, py::ssize_t{3}, py::ssize_t{3}}), t({count, views, py::ssize_t{3}});
    Array points({count, solver.features(), py::ssize_t{3}});
    Array line_points({count, solver.lines(), py::ssize_t{3}});
    Array directions({count, solver.lines(), py::ssize_t{3}});
    Array residuals(count), conditions(count);
    py::array_t<int> in_front(count);
    Writer writer{R.mutable_data(), t.mutable_data(), points.mutable_data(),
                  line_points.mutable_data(), directions.mutable_data()};
    py::ssize_t index = 0;
    for (const pointline::Solution& solution : answer.solutions) {
        writer.write(solution.cameras);
        for (const auto& point : solution.points)
            writer.write(point);
        for (const auto& lines : solution.lines)
            for (const auto& [letter, line] : lines)
                writer.write(line);
        in_front.mutable_at(index) = solution.in_front;
        residuals.mutable_at(index) = solution.residual;
        conditions.mutable_at(index++) = solution.condition;
    }
    py::dict result;
    result["R"] = R;
    result["t"] = t;
    result["points"] = points;
    result["line_points"] = line_points;
    result["line_directions"] = directions;
    result["in_front"] = in_front;
    result["residuals"] = residuals;
    result["conditions"] = conditions;
    result["degree"] = answer.degree;
    result["found"] = answer.found;
    const std::array<const char*, 3> words{"certified", "unknown", "evidence"};
    result["complete"] = words[static_cast<std::size_t>(answer.complete)];
    result["moved"] = answer.moved;
    return result;
}

Solver make(const std::string& problem, const std::optional<std::string>& start) {
    const py::gil_scoped_release release;
    const auto text = std::string_view(problem);
    auto described = pointline::problem(text);
    auto solver = start ? pointline::Solver::load(text, *start) : pointline::Solver::make(text);
    const py::gil_scoped_acquire acquire;
    return {value(std::move(described)), value(std::move(solver))};
}

/// What a function of a model finds, while other threads of Python run.
template <class T>
T found_without_lock(const pointline::Model& model,
                     pointline::Result<T> (pointline::Model::*find)() const noexcept) {
    auto found = [&] {
        const py::gil_scoped_release release;
        return (model.*find)();
    }();
    return value(std::move(found));
}

/// The names and shapes of arrays.
std::vector<std::pair<std::string, std::vector<int>>>
shapes_of(const std::vector<pointline::NamedArray>& arrays) {
    std::vector<std::pair<std::string, std::vector<int>>> shapes;
    for (const pointline::NamedArray& array : arrays)
        shapes.emplace_back(array.name, array.shape);
    return shapes;
}

pointline::ModelSolver solver_of(const pointline::Model& model) {
    auto made = [&] {
        const py::gil_scoped_release release;
        return pointline::ModelSolver::make(model);
    }();
    return value(std::move(made));
}

/// The unknowns, a row for each solution; which are real; residuals; how many are lost.
py::tuple solve_model(const pointline::ModelSolver& solver, const Array& data) {
    auto solved = [&] {
        const std::span<const double> numbers(data.data(), static_cast<std::size_t>(data.size()));
        const py::gil_scoped_release release;
        return solver.solve(numbers);
    }();
    const pointline::ModelAnswer answer = value(std::move(solved));
    const auto count = static_cast<py::ssize_t>(answer.solutions.size());
    const auto size = count == 0
                          ? py::ssize_t{0}
                          : static_cast<py::ssize_t>(answer.solutions.front().unknowns.size());
    py::array_t<std::complex<double>> unknowns({count, size});
    py::array_t<bool> real(count);
    Array residuals(count);
    for (py::ssize_t i = 0; i < count; ++i) {
        const pointline::ModelSolution& solution = answer.solutions[static_cast<std::size_t>(i)];
        std::ranges::copy(solution.unknowns, unknowns.mutable_data(i, 0));
        real.mutable_at(i) = solution.real;
        residuals.mutable_at(i) = solution.residual;
    }
    return py::make_tuple(unknowns, real, residuals, answer.lost);
}

py::dict solve(const Solver& solver, const Array& points, const Array& lines, const Array& K,
               bool quick, bool conditions, unsigned threads) {
    const pointline::Images images = images_of(solver, points, lines, K);
    auto answer = [&] {
        const py::gil_scoped_release release;
        return solver.solver.solve(images, {quick, conditions, threads});
    }();
    return arrays_of(solver, value(std::move(answer)));
}

} // namespace

PYBIND11_MODULE(_pointline, module) {
    py::class_<pointline::Problem>(module, "Problem")
        .def_readonly("notation", &pointline::Problem::notation)
        .def_readonly("views", &pointline::Problem::views)
        .def_readonly("calibrated", &pointline::Problem::calibrated)
        .def_readonly("verdict", &pointline::Problem::verdict)
        .def_readonly("reasons", &pointline::Problem::reasons)
        .def_readonly("degree", &pointline::Problem::degree)
        .def_readonly("picture", &pointline::Problem::picture)
        .def_readonly("points", &pointline::Problem::points)
        .def_readonly("lines", &pointline::Problem::lines);
    py::class_<Solver>(module, "Solver")
        .def_property_readonly("degree", [](const Solver& s) { return s.solver.degree(); })
        .def("solve", solve);
    py::class_<pointline::Model>(module, "Model")
        .def(py::init([](const std::string& text) { return value(pointline::Model::read(text)); }))
        .def_property_readonly("name", &pointline::Model::name)
        .def_property_readonly("claimed", &pointline::Model::claimed)
        .def_property_readonly("data", &pointline::Model::data)
        .def_property_readonly("unknowns", &pointline::Model::unknowns)
        .def_property_readonly("equations", &pointline::Model::equations)
        .def("solutions",
             [](const pointline::Model& model) {
                 const auto found = found_without_lock(model, &pointline::Model::solutions);
                 return std::pair(found.at_least, found.at_most);
             })
        .def("certificate",
             [](const pointline::Model& model) {
                 return found_without_lock(model, &pointline::Model::certificate);
             })
        .def("template",
             [](const pointline::Model& model) {
                 return found_without_lock(model, &pointline::Model::python_solver);
             })
        .def("solver", solver_of);
    py::class_<pointline::ModelSolver>(module, "ModelSolver")
        .def_property_readonly(
            "data", [](const pointline::ModelSolver& solver) { return shapes_of(solver.data()); })
        .def_property_readonly(
            "unknowns",
            [](const pointline::ModelSolver& solver) { return shapes_of(solver.unknowns()); })
        .def_property_readonly("found", &pointline::ModelSolver::found)
        .def("solve", solve_model);
    module.def("problem", [](const std::string& text) { return value(pointline::problem(text)); });
    module.def("make", make);
    add_estimator(module);
}
