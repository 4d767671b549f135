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

bool is_calibrated(const GivenImages& images) {
    return !images.general || images.general->cameras == &calibrated_cameras;
}

std::string problem_of(const GivenImages& images) {
    return images.general ? notation(*images.general) : notation(images.problem);
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

/// Of uncalibrated cameras.
Json matrix_json(const ComplexPose& pose, bool real) {
    Eigen::Matrix<std::complex<double>, 3, 4> P;
    P << pose.R, pose.t;
    return {{"P", numbers(P, real)}};
}

Json camera_json(const ComplexPose& pose, bool real) {
    Json result{{"R", numbers(pose.R, real)}};
    if (real) result["quaternion"] = quaternion(pose.R);
    result["t"] = numbers(pose.t, real);
    return result;
}

Json feature_json(const SpaceFeature& feature, const Feature& kind, bool real) {
    Json result{{"point", nullptr}, {"lines", Json::object()}, {"in_front", Json::array()}};
    if (feature.point) result["point"] = numbers(*feature.point, real);
    for (std::size_t line = 0; line < feature.lines.size(); ++line) {
        const char letter = letter_of(kind, static_cast<int>(line));
        Json& entry = result["lines"][std::string(1, letter)];
        if (const auto& found = feature.lines[line])
            entry = {{"point", numbers(found->point, real)},
                     {"direction", numbers(found->direction, real)}};
    }
    for (const auto& front : feature.in_front)
        result["in_front"].push_back(front ? Json(*front) : Json());
    return result;
}

Json solution_json(const Solution& solution, const GivenImages& images) {
    Json result{{"real", solution.real}, {"cameras", Json::array()}, {"features", Json::array()}};
    for (const ComplexPose& pose : solution.cameras)
        result["cameras"].push_back(is_calibrated(images) ? camera_json(pose, solution.real)
                                                          : matrix_json(pose, solution.real));
    for (std::size_t f = 0; f < solution.features.size(); ++f)
        result["features"].push_back(
            feature_json(solution.features[f], images.problem[f], solution.real));
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
    Json json{{"problem", problem_of(report.images)},
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
        json["solutions"].push_back(solution_json(solution, report.images));
    return json.dump(1) + '\n';
}

namespace {

std::string completeness(const Answer& answer) {
    switch (answer.complete) {
    case Completeness::certified:
        return "all: the degree is certified";
    case Completeness::evidence:
        return "all by evidence: no more have been found for any images";
    case Completeness::unknown:
        return std::to_string(answer.lost) + " are missing: paths were lost, or the images are "
                                             "special";
    }
    return {};
}

std::size_t points_of(const Features& problem) {
    return static_cast<std::size_t>(
        std::ranges::count_if(problem, [](const Feature& f) { return point_is_seen(f); }));
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

/// The rows of the matrix of an uncalibrated camera, divided by the largest number.
std::string matrix_rows(const ComplexPose& pose) {
    Eigen::Matrix<double, 3, 4> P;
    P << pose.R.real(), pose.t.real();
    P /= P.cwiseAbs().maxCoeff();
    std::ostringstream text;
    for (Eigen::Index i = 0; i < 3; ++i) {
        text << (i == 0 ? "P" : "\n               ");
        for (Eigen::Index j = 0; j < 4; ++j)
            text << std::scientific << std::setprecision(4) << std::setw(13) << P(i, j);
    }
    return text.str();
}

void append_solution(std::ostream& text, std::size_t index, const Solution& solution,
                     const GivenImages& images) {
    text << '\n' << std::setw(3) << index + 1 << "  ";
    if (is_calibrated(images))
        text << "in front " << solution.in_front << " of " << points_of(images.problem) << ", ";
    text << "residual " << std::scientific << std::setprecision(0) << solution.residual
         << " pixels";
    if (solution.condition) text << ", condition " << *solution.condition;
    text << '\n';
    for (std::size_t v = 1; v < solution.cameras.size(); ++v)
        text << "     camera " << v + 1 << "  "
             << (is_calibrated(images) ? camera_row(solution.cameras[v])
                                       : matrix_rows(solution.cameras[v]))
             << '\n';
}

} // namespace

std::string text_report(const SolveReport& report) {
    const Answer& answer = report.answer;
    const int real = real_solutions(answer);
    std::ostringstream text;
    text << "problem     " << problem_of(report.images) << '\n'
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
        append_solution(text, i, answer.solutions[i], report.images);
    return text.str();
}

} // namespace plprove
