#include "prover/cli/degree_commands.h"

#include "prover/catalogue/degrees.h"
#include "prover/cli/arguments.h"
#include "prover/cli/degree_report.h"
#include "prover/cli/many_views_degree.h"
#include "prover/cli/two_view_report.h"
#include "prover/fibres/class_fibre.h"
#include "prover/problem/five_points.h"
#include "prover/problem/notation.h"
#include "prover/problem/spec.h"
#include "prover/system/exit.h"
#include "prover/system/progress.h"
#include "prover/three_views/degree_text.h"

#include <chrono>
#include <sstream>

namespace plprove {

namespace {

constexpr int largest_power = 20;

constexpr const char* degree_examples =
    "A theorem gives the degree of a problem in three calibrated views. plprove finds the "
    "solutions, and the\ncertificate shows them: plcheck replays it. In other numbers of views "
    "monodromy finds solutions. Where no theorem\nsays how many there are, it is evidence, no "
    "proof, that it finds no more.\n\n"
    "Examples:\n"
    "  plprove degree 2394                          all solutions of the Chicago problem\n"
    "  plprove degree '3*P/P/P + P/P/a' --json      for machines\n"
    "  plprove degree 2394 -o chicago.plc           with a certificate\n"
    "  plprove degree 142849 --target 300           stop once 300 solutions are found\n"
    "  plprove degree 2394 --at-least 312 -o chicago.plc\n"
    "                                               a certificate of 312 solutions, no more\n"
    "  plprove degree 2394 --fibre -o chicago.plc   ... modulo a prime, without floating point\n"
    "  plprove degree five-point -o five.plc        two views, with the help of a third\n"
    "  plprove degree 'projective: 7*P/P' -o f.plc  projective cameras, any number of views\n"
    "  plprove degree 'projective: 6*P/P/P' --at-most 1,2 -o three.plc\n"
    "                                               at most 3, as plcheck will find\n";

/// Two powers, such as `2,1`. Throws CLI::ValidationError.
many_views::Powers powers_of(const std::string& text) {
    many_views::Powers powers;
    std::istringstream stream(text);
    char comma = 0;
    const bool reads = stream >> powers.cubics >> comma >> powers.linear && stream.peek() == EOF;
    const auto fits = [](int power) { return power >= 1 && power <= largest_power; };
    if (!reads || comma != ',' || !fits(powers.cubics) || !fits(powers.linear))
        throw CLI::ValidationError("--at-most", "give two numbers from 1 to " +
                                                    std::to_string(largest_power) +
                                                    ", such as 2,1");
    return powers;
}

/// The problem's decision. Throws BadInput where it has no degree that can be computed.
Decision decided(const std::string& spec) {
    Decision decision = decide(parse_spec(spec));
    if (decision.verdict == Verdict::minimal || decision.verdict == Verdict::camera_minimal)
        return decision;
    std::string message = "only minimal and camera-minimal problems have a degree, and " +
                          notation(decision.problem) + " is neither";
    for (const std::string& reason : reasons(decision))
        message += ": " + reason;
    throw BadInput(message);
}

struct DegreeRequest {
    std::string spec;
    std::string path;
    DegreeOptions options;
    std::optional<many_views::Powers> powers; // of an upper bound, if one is asked for
    bool json = false;
};

/// Runs the engine on the class, with a line of progress on a terminal.
DegreeReport computed(const Decision& decision, std::size_t number, DegreeOptions options,
                      const ComputeDegree& compute) {
    options.degree = degree_on_file(number).value_or(0);
    DegreeReport report{decision, options, {}, 0};
    ProgressLine line("finding solutions", 0);
    options.progress = [&](const MonodromyProgress& progress) {
        line.show(static_cast<std::size_t>(progress.solutions),
                  " so far, " + std::to_string(progress.edges) + " edges");
    };
    const auto begin = std::chrono::steady_clock::now();
    report.run = options.fibre ? compute_class_fibre(number, options) : compute(number, options);
    report.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return report;
}

int find_degree_in_general(const DegreeRequest& request, const Problem& problem,
                           const Deliver& deliver) {
    if (request.options.fibre)
        throw BadInput("--fibre is for three calibrated views: `plprove group PROBLEM -o FILE` "
                       "finds fibres of others");
    if (request.powers)
        return propose_upper_bound(problem, *request.powers, request.options.seed, request.path,
                                   deliver);
    return find_many_views_degree(problem,
                                  {request.options.seed, request.options.target,
                                   request.options.at_least, request.path, request.json},
                                  deliver);
}

/// Empty if the run has no certificate.
std::string degree_file_of(const DegreeRun& run) {
    if (!run.record.empty()) return degree_file(run.record);
    return run.certificate ? write_degree_file(std::span(&*run.certificate, 1)) : std::string();
}

int find_degree(const DegreeRequest& request, const Deliver& deliver,
                const ComputeDegree& compute) {
    if (const std::optional<Problem> problem = parse_general_spec(request.spec))
        return find_degree_in_general(request, *problem, deliver);
    if (request.powers)
        throw BadInput("--at-most is for projective cameras: write `projective:` in front of the "
                       "problem");
    const Decision decision = decided(request.spec);
    const bool two_views = !decision.classes;
    if (two_views && (request.options.target > 0 || request.options.at_least > 0))
        throw BadInput(
            "a problem in two views has few solutions: leave --target and --at-least out");
    const std::size_t number = two_views ? five_point_extension() : decision.classes->constraint;
    const DegreeReport report = computed(decision, number, request.options, compute);
    if (report.run.degree < request.options.at_least)
        throw std::runtime_error("the run found only " + std::to_string(report.run.degree) +
                                 " solutions: try another --seed");
    const std::string file = degree_file_of(report.run);
    if (!request.path.empty() && file.empty())
        throw std::runtime_error(
            "the run found no certificate" +
            (report.run.notes.empty() ? "" : " (" + report.run.notes.front() + ")") +
            ": try another --seed");
    if (!request.path.empty()) deliver(request.path, file);
    if (request.path != "-" && two_views)
        deliver("-", request.json ? json_two_view_report(report) : two_view_report(report));
    if (request.path != "-" && !two_views)
        deliver("-", request.json ? json_report(report) : text_report(report));
    return report.run.degree > 0 ? 0 : exit_failure;
}

} // namespace

Command add_degree_command(CLI::App& program, Deliver deliver, ComputeDegree compute) {
    const auto request = std::make_shared<DegreeRequest>();
    CLI::App* command = program.add_subcommand(
        "degree", "Compute how many solutions a minimal problem has, with a certificate");
    command
        ->add_option("PROBLEM", request->spec, "as for `plprove problem`; plprove reduces it first")
        ->required();
    command
        ->add_option("--target", request->options.target,
                     "stop at this number of solutions (default: find all)")
        ->check(CLI::Range(1, largest_target));
    command
        ->add_option("--at-least", request->options.at_least,
                     "only write a certificate of this number of solutions: the quickest way")
        ->check(CLI::Range(1, largest_target))
        ->excludes("--target");
    command
        ->add_option_function<std::string>(
            "--at-most", [request](const std::string& text) { request->powers = powers_of(text); },
            "only write a certificate of an upper bound, for projective cameras, with "
            "these powers\n(certs/FORMAT.md, section 15; try 1,1 then 2,1 then 3,1)")
        ->type_name("CUBICS,LINEAR")
        ->excludes("--target")
        ->excludes("--at-least");
    command
        ->add_flag("--fibre", request->options.fibre,
                   "certify all solutions at once, modulo a prime: plcheck needs no floating point")
        ->excludes("--target")
        ->excludes("--at-least")
        ->excludes("--at-most");
    add_seed(*command, request->options.seed);
    command->add_flag("--json", request->json, "print JSON");
    command->add_option("-o,--output", request->path,
                        "also write the certificate to this file (- for standard output, alone)");
    command->footer(degree_examples);
    return {command, [request, deliver = std::move(deliver), compute = std::move(compute)] {
                return find_degree(*request, deliver, compute);
            }};
}

} // namespace plprove
