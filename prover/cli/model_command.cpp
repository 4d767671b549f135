#include "prover/cli/model_command.h"

#include "prover/cli/model_source.h"
#include "prover/cli/sections.h"
#include "prover/cli/written_model.h"
#include "prover/format/certificate_text.h"
#include "prover/importers/importers.h"
#include "prover/model/certificate.h"
#include "prover/scripts/equation_scripts.h"
#include "prover/system/exit.h"
#include "prover/system/words.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace plprove {

namespace {

struct ModelRequest {
    std::string file;
    std::string problem;  ///< a model is written of it
    std::string imported; ///< a file: likewise
    std::string output;
    bool json = false;
    bool macaulay2 = false, julia = false;
    bool lift = false;
};

std::string claim_report(const model::Study& study) {
    const std::size_t claimed = static_cast<std::size_t>(study.model.claimed);
    std::string text = "claimed " + (claimed == 0 ? "none" : std::to_string(claimed));
    if (study.at_most() == std::size_t{0}) return text + ", at most 0";
    const std::string least = study.fibre ? std::to_string(study.at_least()) : "unknown";
    const std::string most = study.at_most() ? std::to_string(*study.at_most()) : "unknown";
    text += ", at least " + least + ", at most " + most;
    return least == most && study.fibre ? text + ": exactly " + most : text;
}

std::string verdict(const model::Study& study) {
    if (study.fibre) return "minimal";
    if (study.is_underdetermined()) return "not minimal: " + study.no_fibre;
    if (study.at_most() == std::size_t{0})
        return "not minimal: for generic data the equations have no solution";
    if (study.ranks.solutions > 0)
        return "conjectured not minimal, by the evidence of random ranks";
    return "not shown to be minimal: " + study.no_fibre;
}

/// What random solutions say; empty if nothing.
std::string rank_report(const model::Study& study) {
    const model::RanksSeen& seen = study.ranks;
    if (seen.solutions == 0 || study.at_most() == std::size_t{0}) return {};
    return "the Jacobian has rank " + std::to_string(seen.rank) + " of " +
           std::to_string(study.program.unknowns) + " at " +
           counted(seen.solutions, "random solution") +
           "; if it were regular for generic data, the\n            probability of that would be "
           "1e-" +
           std::to_string(seen.digits) + " at most";
}

std::string text_report(const model::Study& study, const ModelSource& source,
                        const std::string& output, bool lifted) {
    std::ostringstream out;
    section(out, "model") << study.model.name << '\n';
    for (const std::string& comment : source.comments)
        section(out, "") << comment << '\n';
    section(out, "size") << study.program.data << " data, "
                         << counted(study.program.unknowns, "unknown") << ", "
                         << counted(study.program.equations.size(), "equation") << '\n';
    section(out, "verdict") << verdict(study) << '\n';
    if (const std::string ranks = rank_report(study); !ranks.empty())
        section(out, "evidence") << ranks << '\n';
    section(out, "solutions") << claim_report(study) << '\n';
    if (!study.only_one.empty())
        section(out, "lower bound") << "one solution only: " << study.only_one
                                    << (lifted ? "" : "; --lift may find all") << '\n';
    if (!study.no_elimination.empty() && !study.at_most())
        section(out, "upper bound") << "none: " << study.no_elimination << '\n';
    section(out, "certificate");
    if (output.empty())
        out << "none: -o FILE writes one\n";
    else
        out << output << ": certified once plcheck accepts it\n";
    return out.str();
}

std::string json_report(const model::Study& study, const ModelSource& source) {
    const auto number = [](std::size_t count) {
        return count == 0 ? nlohmann::ordered_json() : nlohmann::ordered_json(count);
    };
    nlohmann::ordered_json report = {
        {"model", study.model.name},
        {"comments", source.comments},
        {"data", study.program.data},
        {"unknowns", study.program.unknowns},
        {"equations", study.program.equations.size()},
        {"minimal", study.fibre                         ? nlohmann::ordered_json(true)
                    : study.at_most() == std::size_t{0} ? nlohmann::ordered_json(false)
                                                        : nlohmann::ordered_json()},
        {"claimed", number(static_cast<std::size_t>(study.model.claimed))},
        {"at_least", number(study.at_least())},
        {"at_most", study.at_most() ? nlohmann::ordered_json(*study.at_most()) : nullptr}};
    if (study.ranks.solutions > 0)
        report["evidence"] = {{"solutions", study.ranks.solutions},
                              {"rank", study.ranks.rank},
                              {"regular_rank", study.program.unknowns},
                              {"error_probability_digits", study.ranks.digits}};
    if (!study.no_fibre.empty()) report["no_fibre"] = study.no_fibre;
    if (!study.only_one.empty()) report["only_one"] = study.only_one;
    if (!study.no_elimination.empty()) report["no_elimination"] = study.no_elimination;
    return report.dump(2) + '\n';
}

/// Prints a script, and looks for nothing.
int write_script(const ModelRequest& request, const Deliver& deliver) {
    const ModelSource source = read_model_source(request.file);
    const std::string script = in_model_file(request.file, [&] {
        return request.julia ? julia_script(source.text) : macaulay2_script(source.text);
    });
    deliver(request.output.empty() ? "-" : request.output, script);
    return 0;
}

/// Writes the text of a model, which is well-formed.
int write_model(const ModelRequest& request, const Deliver& deliver) {
    const std::string text =
        request.imported.empty()
            ? model_of_problem(request.problem)
            : in_model_file(request.imported, [&] {
                  const std::string program = read_model_source(request.imported).text;
                  return well_formed(importers::import_program(program, request.imported),
                                     request.imported);
              });
    deliver(request.output.empty() ? "-" : request.output, text);
    return 0;
}

int prove_model(const ModelRequest& request, const Deliver& deliver) {
    if (!request.problem.empty() || !request.imported.empty()) return write_model(request, deliver);
    if (request.macaulay2 || request.julia) return write_script(request, deliver);
    const ModelSource source = read_model_source(request.file);
    const model::Study study = in_model_file(request.file, [&] {
        return studied(source.text, request.lift ? Fibres::by_lifting : Fibres::by_basis);
    });
    if (!request.output.empty()) deliver(request.output, model::write(study));
    if (request.output != "-")
        deliver("-", request.json ? json_report(study, source)
                                  : text_report(study, source, request.output, request.lift));
    return 0;
}

} // namespace

Command add_model_command(CLI::App& program, Deliver deliver) {
    auto request = std::make_shared<ModelRequest>();
    CLI::App* app = program.add_subcommand(
        "model", "How many solutions has a problem that is given by equations?");
    CLI::Option* file =
        app->add_option("FILE", request->file, "the text of a model, - for standard input");
    CLI::Option* from = app->add_option("--from", request->problem,
                                        "instead of FILE: write this point-line problem as a "
                                        "model (docs/notation.md), and prove nothing")
                            ->type_name("PROBLEM")
                            ->excludes(file);
    CLI::Option* import =
        app->add_option("--import", request->imported,
                        "instead of FILE: write the equations of this program for Macaulay2, "
                        "HomotopyContinuation.jl or Matlab as a model, and prove nothing")
            ->type_name("PROGRAM")
            ->excludes(file)
            ->excludes(from);
    app->callback([file, from, import] {
        if (file->empty() && from->empty() && import->empty())
            throw CLI::RequiredError("FILE, --from or --import");
    });
    app->add_option("-o,--output", request->output,
                    "write a certificate (or the model) to this file, - for standard output")
        ->type_name("FILE");
    CLI::Option* json = app->add_flag("--json", request->json, "print the report as JSON")
                            ->excludes(from)
                            ->excludes(import);
    CLI::Option* macaulay2 =
        app->add_flag("--macaulay2", request->macaulay2,
                      "print a Macaulay2 script with the equations, and nothing else")
            ->excludes(json)
            ->excludes(from)
            ->excludes(import);
    CLI::Option* julia =
        app->add_flag("--julia", request->julia, "print a script for HomotopyContinuation.jl")
            ->excludes(json)
            ->excludes(from)
            ->excludes(import)
            ->excludes(macaulay2);
    app->add_flag("--lift", request->lift,
                  "find solutions by paths, to many digits: where they are too many for a Gröbner "
                  "basis")
        ->excludes(from)
        ->excludes(import)
        ->excludes(macaulay2)
        ->excludes(julia);
    app->footer(
        "A model is a text with data, unknowns and equations: docs/models.md explains it, and "
        "models/ has\nproblems of the literature.\n\n"
        "Examples:\n"
        "  plprove model models/p3p.model              how many solutions?\n"
        "  plprove model models/p3p.model -o p3p.plc   write a certificate ...\n"
        "  plcheck p3p.plc                             ... and replay it\n"
        "  plprove model models/p3p.model --macaulay2  another program counts the solutions\n"
        "  plprove model --from 'upright: 3*P/P' -o upright.model\n"
        "                                              a problem of points and lines as a model\n"
        "  plprove model --import mine.m2 -o mine.model\n"
        "                                              equations for Macaulay2 as a model");
    return {app,
            [request, deliver = std::move(deliver)] { return prove_model(*request, deliver); }};
}

} // namespace plprove
