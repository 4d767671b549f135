// Numeric solutions of models: derivatives against those of GradientRing, numbers of solutions
// against the certificates.
#include "prover/model/solver/lifted_fibre.h"
#include "prover/model/solver/model_solver.h"
#include "prover/model/solver/random_solutions.h"
#include "prover/model/solver/tracked_equations.h"
#include "prover/model/solver/tracking/evaluation.h"
#include "tests/support/program.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using namespace plprove;
using namespace plprove::model;

std::string text_of(const std::string& name) {
    return read_file(std::string(SOURCE_DIR) + "/models/" + name + ".model");
}

/// The matrix of the tracker: the Jacobian, the values and the derivatives by time, by rows.
std::vector<std::complex<double>> matrix_of(const TrackedProgram& program,
                                            const std::vector<TrackedCurve>& curves, double time,
                                            const Numbers& unknowns) {
    namespace lanes = model::portable;
    std::vector<lanes::Number> places(static_cast<std::size_t>(program.places));
    for (std::size_t i = 0; i < unknowns.size(); ++i)
        places[i] = {{unknowns[i].real()}, {unknowns[i].imag()}};
    lanes::set_constants(program, places.data());
    lanes::evaluate<true>(program, curves.data(), {time}, places.data());
    std::vector<std::complex<double>> matrix;
    for (int i = program.unknowns; i < program.unknowns * (1 + program.columns()); ++i) {
        const lanes::Number& entry = places[static_cast<std::size_t>(i)];
        matrix.emplace_back(entry.re.v, entry.im.v);
    }
    return matrix;
}

bool are_near(const std::complex<double>& a, const std::complex<double>& b) {
    return std::abs(a - b) < 1e-9 * (1 + std::abs(b));
}

/// A random solution of a model, and data that move from its data elsewhere.
struct Journey {
    model::Program program;
    SolvedData start;
    std::vector<TrackedCurve> curves;

    explicit Journey(const std::string& name) : program(compile(read_model(text_of(name)))) {
        Random random(7, 0);
        start = random_solution(program, Field::complex, random).value();
        for (const std::complex<double>& a : start.data) {
            const std::complex<double> b = random.complex(), c = random.complex();
            curves.push_back({{{a.real(), a.imag()}, {b.real(), b.imag()}, {c.real(), c.imag()}}});
        }
    }
};

const std::vector<std::string> few{"p3p", "five_points", "gps", "p2p1l", "radial_absolute_pose"};

} // namespace

TEST_CASE("the program of the tracker computes what a gradient ring does") {
    for (const std::string& name : few) {
        CAPTURE(name);
        const Journey journey(name);
        const TrackedEquations equations(journey.program);
        Random random(8, 0);
        const Numbers unknowns = random_numbers(journey.program.unknowns, Field::complex, random);
        const double time = 0.3;
        Numbers data;
        Eigen::VectorXcd speed(static_cast<Eigen::Index>(journey.curves.size()));
        for (const TrackedCurve& curve : journey.curves) {
            std::complex<double> c[3];
            for (std::size_t i = 0; i < 3; ++i)
                c[i] = {curve.coefficients[i][0], curve.coefficients[i][1]};
            speed[static_cast<Eigen::Index>(data.size())] = c[1] + 2 * time * c[2];
            data.push_back(c[0] + time * (c[1] + time * c[2]));
        }
        const Linearisation expected = linearise(journey.program, data, unknowns, true).value();
        const Eigen::VectorXcd by_time = expected.by_data * speed;
        const auto found = matrix_of(equations.tracked(), journey.curves, time, unknowns);
        const auto n = static_cast<Eigen::Index>(unknowns.size());
        for (Eigen::Index row = 0; row < n; ++row) {
            const auto entry = [&](Eigen::Index column) {
                return found[static_cast<std::size_t>(row * (n + 2) + column)];
            };
            for (Eigen::Index column = 0; column < n; ++column)
                CHECK(are_near(entry(column), expected.by_unknowns(row, column)));
            CHECK(are_near(entry(n), expected.values[row]));
            CHECK(are_near(entry(n + 1), by_time[row]));
        }
    }
}

TEST_CASE("every instruction set follows the paths of a model to the same bits") {
    std::vector<model::TrackFunction*> trackers{model::portable::track};
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        trackers.push_back(model::avx2::track);
    if (__builtin_cpu_supports("avx512f")) trackers.push_back(model::avx512::track);
#endif
    for (const std::string& name : few) {
        CAPTURE(name);
        const Journey journey(name);
        const TrackedEquations equations(journey.program);
        constexpr std::size_t paths = 11;
        std::vector<double> starts;
        for (std::size_t path = 0; path < paths; ++path)
            for (const std::complex<double>& x : journey.start.unknowns) {
                starts.push_back(x.real() +
                                 static_cast<double>(path % 3) * 1e-3 * static_cast<double>(path));
                starts.push_back(x.imag());
            }
        std::vector<std::vector<double>> ends;
        std::vector<std::vector<TrackOutcome>> outcomes;
        for (model::TrackFunction* track : trackers) {
            std::vector<LaneNumber> workspace(model::workspace_size(equations.tracked()));
            ends.emplace_back(starts.size());
            outcomes.emplace_back(paths);
            track(equations.tracked(), journey.curves.data(), {}, paths, starts.data(),
                  ends.back().data(), outcomes.back().data(), workspace.data());
        }
        for (std::size_t i = 1; i < trackers.size(); ++i) {
            CHECK(ends[i] == ends[0]);
            CHECK(outcomes[i] == outcomes[0]);
        }
        CHECK(outcomes[0][0] == TrackOutcome::arrived);
    }
}

TEST_CASE("a solver finds as many solutions as the literature says, and the true one") {
    const std::vector<std::pair<std::string, std::size_t>> counts{
        {"p3p", 8},   {"five_points", 10},         {"gps", 2},         {"homography", 1},
        {"p2p1l", 4}, {"radial_absolute_pose", 4}, {"two_circles", 8}, {"p3l", 8}};
    for (const auto& [name, count] : counts) {
        CAPTURE(name);
        const ModelSolver solver(text_of(name));
        CHECK(solver.degree() == count);
        CHECK(solver.found() == count);
        Random random(9, 0);
        const SolvedData truth = random_solution(solver.program(), Field::real, random).value();
        const ModelAnswer answer = solver.solve(truth.data);
        CHECK(answer.lost == 0);
        CHECK(answer.solutions.size() == count);
        CHECK(answer.real() > 0);
        for (const ModelSolution& solution : answer.solutions)
            CHECK(solution.residual < 1e-8);
        const auto what_counts = [&](const Numbers& unknowns) {
            return counted_values(solver.program(), truth.data, unknowns).value();
        };
        const Numbers expected = what_counts(truth.unknowns);
        CHECK(std::ranges::any_of(answer.solutions, [&](const ModelSolution& solution) {
            return solution.real &&
                   std::ranges::equal(what_counts(solution.unknowns), expected, are_near);
        }));
    }
}

TEST_CASE("solutions of real data are real or in conjugate pairs") {
    const ModelSolver solver(text_of("p3p"));
    const std::vector<double> data = example_data(solver.program(), 3);
    const ModelAnswer answer = solver.solve({data.begin(), data.end()});
    CHECK((answer.solutions.size() - answer.real()) % 2 == 0);
    for (std::size_t i = 0; i < answer.solutions.size(); ++i)
        CHECK(answer.solutions[i].real == (i < answer.real()));
}

TEST_CASE("parts of the solutions that no loop of data joins are found") {
    const ModelSolver solver("model m\ndata a, b\nunknown x\n"
                             "equation (x - a)*(x - b)*(x - a - b) = 0\n");
    CHECK(solver.found() == 3);
    const ModelAnswer answer = solver.solve({2.0, 5.0});
    REQUIRE(answer.real() == 3);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(are_near(answer.solutions[i].unknowns[0], std::vector<double>{2, 5, 7}[i]));
}

TEST_CASE("solutions that come together are lost, and said to be") {
    const ModelSolver solver("model m\ndata a\nunknown x\nequation x^2 = a\n");
    CHECK(solver.solve({4.0}).real() == 2);
    CHECK(solver.solve({-4.0}).real() == 0);
    CHECK(solver.solve({-4.0}).solutions.size() == 2);
    CHECK(solver.solve({0.0}).lost == 2);
}

TEST_CASE("models that cannot be solved are refused") {
    CHECK_THROWS_WITH_AS(ModelSolver("model m\ndata a\nunknown x, y\nequation x = a\n"),
                         "1 equation for 2 unknowns: solve takes equally many", BadInput);
    CHECK_THROWS_AS(ModelSolver("model m\nunknown x\nequation x^2 = 2\n"), BadInput);
    CHECK_THROWS_AS(ModelSolver("model m\ndata a\nunknown x\nequation (x - a)^2 = 0\n"), BadInput);
}

TEST_CASE("a fibre by lifting has all solutions that a Gröbner basis finds") {
    for (const std::string name : {"p3p", "five_points", "gp3p"}) {
        CAPTURE(name);
        const Model model = read_model(text_of(name));
        const model::Program program = compile(model);
        const auto expected = find_fibre(model, program).fibre;
        const auto lifted = lifted_fibre(model, program, {.threads = 2}).fibre;
        REQUIRE(expected);
        REQUIRE(lifted);
        CHECK(lifted->count() == expected->count());
        CHECK(lifted->polynomial.degree() == expected->polynomial.degree());
        CHECK(lifted_fibre(model, program).fibre->unknowns[0].coefficient(0) ==
              lifted->unknowns[0].coefficient(0));
    }
}

TEST_CASE(
    "lifting tries larger data where small ones are special, and leaves out what is singular") {
    const auto count = [](const std::string& body) {
        const Model model = read_model("model m\ndata a, b\nunknown x\n" + body);
        const auto fibre = lifted_fibre(model, compile(model)).fibre;
        return fibre ? fibre->count() : 0;
    };
    CHECK(count("equation x^2 = a\nnonzero (a^2 - 1)*(a^2 - 4)\n") == 2);
    CHECK(count("equation x^3 = a/3\n") == 3);
    CHECK(count("equation x*(x^2 - a)*(x - a)^2 = 0\n") == 3);
    CHECK(count("equation x^4 + a*x^2 = b\ncount x^2\n") == 2);
}

TEST_CASE("a model without data, or without a regular solution, is not lifted") {
    const auto reason = [](const std::string& text) {
        const Model model = read_model(text);
        const FibreSearch search = lifted_fibre(model, compile(model));
        CHECK(!search.fibre);
        return search.reason;
    };
    CHECK(reason("model m\nunknown x\nequation x^2 = 2\n") ==
          "there are no data that could move solutions to others");
    CHECK(reason("model m\ndata a\nunknown x\nequation (x - a)^2 = 0\n")
              .starts_with("no data with a solution were found"));
}
