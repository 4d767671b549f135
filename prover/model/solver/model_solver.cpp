#include "prover/model/solver/model_solver.h"

#include "prover/model/fibre.h"
#include "prover/model/solver/random_solutions.h"
#include "prover/model/solver/solution_collection.h"
#include "prover/system/words.h"

#include <algorithm>

namespace plprove::model {

namespace {

void require_data(const Program& program) {
    if (program.data == 0)
        throw BadInput("the model has no data: solve moves data, so that solutions move; make "
                       "numbers of the equations data");
}

Program program_to_solve(const Model& model) {
    Program program = compile(model);
    if (program.equations.size() != program.unknowns)
        throw BadInput(counted(program.equations.size(), "equation") + " for " +
                       counted(program.unknowns, "unknown") + ": solve takes equally many");
    require_data(program);
    return program;
}

} // namespace

struct ModelSolver::State {
    State(const Model& model, const ModelSolverOptions& options)
        : program(program_to_solve(model)), equations(program), threads(options.threads),
          seed(options.seed) {
        const auto fibre = find_fibre(model, program).fibre;
        if (fibre) degree = fibre->count();
        const std::size_t known = fibre ? fibre->polynomial.degree() : 0;
        start = find_start(program, equations, {seed, threads, known, options.found});
        SolutionCollection solutions(program, start.data);
        for (const Numbers& solution : start.solutions)
            solutions.add(solution);
        found = std::move(solutions).counted().size();
    }

    Program program;
    TrackedEquations equations;
    unsigned threads;
    std::uint64_t seed;
    std::size_t degree = 0, found = 0;
    Start start;
};

ModelSolver::ModelSolver(std::string_view text, const ModelSolverOptions& options)
    : ModelSolver(read_model(text), options) {}
ModelSolver::ModelSolver(const Model& model, const ModelSolverOptions& options)
    : state_(std::make_unique<const State>(model, options)) {}
ModelSolver::~ModelSolver() = default;
ModelSolver::ModelSolver(ModelSolver&&) noexcept = default;
ModelSolver& ModelSolver::operator=(ModelSolver&&) noexcept = default;

const Program& ModelSolver::program() const {
    return state_->program;
}
std::size_t ModelSolver::found() const {
    return state_->found;
}
std::size_t ModelSolver::degree() const {
    return state_->degree;
}
const std::vector<std::complex<double>>& ModelSolver::start_data() const {
    return state_->start.data;
}
const std::vector<std::vector<std::complex<double>>>& ModelSolver::start_solutions() const {
    return state_->start.solutions;
}

ModelAnswer ModelSolver::solve(const std::vector<std::complex<double>>& data) const {
    SolutionCollection solutions(state_->program, data);
    solutions.follow(state_->start, state_->equations, state_->seed, state_->threads);
    ModelAnswer answer{std::move(solutions).counted(), 0};
    answer.lost = state_->found - std::min(state_->found, answer.solutions.size());
    return answer;
}

std::size_t ModelAnswer::real() const {
    return static_cast<std::size_t>(std::ranges::count_if(solutions, &ModelSolution::real));
}

std::vector<double> example_data(const Program& program, std::uint64_t seed) {
    require_data(program);
    constexpr std::uint64_t stream = 2;
    Random random(seed, stream);
    const auto solved = random_solution(program, Field::real, random);
    if (!solved)
        throw BadInput("no real data with a real solution were found: the model may have none");
    std::vector<double> data;
    for (const std::complex<double>& z : solved->data)
        data.push_back(z.real());
    return data;
}

} // namespace plprove::model
