#include "prover/cli/solve_model.h"

#include "prover/cli/input_file.h"
#include "prover/cli/model_data.h"
#include "prover/cli/model_source.h"
#include "prover/cli/sections.h"
#include "prover/model/solver/model_solver.h"
#include "prover/system/progress.h"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace plprove {

namespace {

using Json = nlohmann::ordered_json;
using model::ModelAnswer;
using model::ModelSolution;
using model::ModelSolver;

ModelSolver solver_for(const ModelSolveRequest& request, const model::Model& model) {
    ProgressLine line("finding solutions for random data", 0);
    line.show(0);
    return ModelSolver(model, {0, request.threads, [&](std::size_t found) { line.show(found); }});
}

bool is_complete(const ModelSolver& solver, const ModelAnswer& answer) {
    return solver.degree() > 0 && answer.solutions.size() >= solver.degree();
}

std::string completeness(const ModelSolver& solver, const ModelAnswer& answer) {
    const std::string found = std::to_string(answer.solutions.size());
    if (solver.degree() == 0 && answer.lost == 0)
        return found + ": loops of random data found no more, but more are not excluded";
    const std::size_t known = std::max(solver.degree(), solver.found());
    const std::string count = found + " of " + std::to_string(known);
    if (is_complete(solver, answer)) return count + ": as many as there are modulo a prime";
    if (answer.lost == 0) return count + ": no paths to the others were found";
    return count + ": others go to infinity for these data, are not regular, or were lost";
}

/// The unknowns by name: numbers, or [re, im] where the solution is not real.
Json unknowns_json(const model::Program& program, const ModelSolution& solution) {
    std::vector<Json> numbers;
    for (const std::complex<double>& z : solution.unknowns)
        numbers.push_back(solution.real ? Json(z.real()) : Json::array({z.real(), z.imag()}));
    Json result = Json::object();
    std::size_t first = 0;
    for (const model::Named& named : program.unknown_names) {
        result[named.name] = nested_lists(named.value.shape, numbers, first);
        first += named.value.scalars.size();
    }
    return result;
}

std::string json_report(const std::string& name, const ModelSolver& solver,
                        const ModelAnswer& answer, bool real_only) {
    Json report{{"model", name},
                {"degree", solver.degree() > 0 ? Json(solver.degree()) : Json()},
                {"found", answer.solutions.size()},
                {"lost", answer.lost},
                {"complete", is_complete(solver, answer) ? "evidence" : "unknown"},
                {"solutions", Json::array()}};
    for (const ModelSolution& solution : answer.solutions)
        if (solution.real || !real_only)
            report["solutions"].push_back(
                {{"real", solution.real},
                 {"residual", solution.residual},
                 {"unknowns", unknowns_json(solver.program(), solution)}});
    return report.dump(1) + '\n';
}

/// Nested lists with digits enough for a reader.
void write_value(std::ostream& out, const Json& value) {
    if (!value.is_array()) {
        out << value.get<double>();
        return;
    }
    out << '[';
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (i > 0) out << ", ";
        write_value(out, value[i]);
    }
    out << ']';
}

std::string text_report(const std::string& name, const ModelSolver& solver,
                        const ModelAnswer& answer) {
    std::ostringstream out;
    section(out, "model") << name << '\n';
    section(out, "solutions") << completeness(solver, answer) << '\n';
    section(out, "real") << answer.real() << '\n';
    double residual = 0;
    for (const ModelSolution& solution : answer.solutions)
        residual = std::max(residual, solution.residual);
    section(out, "residual") << std::scientific << std::setprecision(0) << residual
                             << " at most, relative to the terms of an equation\n";
    out << std::defaultfloat << std::setprecision(7);
    for (std::size_t i = 0; i < answer.real(); ++i) {
        out << '\n';
        std::string label = std::to_string(i + 1);
        const Json unknowns = unknowns_json(solver.program(), answer.solutions[i]);
        for (const auto& [unknown, value] : unknowns.items()) {
            section(out, label) << unknown << " = ";
            write_value(out, value);
            out << '\n';
            label.clear();
        }
    }
    return out.str();
}

model::Model model_in(const std::string& path) {
    return in_model_file(path, [&] { return model::read_model(content_of(path)); });
}

} // namespace

bool names_model(const std::string& argument) {
    return argument.ends_with(".model");
}

int solve_model(const ModelSolveRequest& request, const Deliver& deliver) {
    const model::Model model = model_in(request.model);
    const auto data = in_model_file(request.model, [&] {
        return read_model_data(model::compile(model), content_of(request.data), request.data);
    });
    const ModelSolver solver =
        in_model_file(request.model, [&] { return solver_for(request, model); });
    const ModelAnswer answer = solver.solve(data);
    deliver(request.path, request.json ? json_report(model.name, solver, answer, request.real)
                                       : text_report(model.name, solver, answer));
    return answer.solutions.empty() ? 1 : 0;
}

int write_example_data(const std::string& path_of_model, const std::string& path,
                       const Deliver& deliver) {
    const model::Program program =
        in_model_file(path_of_model, [&] { return model::compile(model_in(path_of_model)); });
    deliver(path, model_data_file(program, model::example_data(program, 1)));
    return 0;
}

} // namespace plprove
