#include "prover/cli/bounds_command.h"

#include "prover/solver/templates/template.h"
#include "prover/system/progress.h"

#include <iostream>
#include <memory>
#include <sstream>

namespace plprove {

namespace {

/// A line of the table for people: how many solutions a type has at most.
std::string line_of(const templates::Registration& type, int classes,
                    const std::optional<templates::Template>& found) {
    std::ostringstream text;
    text << templates::describe(type) << ": " << classes << " label classes, ";
    if (found)
        text << "at most " << found->basis.size() << " cameras; frame "
             << templates::name(found->frame) << ", minor of size "
             << templates::RotationRing(found->frame).monomials(found->degree).size() -
                    found->basis.size();
    else
        text << "no template found";
    return text.str() + '\n';
}

void prove_bounds(const std::string& path, bool table, const Deliver& deliver) {
    auto types = templates::registration_types(label_classes());
    types.emplace(templates::relative_pose(), 0);
    std::vector<templates::Template> templates;
    std::string lines;
    {
        ProgressLine progress("templates of registration problems", types.size());
        std::size_t done = 0;
        for (const auto& [type, classes] : types) {
            auto found = templates::best_template(type);
            lines += line_of(type, classes, found);
            if (found) templates.push_back(std::move(*found));
            progress.show(++done);
        }
    }
    deliver(path, templates::write(templates));
    if (table) std::cerr << lines;
    if (path != "-")
        std::cerr << "wrote " << path << ": templates of " << templates.size() << " of "
                  << types.size() << " types, the relative pose among them\n";
}

} // namespace

Command add_bounds_command(CLI::App& program, Deliver deliver) {
    struct Request {
        std::string path = "certs/bounds.plc";
        bool table = false;
    };
    auto request = std::make_shared<Request>();
    CLI::App* app = program.add_subcommand(
        "bounds", "Write the file of upper bounds on how many solutions problems have");
    app->add_option("-o,--output", request->path, "the file to write, - for standard output")
        ->capture_default_str();
    app->add_flag("--table", request->table, "also list the types, on standard error");
    app->footer(
        "The bounds are of extensions of the five-point problem: a template for each type of\n"
        "registration of the third camera.\n\n"
        "Examples:\n"
        "  plprove bounds -o bounds.plc\n"
        "  plcheck certs/classification.plc bounds.plc");
    return {app, [request, deliver = std::move(deliver)] {
                prove_bounds(request->path, request->table, deliver);
                return 0;
            }};
}

} // namespace plprove
