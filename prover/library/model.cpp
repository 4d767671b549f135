#include "prover/library/pointline/model.h"

#include "prover/library/guarded.h"
#include "prover/model/solver/model_solver.h"
#include "prover/model/template_python.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace pointline {

struct Model::Content {
    std::string text;
    plprove::model::Model model;
    plprove::model::Program program;
    std::mutex looking;
    std::optional<plprove::model::Study> found;

    const plprove::model::Study& study() {
        const std::scoped_lock lock(looking);
        if (!found) found = plprove::model::study(text);
        return *found;
    }
};

Model::Model(std::shared_ptr<Content> content) : content_(std::move(content)) {}

Result<Model> Model::read(std::string_view text) noexcept {
    return guarded<Model>(Failure::bad_problem, [&] {
        auto content = std::make_shared<Content>();
        content->text = text;
        content->model = plprove::model::read_model(text);
        content->program = plprove::model::compile(content->model);
        return Model(std::move(content));
    });
}

const std::string& Model::name() const {
    return content_->model.name;
}

std::optional<int> Model::claimed() const {
    const int claimed = content_->model.claimed;
    return claimed == 0 ? std::nullopt : std::optional(claimed);
}

int Model::data() const {
    return static_cast<int>(content_->program.data);
}

int Model::unknowns() const {
    return static_cast<int>(content_->program.unknowns);
}

int Model::equations() const {
    return static_cast<int>(content_->program.equations.size());
}

Result<Solutions> Model::solutions() const noexcept {
    return guarded<Solutions>(Failure::bad_problem, [&] {
        const plprove::model::Study& study = content_->study();
        Solutions solutions;
        if (study.at_most()) solutions.at_most = static_cast<int>(*study.at_most());
        if (study.fibre || solutions.at_most == 0)
            solutions.at_least = static_cast<int>(study.at_least());
        return solutions;
    });
}

Result<std::string> Model::certificate() const noexcept {
    return guarded<std::string>(Failure::bad_problem,
                                [&] { return plprove::model::write(content_->study()); });
}

Result<std::string> Model::python_solver() const noexcept {
    return guarded<std::string>(Failure::bad_problem, [&] {
        const plprove::model::Study& study = content_->study();
        return plprove::model::python_module(study, plprove::model::make_template(study));
    });
}

struct ModelSolver::Content {
    plprove::model::ModelSolver solver;
    std::vector<NamedArray> data, unknowns;
};

namespace {

std::vector<NamedArray> arrays_of(const std::vector<plprove::model::Named>& names) {
    std::vector<NamedArray> arrays;
    for (const plprove::model::Named& named : names)
        arrays.push_back({named.name, named.value.shape});
    return arrays;
}

} // namespace

ModelSolver::ModelSolver(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

Result<ModelSolver> ModelSolver::make(const Model& model) noexcept {
    return guarded<ModelSolver>(Failure::bad_problem, [&] {
        const plprove::model::Program& program = model.content_->program;
        return ModelSolver(std::make_shared<const Content>(
            Content{plprove::model::ModelSolver(model.content_->model),
                    arrays_of(program.data_names), arrays_of(program.unknown_names)}));
    });
}

const std::vector<NamedArray>& ModelSolver::data() const {
    return content_->data;
}

const std::vector<NamedArray>& ModelSolver::unknowns() const {
    return content_->unknowns;
}

int ModelSolver::found() const {
    return static_cast<int>(content_->solver.found());
}

Result<ModelAnswer> ModelSolver::solve(std::span<const double> data) const noexcept {
    return guarded<ModelAnswer>(Failure::bad_problem, [&] {
        const std::size_t expected = content_->solver.program().data;
        if (data.size() != expected)
            throw plprove::BadInput("there are " + std::to_string(data.size()) +
                                    " numbers of data: give the " + std::to_string(expected) +
                                    " that the model has");
        if (!std::ranges::all_of(data, [](double x) { return std::isfinite(x); }))
            throw plprove::BadInput("a number of the data is not finite: give finite ones");
        plprove::model::ModelAnswer found = content_->solver.solve({data.begin(), data.end()});
        ModelAnswer answer{{}, static_cast<int>(found.lost)};
        for (plprove::model::ModelSolution& solution : found.solutions)
            answer.solutions.push_back(
                {std::move(solution.unknowns), solution.real, solution.residual});
        return answer;
    });
}

} // namespace pointline
