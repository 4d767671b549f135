#include "prover/cli/template_command.h"

#include "prover/cli/model_source.h"
#include "prover/cli/sections.h"
#include "prover/model/template_python.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace plprove {

namespace {

struct TemplateRequest {
    std::string file;
    std::string output = "-";
    bool json = false;
};

std::string text_report(const model::Study& study, const model::EliminationTemplate& table,
                        const std::string& output) {
    std::ostringstream out;
    section(out, "model") << study.model.name << '\n';
    section(out, "solutions") << table.basis.size() << ", complex, for generic data\n";
    section(out, "template") << table.rows.size() << " rows, " << table.columns() << " columns\n";
    section(out, "solver") << output << '\n';
    return out.str();
}

std::string json_report(const model::Study& study, const model::EliminationTemplate& table,
                        const std::string& output) {
    const nlohmann::ordered_json report = {{"model", study.model.name},
                                           {"solutions", table.basis.size()},
                                           {"rows", table.rows.size()},
                                           {"columns", table.columns()},
                                           {"solver", output}};
    return report.dump(2) + '\n';
}

int write_template(const TemplateRequest& request, const Deliver& deliver) {
    const ModelSource source = read_model_source(request.file);
    const model::Study study = in_model_file(request.file, [&] { return studied(source.text); });
    const model::EliminationTemplate table = model::make_template(study);
    deliver(request.output, model::python_module(study, table));
    if (request.output != "-")
        deliver("-", request.json ? json_report(study, table, request.output)
                                  : text_report(study, table, request.output));
    return 0;
}

} // namespace

Command add_template_command(CLI::App& program, Deliver deliver) {
    auto request = std::make_shared<TemplateRequest>();
    CLI::App* app = program.add_subcommand(
        "template", "Write a solver for a problem that is given by equations");
    app->add_option("FILE", request->file, "the text of a model, - for standard input")->required();
    CLI::Option* output = app->add_option("-o,--output", request->output,
                                          "write the solver to this file, - for standard output")
                              ->type_name("FILE");
    app->add_flag("--json", request->json, "print the report as JSON")->needs(output);
    app->footer("The solver is a Python module that needs NumPy alone. docs/models.md says how to "
                "use it.\n\n"
                "Examples:\n"
                "  plprove template models/p3p.model -o p3p.py\n"
                "  python3 -c 'import p3p; help(p3p)'");
    return {app,
            [request, deliver = std::move(deliver)] { return write_template(*request, deliver); }};
}

} // namespace plprove
