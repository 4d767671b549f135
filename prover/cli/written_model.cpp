#include "prover/cli/written_model.h"

#include "prover/cli/problem_report.h"
#include "prover/many_views/degrees_on_file.h"
#include "prover/model/program.h"
#include "prover/problem/notation.h"
#include "prover/problem/spec.h"
#include "prover/scripts/problem_model.h"
#include "prover/system/exit.h"

namespace plprove {

namespace {

/// How many solutions the problem has, by certificates; 0 if that is not known.
int certified_degree(const Problem& problem) {
    if (const std::optional<Features> features = local_features(problem)) {
        const Decision decision = decide(*features);
        if (decision.verdict != Verdict::minimal) return 0;
        return degree_of(decision).value_or(0);
    }
    const auto found = many_views::degree_on_file(notation(problem));
    return found && found->bound == "exact" && found->status == "certified" ? found->degree : 0;
}

} // namespace

std::string well_formed(std::string text, const std::string& what) {
    try {
        model::compile(model::read_model(text));
    } catch (const model::ModelError& error) {
        throw BadInput("no model can be written of " + what + ": in its text, " + error.what());
    }
    return text;
}

std::string model_of_problem(const std::string& spec) {
    const std::optional<Problem> general = parse_general_spec(spec);
    const Problem problem = general ? *general : problem_of(parse_spec(spec));
    return well_formed(problem_model(problem, certified_degree(problem)), notation(problem));
}

} // namespace plprove
