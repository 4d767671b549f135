#include "prover/model/solver/model_solver.h"

#include "prover/model/fibre.h"
#include "prover/model/solver/random_solutions.h"
#include "prover/model/solver/start.h"
#include "prover/monodromy/solution_set.h"
#include "prover/system/words.h"

#include <algorithm>

namespace plprove::model {

namespace {

constexpr double near_of_refined = 1e-7;

SolutionSet<Numbers> no_solutions() {
    return SolutionSet<Numbers>(near_of_refined, Nearness::of_coordinates);
}

Numbers conjugate(Numbers numbers) {
    for (std::complex<double>& z : numbers)
        z = std::conj(z);
    return numbers;
}

bool all_real(const Numbers& numbers) {
    return std::ranges::all_of(numbers, [](const auto& z) { return z.imag() == 0; });
}

/// The solution itself, if it is real: without the imaginary parts that rounding gives it.
std::optional<Numbers> real_one(const Program& program, const Numbers& data,
                                const Numbers& solution) {
    constexpr double tiny = 1e-7;
    Numbers real;
    for (const std::complex<double>& z : solution) {
        if (!(std::abs(z.imag()) < tiny * (1 + std::abs(z)))) return std::nullopt;
        real.emplace_back(z.real());
    }
    auto point = refined(program, data, real);
    if (!point || !approximates(*point, solution, near_at_path_ends)) return std::nullopt;
    for (std::complex<double>& z : *point)
        z = z.real();
    return point;
}

/// Solutions for the same data, different in what counts.
class Collection {
public:
    Collection(const Program& program, const Numbers& data)
        : program_(program), data_(data), real_data_(all_real(data)) {}

    /// Adds the solution that this approximates, and its conjugate where the data are real.
    void add(const Numbers& approximation) {
        const auto solution = refined(program_, data_, approximation);
        if (!solution || !keeps_conditions(program_, data_, *solution)) return;
        const auto real = real_data_ ? real_one(program_, data_, *solution) : std::nullopt;
        add_new(real ? *real : *solution, real.has_value());
        if (real_data_ && !real) add_new(conjugate(*solution), false);
    }

    /// All solutions, whether what counts tells them apart or not.
    std::size_t size() const { return found_.size(); }

    /// Each that counts once, the real ones first, in the order of their numbers.
    std::vector<ModelSolution> counted() && {
        std::ranges::stable_sort(found_, [](const ModelSolution& a, const ModelSolution& b) {
            return a.real != b.real ? a.real : parts(a.unknowns) < parts(b.unknowns);
        });
        SolutionSet<Numbers> seen = no_solutions();
        std::vector<ModelSolution> result;
        for (ModelSolution& solution : found_) {
            const Numbers what_counts = counted_by(solution.unknowns);
            if (seen.find(what_counts)) continue;
            seen.add(what_counts);
            result.push_back(std::move(solution));
        }
        return result;
    }

private:
    void add_new(const Numbers& solution, bool real) {
        if (known_.find(solution)) return;
        known_.add(solution);
        found_.push_back({solution, real, residual_of(program_, data_, solution)});
    }

    Numbers counted_by(const Numbers& unknowns) const {
        if (!program_.counts) return unknowns;
        return values_of(program_, program_.counted, data_, unknowns).value_or(unknowns);
    }

    static std::vector<double> parts(const Numbers& numbers) {
        std::vector<double> result;
        for (const std::complex<double>& z : numbers)
            result.insert(result.end(), {z.real(), z.imag()});
        return result;
    }

    const Program& program_;
    const Numbers& data_;
    bool real_data_;
    SolutionSet<Numbers> known_ = no_solutions();
    std::vector<ModelSolution> found_;
};

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
        Collection solutions(program, start.data);
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
    constexpr int most_ways = 4;
    constexpr std::uint64_t stream = 1; // another one than that of monodromy
    Random random(state_->seed, stream);
    const std::vector<Numbers>& starts = state_->start.solutions;
    Collection solutions(state_->program, data);
    Numbers bend(data.size());
    for (int way = 0; way < most_ways && solutions.size() < starts.size(); ++way) {
        const Care care = way == 0 ? Care::usual : Care::careful;
        for (const auto& end : follow_all(state_->equations, {state_->start.data, data, bend},
                                          starts, care, state_->threads))
            if (end) solutions.add(*end);
        bend = random_numbers(data.size(), Field::complex, random);
    }
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
