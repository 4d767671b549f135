#include "prover/cli/group_command.h"

#include "prover/cli/arguments.h"
#include "prover/cli/problem_report.h"
#include "prover/cli/sections.h"
#include "prover/fibres/group.h"
#include "prover/problem/notation.h"
#include "prover/problem/spec.h"
#include "prover/system/exit.h"
#include "prover/system/progress.h"
#include "prover/three_views/degree_text.h"

#include <nlohmann/json.hpp>
#include <sstream>

namespace plprove {

namespace {

constexpr const char* group_examples =
    "Move the images around a loop: the solutions come back in another order. These permutations\n"
    "are the monodromy group. If it contains all even ones, the problem does not decompose into\n"
    "smaller ones. plprove computes all solutions modulo a prime, for random images: the factors\n"
    "of their polynomial are as long as the cycles of a permutation in the group. plcheck\n"
    "certifies the group by them and by the degree (docs/groups.md).\n\n"
    "Examples:\n"
    "  plprove group 2394 -o chicago.plc            takes two minutes\n"
    "  plprove group '3*P/P/P + a/a/a' --json       for machines\n"
    "  plcheck --expect '2*Pa/Pa/Pa + P/P/P' --group S312 certs/classification.plc chicago.plc\n";

struct GroupRequest {
    std::string spec;
    std::string path;
    GroupOptions options;
    bool json = false;
};

struct Asked {
    Decision decision;
    std::size_t number = 0; // of the label class that has the problem's equations
    int degree = 0;
};

/// Throws BadInput where there is no such class, or no cycle to look for.
Asked asked(const std::string& spec) {
    Asked result{decide(parse_spec(spec)), 0, 0};
    const std::string name = notation(result.decision.problem);
    const std::optional<int> degree = degree_of(result.decision);
    if (!degree || !result.decision.classes)
        throw BadInput(name + " is not minimal in three calibrated views: give a problem that is");
    result.number = result.decision.classes->constraint;
    result.degree = *degree;
    if (!has_cycle_length(result.degree))
        throw BadInput(name + " has " + std::to_string(result.degree) +
                       " solutions: too few for this way to find their group; give a problem with "
                       "at least 8");
    return result;
}

std::string lengths_in(const std::vector<int>& cycle_type) {
    std::string words;
    for (const int length : cycle_type)
        words += (words.empty() ? "" : " ") + std::to_string(length);
    return words;
}

std::string text_report(const Asked& asked, const GroupSearch& found) {
    std::ostringstream out;
    section(out, "problem") << notation(asked.decision.problem) << '\n';
    section(out, "degree") << asked.degree << ", by theorem\n";
    section(out, "group");
    if (found.looks_smaller())
        out << "smaller than A" << asked.degree
            << ", by evidence: no permutation has a cycle longer than " << asked.degree / 2 << '\n';
    else if (found.group().empty())
        out << "not known: no permutation has a cycle of a prime length l with d/2 < l < d - 2\n";
    else
        out << found.group() << ": certified once plcheck accepts it\n";
    for (const std::vector<int>& cycle_type : found.cycle_types)
        section(out, "cycles") << lengths_in(cycle_type) << '\n';
    return out.str();
}

std::string json_report(const Asked& asked, const GroupSearch& found) {
    const nlohmann::ordered_json json = {{"problem", notation(asked.decision.problem)},
                                         {"number", asked.decision.classes->label},
                                         {"constraint_class", asked.number},
                                         {"degree", asked.degree},
                                         {"group", found.group()},
                                         {"looks_smaller", found.looks_smaller()},
                                         {"cycle_types", found.cycle_types}};
    return json.dump(2) + "\n";
}

/// Looks for the group, with a line of progress on a terminal.
GroupSearch searched(const Asked& problem, GroupOptions options) {
    ProgressLine line("computing fibres", 0);
    options.progress = [&](int fibres, long bits) {
        line.show(static_cast<std::size_t>(fibres),
                  " so far, the next one to " + std::to_string(bits) + " bits");
    };
    return find_group(problem.number, problem.degree, options);
}

int find_group_of(const GroupRequest& request, const Deliver& deliver) {
    const Asked problem = asked(request.spec);
    const GroupSearch found = searched(problem, request.options);
    if (!request.path.empty() && !found.records.empty())
        deliver(request.path, degree_file(found.records));
    if (request.path != "-")
        deliver("-", request.json ? json_report(problem, found) : text_report(problem, found));
    return found.group().empty() ? exit_failure : 0;
}

} // namespace

Command add_group_command(CLI::App& program, Deliver deliver) {
    const auto request = std::make_shared<GroupRequest>();
    CLI::App* command = program.add_subcommand(
        "group", "Find how the solutions of a minimal problem are permuted, with a certificate");
    command
        ->add_option("PROBLEM", request->spec,
                     "as for `plprove problem`, in three calibrated views")
        ->required();
    command
        ->add_option("--fibres", request->options.fibres,
                     "give up after so many sets of images (default: 30)")
        ->check(CLI::Range(1, 10'000));
    add_seed(*command, request->options.seed);
    command->add_flag("--json", request->json, "print JSON");
    command->add_option("-o,--output", request->path,
                        "also write the certificate to this file (- for standard output, alone)");
    command->footer(group_examples);
    return {command,
            [request, deliver = std::move(deliver)] { return find_group_of(*request, deliver); }};
}

} // namespace plprove
