#include "prover/cli/generate_command.h"

#include "prover/cli/model_source.h"
#include "prover/cli/sections.h"
#include "prover/cli/solve_model.h"
#include "prover/cli/written_model.h"
#include "prover/generate/header.h"
#include "prover/minimal/decision.h"
#include "prover/problem/notation.h"
#include "prover/problem/spec.h"
#include "prover/system/exit.h"
#include "prover/system/progress.h"
#include "prover/system/words.h"

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace plprove {

namespace {

constexpr std::size_t most_solutions = 10'000;
constexpr std::size_t most_unknowns = 200; // their matrices are on the stack

struct GenerateRequest {
    std::string spec;
    std::string output = "-";
    std::string name;
    std::uint64_t seed = 0;
    unsigned threads = 1;
    bool json = false;
};

/// A model, and what is known of the problem that it states.
struct Stated {
    std::string file; ///< empty if the model was written for a point-line problem
    ModelSource source;
    std::vector<int> cameras; ///< as generate::HeaderContents has them
    std::string name;         ///< for the namespace; empty for that of the model

    bool is_problem() const { return file.empty(); }
};

/// The text without comments before the first statement, which ModelSource has.
std::vector<std::string> lines_of_text(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(has_control_character(line) ? "#" : line);
    return lines;
}

/// The cameras but the first, where solutions have rotations.
std::vector<int> cameras_of(const Problem& problem) {
    std::vector<int> cameras;
    const std::string_view kind = problem.cameras->name;
    if (kind == "calibrated" || kind == "upright")
        for (int view = 2; view <= problem.views; ++view)
            cameras.push_back(view);
    return cameras;
}

void refuse_not_minimal(const Problem& problem) {
    const std::optional<Features> features = local_features(problem);
    if (features && decide(*features).verdict != Verdict::minimal)
        throw BadInput(notation(problem) +
                       " is not minimal, so that there is no solver: `plprove "
                       "problem '" +
                       notation(problem) + "'` says why");
}

Stated stated(const std::string& spec) {
    if (spec == "-" || names_model(spec)) return {spec, read_model_source(spec), {}, {}};
    const std::optional<Problem> general = parse_general_spec(spec);
    const Problem problem = general ? *general : problem_of(parse_spec(spec));
    refuse_not_minimal(problem);
    ModelSource source{model_of_problem(spec), {"The point-line problem " + notation(problem)}};
    return {"", std::move(source), cameras_of(problem), {}};
}

model::ModelSolver solver_of(const model::Model& model, const GenerateRequest& request) {
    constexpr std::uint64_t attempts = 3;
    ProgressLine line("finding solutions for random data", 0);
    line.show(0);
    const auto show = [&](std::size_t found) { line.show(found); };
    const auto claimed = static_cast<std::size_t>(model.claimed);
    for (std::uint64_t attempt = 1;; ++attempt) {
        model::ModelSolver solver(model, {request.seed + attempt - 1, request.threads, show});
        const std::size_t wanted = std::max(claimed, solver.degree());
        if (solver.found() >= wanted || attempt == attempts) return solver;
    }
}

void refuse_too_many(std::size_t solutions) {
    if (solutions > most_solutions)
        throw BadInput(std::to_string(solutions) + " solutions are too many for a header, which "
                                                   "has at most 10000: solve a smaller problem");
}

/// A solver whose solutions are as many as is known.
model::ModelSolver checked_solver(const model::Model& model, const GenerateRequest& request) {
    const auto claimed = static_cast<std::size_t>(model.claimed);
    refuse_too_many(claimed);
    const model::Program program = model::compile(model);
    if (program.equations.size() != program.unknowns)
        throw BadInput(counted(program.equations.size(), "equation") + " for " +
                       counted(program.unknowns, "unknown") +
                       ": a solver needs equally many, so add or remove some");
    if (program.unknowns == 0 || program.unknowns > most_unknowns)
        throw BadInput(counted(program.unknowns, "unknown") + ": a header takes 1 to " +
                       std::to_string(most_unknowns) + ", so state another problem");
    model::ModelSolver solver = solver_of(model, request);
    refuse_too_many(solver.start_solutions().size());
    const std::string found = std::to_string(solver.found()) + " solutions were found";
    if (solver.found() < solver.degree())
        throw BadInput(found + ", of " + std::to_string(solver.degree()) +
                       " that there are modulo a prime: try another --seed");
    if (claimed != 0 && solver.found() != claimed)
        throw BadInput(found + ", but the model claims " + std::to_string(claimed) +
                       ": try another --seed, or leave out the claim");
    return solver;
}

/// How many solutions there are, and how that is known: one line.
std::string claim(const Stated& stated, const model::Model& model,
                  const model::ModelSolver& solver) {
    const std::string count = counted(solver.found(), "complex solution");
    if (stated.is_problem() && model.claimed > 0)
        return count + " for generic images, which is certified";
    std::string text = count + " for generic data: ";
    if (solver.degree() == solver.found())
        text += "as many as modulo a prime";
    else
        text += "loops of random data found no more";
    if (model.claimed > 0) text += ", and as the model claims";
    return text;
}

std::string file_name(const std::string& path, const std::string& name) {
    return path == "-" ? name + ".h" : std::filesystem::path(path).filename().string();
}

std::string text_report(const model::Model& model, const std::string& solutions,
                        const std::string& name, const std::string& output) {
    std::ostringstream out;
    section(out, "model") << model.name << '\n';
    section(out, "solutions");
    write_wrapped(out, solutions);
    section(out, "solver") << output << ": " << name << "::solve\n";
    return out.str();
}

std::string json_report(const model::Model& model, const model::ModelSolver& solver,
                        const std::string& name, const std::string& output) {
    const nlohmann::ordered_json report = {
        {"model", model.name},
        {"solutions", solver.found()},
        {"degree", solver.degree() > 0 ? nlohmann::ordered_json(solver.degree()) : nullptr},
        {"claimed", model.claimed > 0 ? nlohmann::ordered_json(model.claimed) : nullptr},
        {"paths", solver.start_solutions().size()},
        {"namespace", name},
        {"solver", output}};
    return report.dump(2) + '\n';
}

int write_header(const GenerateRequest& request, const Deliver& deliver) {
    const Stated problem = stated(request.spec);
    const auto in_its_file = [&](const auto& work) { return in_model_file(problem.file, work); };
    const model::Model model = in_its_file([&] { return model::read_model(problem.source.text); });
    const model::ModelSolver solver = in_its_file([&] { return checked_solver(model, request); });
    generate::HeaderContents contents;
    contents.name = request.name.empty() ? generate::name_of_namespace(model.name) : request.name;
    contents.file = file_name(request.output, contents.name);
    contents.about = problem.source.comments;
    contents.model = lines_of_text(problem.source.text);
    contents.solutions = claim(problem, model, solver);
    contents.cameras = problem.cameras;
    deliver(request.output, generate::header(solver, contents));
    if (request.output != "-")
        deliver("-", request.json
                         ? json_report(model, solver, contents.name, request.output)
                         : text_report(model, contents.solutions, contents.name, request.output));
    return 0;
}

std::string refusal_of_name(const std::string& name) {
    return generate::is_name_of_namespace(name)
               ? ""
               : "a namespace of C++ has letters, digits and single _, and is no keyword";
}

} // namespace

Command add_generate_command(CLI::App& program, Deliver deliver) {
    auto request = std::make_shared<GenerateRequest>();
    CLI::App* app = program.add_subcommand(
        "generate", "Write a C++ header that solves a problem, for other programs");
    app->add_option("PROBLEM", request->spec,
                    "a file with a model, NAME.model or - for standard input; or a point-line "
                    "problem, as for `plprove problem`")
        ->required();
    CLI::Option* output = app->add_option("-o,--output", request->output,
                                          "write the header to this file, - for standard output")
                              ->type_name("FILE");
    app->add_option("--name", request->name, "the namespace, instead of the name of the model")
        ->type_name("NAME")
        ->check(CLI::Validator(refusal_of_name, ""));
    app->add_option("--seed", request->seed, "start paths from other random data")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app->add_option("--threads", request->threads,
                    "how many threads look for solutions; the header is the same")
        ->check(CLI::Range(1U, 256U))
        ->capture_default_str();
    app->add_flag("--json", request->json, "print the report as JSON")->needs(output);
    app->footer("The header needs the standard library of C++17 alone. It has all solutions for "
                "random data, and\nfollows them to yours. docs/models.md says how to use it.\n\n"
                "Examples:\n"
                "  plprove generate models/p3p.model -o p3p.h\n"
                "  plprove generate '2*Pa/Pa/Pa + P/P/P' --name chicago -o chicago.h\n"
                "                                       cameras of three views, all 312");
    return {app,
            [request, deliver = std::move(deliver)] { return write_header(*request, deliver); }};
}

} // namespace plprove
