#include "prover/cli/solve_report.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace plprove {

namespace {

using Json = nlohmann::ordered_json;

std::array<double, 4> quaternion(const Eigen::Matrix3cd& R) {
    const Eigen::Matrix3d real = R.real();
    Eigen::Quaterniond q(real);
    if (q.w() < 0) q.coeffs() = -q.coeffs();
    return {q.w(), q.x(), q.y(), q.z()};
}

int real_solutions(const Answer& answer) {
    return static_cast<int>(std::ranges::count_if(answer.solutions, &Solution::real));
}

Json number(const std::complex<double>& z, bool real) {
    if (real) return z.real();
    return Json::array({z.real(), z.imag()});
}

/// By rows.
template <class Matrix>
Json numbers(const Matrix& matrix, bool real) {
    Json result = Json::array();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
        for (Eigen::Index j = 0; j < matrix.cols(); ++j)
            result.push_back(number(matrix(i, j), real));
    return result;
}

Json camera_json(const ComplexPose& pose, bool real) {
    Json result{{"R", numbers(pose.R, real)}};
    if (real) result["quaternion"] = quaternion(pose.R);
    result["t"] = numbers(pose.t, real);
    return result;
}

Json feature_json(const SpaceFeature& feature, bool real) {
    Json result{{"point", nullptr}, {"lines", Json::object()}, {"in_front", Json::array()}};
    if (feature.point) result["point"] = numbers(*feature.point, real);
    for (std::size_t line = 0; line < feature.lines.size(); ++line) {
        Json& entry = result["lines"][std::string(1, static_cast<char>('a' + line))];
        if (const auto& found = feature.lines[line])
            entry = {{"point", numbers(found->point, real)},
                     {"direction", numbers(found->direction, real)}};
    }
    for (const auto& front : feature.in_front)
        result["in_front"].push_back(front ? Json(*front) : Json());
    return result;
}

Json solution_json(const Solution& solution) {
    Json result{{"real", solution.real}, {"cameras", Json::array()}, {"features", Json::array()}};
    for (const ComplexPose& pose : solution.cameras)
        result["cameras"].push_back(camera_json(pose, solution.real));
    for (const SpaceFeature& feature : solution.features)
        result["features"].push_back(feature_json(feature, solution.real));
    result["residual"] = solution.residual;
    result["in_front"] = solution.in_front;
    // JSON has no infinity.
    const bool finite = solution.condition && std::isfinite(*solution.condition);
    result["condition"] = finite ? Json(*solution.condition) : Json();
    return result;
}

} // namespace

std::string json_report(const SolveReport& report) {
    const Answer& answer = report.answer;
    Json json{{"problem", notation(report.images.problem)},
              {"class", nullptr},
              {"degree", answer.degree},
              {"found", answer.found},
              {"lost", answer.lost},
              {"complete", name(answer.complete)},
              {"moved", report.moved}};
    if (report.number) json["class"] = *report.number;
    if (!report.warnings.empty()) json["warnings"] = report.warnings;
    if (const auto& note = report.certificate)
        json["certificate"] = {{"file", note->path},
                               {"solutions", note->solutions},
                               {"exact", note->exact},
                               {"moved", note->moved}};
    json["solutions"] = Json::array();
    for (const Solution& solution : answer.solutions)
        json["solutions"].push_back(solution_json(solution));
    return json.dump(1) + '\n';
}

namespace {

std::string completeness(const Answer& answer) {
    switch (answer.complete) {
    case Completeness::certified:
        return "all: the degree is certified";
    case Completeness::unknown:
        return std::to_string(answer.lost) + " are missing: paths were lost, or the images are "
                                             "special";
    }
    return {};
}

std::string camera_row(const ComplexPose& pose) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(6) << "quaternion";
    for (const double x : quaternion(pose.R))
        text << std::setw(10) << x;
    text << "   t";
    for (const auto& x : pose.t)
        text << std::setw(10) << x.real();
    return text.str();
}

void append_solution(std::ostream& text, std::size_t index, const Solution& solution,
                     std::size_t points) {
    text << '\n'
         << std::setw(3) << index + 1 << "  in front " << solution.in_front << " of " << points
         << ", residual " << std::scientific << std::setprecision(0) << solution.residual
         << " pixels";
    if (solution.condition) text << ", condition " << *solution.condition;
    text << '\n';
    for (std::size_t v = 1; v < solution.cameras.size(); ++v)
        text << "     camera " << v + 1 << "  " << camera_row(solution.cameras[v]) << '\n';
}

std::size_t points_of(const Features& problem) {
    return static_cast<std::size_t>(
        std::ranges::count_if(problem, [](const Feature& f) { return point_is_seen(f); }));
}

} // namespace

std::string text_report(const SolveReport& report) {
    const Answer& answer = report.answer;
    const int real = real_solutions(answer);
    std::ostringstream text;
    text << "problem     " << notation(report.images.problem) << '\n'
         << "solutions   " << answer.found << " of " << answer.degree << ", "
         << completeness(answer) << '\n'
         << "real        " << real << '\n';
    if (report.moved > 0)
        text << "moved       " << std::setprecision(2) << report.moved
             << " pixels at most, to make lines meet their points\n";
    if (const auto& note = report.certificate) {
        text << "certificate of " << note->solutions << " solutions for "
             << (note->exact ? "exactly these images" : "images that are at most ");
        if (!note->exact) text << std::setprecision(1) << note->moved << " radians away";
        text << ": certified once plcheck accepts it\n";
    }
    for (std::size_t i = 0; i < answer.solutions.size() && answer.solutions[i].real; ++i)
        append_solution(text, i, answer.solutions[i], points_of(report.images.problem));
    return text.str();
}

} // namespace plprove
