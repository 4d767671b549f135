#include "prover/cli/model_command.h"

#include "prover/cli/sections.h"
#include "prover/format/certificate_text.h"
#include "prover/model/certificate.h"
#include "prover/scripts/equation_scripts.h"
#include "prover/system/exit.h"
#include "prover/system/progress.h"
#include "prover/system/words.h"

#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace plprove {

namespace {

struct ModelRequest {
    std::string file;
    std::string output;
    bool json = false;
    bool macaulay2 = false, julia = false;
};

/// The text of a model, and the comments before its first statement.
struct Source {
    std::string text;
    std::vector<std::string> comments;
};

std::string text_of(std::istream& in, const std::string& name) {
    std::string text;
    for (std::string line; std::getline(in, line) && text.size() <= model::largest_text;)
        text += line + '\n';
    if (in.bad()) throw BadInput("cannot read " + name + ": is it a file?");
    return text;
}

Source read_source(const std::string& path) {
    Source source;
    if (path == "-") {
        source.text = text_of(std::cin, "standard input");
    } else {
        std::ifstream file(path);
        if (!file) throw BadInput("cannot read " + path + ": name a file with a model");
        source.text = text_of(file, path);
    }
    std::istringstream lines(source.text);
    for (std::string line; std::getline(lines, line) && line.starts_with('#');)
        if (!has_control_character(line))
            source.comments.push_back(
                line.substr(std::min(line.find_first_not_of("# "), line.size())));
    return source;
}

/// What `work` does with the text of this file; says in which file a model is not well-formed.
template <class Work>
auto in_file(const std::string& path, const Work& work) {
    try {
        return work();
    } catch (const model::ModelError& error) {
        throw BadInput((path == "-" ? "standard input" : path) + ", " + error.what());
    }
}

model::Study studied(const std::string& text) {
    ProgressLine line("looking for solutions, then for all", 0);
    line.show(0);
    return model::study(text);
}

/// How many solutions there are at most; 0 if that is not known.
std::size_t at_most(const model::Study& study) {
    return study.elimination ? study.elimination->basis.size() : 0;
}

std::size_t at_least(const model::Study& study) {
    return study.fibre ? study.fibre->count() : 0;
}

std::string claim_report(const model::Study& study) {
    const auto known = [](std::size_t count) {
        return count == 0 ? std::string("unknown") : std::to_string(count);
    };
    std::string text = study.model.claimed == 0 ? "none" : std::to_string(study.model.claimed);
    text = "claimed " + text + ", at least " + known(at_least(study)) + ", at most " +
           known(at_most(study));
    if (at_least(study) > 0 && at_least(study) == at_most(study))
        text += ": exactly " + std::to_string(at_most(study));
    return text;
}

std::string text_report(const model::Study& study, const Source& source,
                        const std::string& output) {
    std::ostringstream out;
    section(out, "model") << study.model.name << '\n';
    for (const std::string& comment : source.comments)
        section(out, "") << comment << '\n';
    section(out, "size") << study.program.data << " data, " << study.program.unknowns
                         << " unknowns, " << study.program.equations.size() << " equations\n";
    section(out, "verdict") << (study.fibre ? "minimal" : "not shown to be minimal: ")
                            << study.no_fibre << '\n';
    section(out, "solutions") << claim_report(study) << '\n';
    if (!study.no_elimination.empty())
        section(out, "upper bound") << "none: " << study.no_elimination << '\n';
    section(out, "certificate");
    if (output.empty())
        out << "none: -o FILE writes one\n";
    else
        out << output << ": certified once plcheck accepts it\n";
    return out.str();
}

std::string json_report(const model::Study& study, const Source& source) {
    const auto number = [](std::size_t count) {
        return count == 0 ? nlohmann::ordered_json() : nlohmann::ordered_json(count);
    };
    nlohmann::ordered_json report = {
        {"model", study.model.name},
        {"comments", source.comments},
        {"data", study.program.data},
        {"unknowns", study.program.unknowns},
        {"equations", study.program.equations.size()},
        {"minimal", study.fibre ? nlohmann::ordered_json(true) : nlohmann::ordered_json()},
        {"claimed", number(static_cast<std::size_t>(study.model.claimed))},
        {"at_least", number(at_least(study))},
        {"at_most", number(at_most(study))}};
    if (!study.no_fibre.empty()) report["no_fibre"] = study.no_fibre;
    if (!study.no_elimination.empty()) report["no_elimination"] = study.no_elimination;
    return report.dump(2) + '\n';
}

/// Prints a script, and looks for nothing.
int write_script(const ModelRequest& request, const Deliver& deliver) {
    const Source source = read_source(request.file);
    const std::string script = in_file(request.file, [&] {
        const model::Model model = model::read_model(source.text);
        const model::Program program = model::compile(model);
        return request.julia ? julia_script(model, program) : macaulay2_script(model, program);
    });
    deliver(request.output.empty() ? "-" : request.output, script);
    return 0;
}

int prove_model(const ModelRequest& request, const Deliver& deliver) {
    if (request.macaulay2 || request.julia) return write_script(request, deliver);
    const Source source = read_source(request.file);
    const model::Study study = in_file(request.file, [&] { return studied(source.text); });
    const bool nothing = !study.fibre && !study.elimination;
    if (!request.output.empty()) {
        if (nothing)
            throw BadInput("nothing was found to certify: " + study.no_fibre + "; " +
                           study.no_elimination);
        deliver(request.output, model::write(study));
    }
    if (request.output != "-")
        deliver("-", request.json ? json_report(study, source)
                                  : text_report(study, source, request.output));
    return 0;
}

} // namespace

Command add_model_command(CLI::App& program, Deliver deliver) {
    auto request = std::make_shared<ModelRequest>();
    CLI::App* app = program.add_subcommand(
        "model", "How many solutions has a problem that is given by equations?");
    app->add_option("FILE", request->file, "the text of a model, - for standard input")->required();
    app->add_option("-o,--output", request->output,
                    "write a certificate to this file, - for standard output")
        ->type_name("FILE");
    CLI::Option* json = app->add_flag("--json", request->json, "print the report as JSON");
    CLI::Option* macaulay2 =
        app->add_flag("--macaulay2", request->macaulay2,
                      "print a Macaulay2 script with the equations, and nothing else")
            ->excludes(json);
    app->add_flag("--julia", request->julia, "print a script for HomotopyContinuation.jl")
        ->excludes(json)
        ->excludes(macaulay2);
    app->footer(
        "A model is a text with data, unknowns and equations: docs/models.md explains it, and "
        "models/ has\nproblems of the literature.\n\n"
        "Examples:\n"
        "  plprove model models/p3p.model              how many solutions?\n"
        "  plprove model models/p3p.model -o p3p.plc   write a certificate ...\n"
        "  plcheck p3p.plc                             ... and replay it\n"
        "  plprove model models/p3p.model --macaulay2  another program counts the solutions");
    return {app,
            [request, deliver = std::move(deliver)] { return prove_model(*request, deliver); }};
}

} // namespace plprove
