#include "prover/cli/general_commands.h"

#include "prover/system/progress.h"

#include <vector>

namespace plprove {

general::Family family_named(const std::string& name) {
    return name == "plmp" ? general::Family::plmp : general::Family::projective;
}

std::vector<general::Certificate> certify_family(general::Family family) {
    const std::vector<general::Problem> problems = general::family_problems(family);
    ProgressLine line("certifying problems", problems.size());
    std::vector<general::Certificate> certificates;
    for (const general::Problem& problem : problems) {
        certificates.push_back(general::certify(problem));
        line.show(certificates.size());
    }
    return certificates;
}

CLI::Option* add_family_option(CLI::App& app, std::string& family, const std::string& help) {
    const std::vector<std::string> names(std::begin(family_names), std::end(family_names));
    return app.add_option("--family", family, help)->type_name("NAME")->check(CLI::IsMember(names));
}

} // namespace plprove
