#include "prover/many_views/system.h"

#include <Eigen/LU>

namespace plprove::many_views {

namespace {

using Eigen::Index;

/// The images whose numbers a function makes of those of two images.
template <class Scalar, class Function>
Images<Scalar> combined(const Images<Complex>& from, const Images<Complex>& to, Function number) {
    const auto vector = [&](const Vector<Complex>& a, const Vector<Complex>& b) {
        return Vector<Scalar>{number(a[0], b[0]), number(a[1], b[1]), number(a[2], b[2])};
    };
    Images<Scalar> result(from.size());
    for (std::size_t view = 0; view < from.size(); ++view) {
        const auto& a = from[view];
        const auto& b = to[view];
        for (std::size_t p = 0; p < a.points.size(); ++p)
            result[view].points.push_back(vector(a.points[p], b.points[p]));
        for (std::size_t line = 0; line < a.lines.size(); ++line)
            result[view].lines.push_back({vector(a.lines[line][0], b.lines[line][0]),
                                          vector(a.lines[line][1], b.lines[line][1])});
    }
    return result;
}

bool is_dependent(const Problem& problem, std::size_t point) {
    return carrier(problem, static_cast<int>(point)).has_value();
}

/// A random image vector, or two random factors.
Vector<Complex> random_entry(const Problem& problem, std::size_t point, Random& random) {
    Vector<Complex> vector = random.complex3();
    if (is_dependent(problem, point)) vector[2] = 0;
    return vector;
}

Vector<Complex> image(const Camera& camera, const Vector<Complex>& x, const Complex& depth) {
    const Eigen::Vector3cd y = camera * Eigen::Vector4cd(x[0], x[1], x[2], depth);
    return {y[0], y[1], y[2]};
}

/// The depth of the equation's place, where `point` has the unknown depths first.
Moving depth_at(const Incidence<Moving>& equation, const Point& point) {
    Moving depth;
    for (std::size_t k = 0; k < equation.depth.size(); ++k)
        depth = depth + equation.depth[k] * Moving(point[static_cast<Index>(k)]);
    return depth;
}

ViewImages<Complex> random_view(const Problem& problem, Random& random) {
    ViewImages<Complex> view;
    for (std::size_t p = 0; p < problem.points.size(); ++p)
        view.points.push_back(random_entry(problem, p, random));
    for (std::size_t line = 0; line < problem.lines.size(); ++line) {
        const Vector<Complex> first = random.complex3();
        view.lines.push_back({first, random.complex3()});
    }
    return view;
}

/// What a camera sees of the places that view 1 shows, at these depths. Factors of dependent points
/// are those of view 1.
ViewImages<Complex> seen_by(const Problem& problem, const Camera& camera,
                            const ViewImages<Complex>& first, const Point& depths) {
    ViewImages<Complex> view = first;
    Index next = 0;
    for (std::size_t p = 0; p < view.points.size(); ++p)
        if (!is_dependent(problem, p))
            view.points[p] = image(camera, first.points[p], depths[next++]);
    for (std::size_t line = 0; line < view.lines.size(); ++line) {
        const std::size_t points = problem.lines[line].points.size();
        for (std::size_t end = points; end < 2; ++end)
            view.lines[line][end] = image(camera, first.lines[line][end], depths[next++]);
    }
    return view;
}

} // namespace

Images<Moving> on_the_way(const Images<Complex>& from, const Images<Complex>& to, double time) {
    return combined<Moving>(from, to, [&](const Complex& a, const Complex& b) {
        return Moving(a + time * (b - a), b - a);
    });
}

Images<Polynomial> straight_way(const Images<Complex>& from, const Images<Complex>& to) {
    return combined<Polynomial>(
        from, to, [](const Complex& a, const Complex& b) { return Polynomial(a, b - a); });
}

System::System(Problem problem, Random& random)
    : System(problem, CameraChart(*problem.cameras, problem.views, random)) {}

System::System(Problem problem, CameraChart chart)
    : problem_(std::move(problem)), depths_(static_cast<Index>(unknown_depths(problem_))),
      chart_(std::move(chart)) {}

void System::evaluate(const Images<Moving>& images, const Point& point, Evaluation& result) const {
    const std::vector<Incidence<Moving>> equations = incidences(problem_, images);
    const auto size = static_cast<Index>(equations.size());
    result.values.resize(size);
    result.speeds.resize(size);
    result.jacobian.setZero(size, unknowns());
    std::vector<CameraWithDerivatives> cameras(1); // none of view 0
    const Point coordinates = point.tail(chart_.dimension());
    for (std::size_t view = 1; view < images.size(); ++view)
        cameras.push_back(chart_.camera(view, coordinates));
    for (Index e = 0; e < size; ++e)
        evaluate_row(e, equations[static_cast<std::size_t>(e)], cameras, point, result);
}

void System::evaluate_row(Index row, const Incidence<Moving>& equation,
                          const std::vector<CameraWithDerivatives>& cameras, const Point& point,
                          Evaluation& result) const {
    const auto& [camera, by_coordinate, by_shared] = cameras[equation.view];
    const Vector<Moving>& l = equation.l;
    const Vector<Moving>& x = equation.x;
    const Moving depth = depth_at(equation, point);
    const Eigen::RowVector3cd line(l[0].value, l[1].value, l[2].value);
    const Eigen::RowVector3cd line_speed(l[0].speed, l[1].speed, l[2].speed);
    const Eigen::Vector4cd place(x[0].value, x[1].value, x[2].value, depth.value);
    const Eigen::Vector4cd place_speed(x[0].speed, x[1].speed, x[2].speed, depth.speed);
    const Eigen::RowVector4cd ray = line * camera;
    result.values[row] = ray * place;
    result.speeds[row] = (line_speed * camera * place + ray * place_speed).value();
    for (Index k = 0; k < depths_; ++k)
        result.jacobian(row, k) = equation.depth[static_cast<std::size_t>(k)].value * ray[3];
    const auto set = [&](const std::vector<Camera>& derivatives, Index column) {
        for (const Camera& derivative : derivatives)
            result.jacobian(row, column++) = (line * derivative * place).value();
    };
    set(by_shared, depths_);
    set(by_coordinate, depths_ + chart_.offset(equation.view));
}

Point System::newton_step(const Images<Moving>& images, const Point& point,
                          Evaluation& room) const {
    evaluate(images, point, room);
    return room.jacobian.partialPivLu().solve(room.values);
}

bool System::has_cameras(const Point& point) const {
    const auto is_camera = problem_.cameras->is_camera;
    if (is_camera == nullptr) return true;
    const Point coordinates = point.tail(chart_.dimension());
    for (std::size_t view = 1; view < static_cast<std::size_t>(chart_.views()); ++view)
        if (!is_camera(chart_.numbers(view, coordinates).data())) return false;
    return true;
}

SolvedImages System::random_scene(Random& random) const {
    Point solution(unknowns());
    for (Complex& x : solution)
        x = random.complex();
    SolvedImages scene{{random_view(problem_, random)}, solution};
    const Point coordinates = solution.tail(chart_.dimension());
    for (std::size_t view = 1; view < static_cast<std::size_t>(problem_.views); ++view) {
        const Camera camera = chart_.camera(view, coordinates).camera;
        scene.images.push_back(seen_by(problem_, camera, scene.images[0], solution));
    }
    return scene;
}

Images<Complex> random_images(const Problem& problem, Random& random) {
    Images<Complex> images;
    for (int view = 0; view < problem.views; ++view)
        images.push_back(random_view(problem, random));
    return images;
}

Images<Complex> rephased(const Problem& problem, Images<Complex> images, Random& random) {
    for (std::size_t view = 1; view < images.size(); ++view) {
        ViewImages<Complex>& seen = images[view];
        std::vector<Complex> phases;
        for (std::size_t p = 0; p < seen.points.size(); ++p) {
            phases.push_back(random.any_phase());
            const auto carrier = plprove::carrier(problem, static_cast<int>(p));
            if (carrier) {
                const auto& on_it = problem.lines[static_cast<std::size_t>(*carrier)].points;
                seen.points[p][0] *= phases[p] / phases[static_cast<std::size_t>(on_it[0])];
                seen.points[p][1] *= phases[p] / phases[static_cast<std::size_t>(on_it[1])];
            } else {
                for (Complex& x : seen.points[p])
                    x *= phases[p];
            }
        }
        for (auto& line : seen.lines)
            for (Vector<Complex>& point : line) {
                const Complex phase = random.any_phase();
                for (Complex& x : point)
                    x *= phase;
            }
    }
    return images;
}

} // namespace plprove::many_views
