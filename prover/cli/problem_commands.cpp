#include "prover/cli/problem_commands.h"

#include "prover/cli/general_commands.h"
#include "prover/cli/general_report.h"
#include "prover/cli/problem_report.h"
#include "prover/cli/sections.h"
#include "prover/drawing/drawing.h"
#include "prover/minimal/problem_file.h"
#include "prover/problem/names.h"
#include "prover/problem/spec.h"
#include "prover/system/exit.h"
#include "prover/system/words.h"

#include <sstream>

namespace plprove {

namespace {

constexpr const char* problem_help =
    "a problem: notation ('2*Pa/Pa/Pa + P/P/P'), the authors' number (2394), a name (Chicago), a "
    "signature of 27 numbers, or the authors' Macaulay2 encoding";

const std::string problem_examples =
    "Examples:\n"
    "  plprove problem '2*Pa/Pa/Pa + P/P/P'  notation: what views 1/2/3 see of each feature\n"
    "  plprove problem '-/P/P + 3*P/P/P + P/-/P'\n"
    "                                        P a point, a b c lines, - nothing\n"
    "  plprove problem 2394                  the authors' number\n"
    "  plprove problem Chicago               a name; all names are listed below\n"
    "  plprove problem '0 0 0 0 0 0 2 1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0'\n"
    "                                        a signature\n"
    "  plprove problem '{{0,1},{{{1,1},{1,1,1}},{{1,1},{1,1,1}},{{1,1},{1,1,1}}}}'\n"
    "                                        Macaulay2: lines 0 and 1 pass through points 0 and\n"
    "                                        1; each view sees lines {1,1} and points {1,1,1}\n"
    "  plprove problem 'projective: 3*PL/PL/PL + 4*P/P/P'\n"
    "                                        uncalibrated cameras; L a line of three points.\n"
    "                                        docs/notation.md says what else may be written\n"
    "  plprove problem '(5,0,{{0,1,3},{0,2,4},{1,2}})'\n"
    "                                        PLMP: 5 points, 0 free lines, points of each line\n"
    "  plprove problem '3*P/P/P + P/P/a' --certificate mine.plc\n"
    "  plcheck mine.plc\n\n"
    "Names: ";

struct ProblemRequest {
    std::string spec;
    std::string certificate;
    bool json = false;
};

/// The command that certifies the degree, from the certificate alone: there is one in three views.
std::string how_to_check(const ProblemRequest& request, const std::string& notation, int views,
                         std::optional<int> degree) {
    if (request.certificate.empty() || request.certificate == "-" || views != 3 || !degree)
        return {};
    std::ostringstream out;
    section(out, "check") << "plcheck --expect '" << notation << "' --degree " << *degree << ' '
                          << request.certificate << '\n';
    return out.str();
}

void decide_general_problem(const ProblemRequest& request, const Problem& problem,
                            const Deliver& deliver) {
    if (request.certificate.empty()) {
        const auto found = try_to_certify(problem);
        if (const auto* open = std::get_if<Undecided>(&found))
            return deliver("-", request.json ? json_report(*open) : text_report(*open));
    }
    const ProblemRecord certificate = certify(problem);
    if (!request.certificate.empty())
        deliver(request.certificate, write(std::span(&certificate, 1)));
    deliver("-", request.json ? json_report(certificate)
                              : text_report(certificate) +
                                    how_to_check(request, notation(certificate.problem),
                                                 problem.views, degree_of_features(certificate)));
}

void decide_problem(const ProblemRequest& request, const Deliver& deliver) {
    if (const std::optional<Problem> problem = parse_general_spec(request.spec))
        return decide_general_problem(request, *problem, deliver);
    const Features problem = parse_spec(request.spec);
    const ProblemReport report = report_on(problem);
    // The certificate first: where it fails, nothing is said that it was to prove.
    if (!request.certificate.empty()) deliver(request.certificate, write(certify_problem(problem)));
    deliver("-", request.json ? json_report(report)
                              : text_report(report) + how_to_check(request, notation(problem),
                                                                   problem.front().views(),
                                                                   degree_of(report.decision)));
}

struct CertifyRequest {
    std::string spec;
    std::string family;
    std::string list;
    std::string path = "-";
};

std::string certificate_text(const CertifyRequest& request) {
    if (!request.family.empty()) {
        const CameraModel& family = *family_named(request.family);
        return write(certify_family(family), family);
    }
    if (const std::optional<Problem> problem = parse_general_spec(request.spec)) {
        const ProblemRecord certificate = certify(*problem);
        return write(std::span(&certificate, 1));
    }
    return write(certify_problem(parse_spec(request.spec)));
}

/// Writes what is certified, over what was there, and says which problems are open. Status 1 if any
/// is.
int certify_list(const CertifyRequest& request, const Deliver& deliver) {
    const auto [certificates, open] = certify_listed(request.list);
    deliver(request.path, write(certificates));
    for (const std::string& what : open)
        std::cerr << "plprove: " << what << '\n';
    if (open.empty()) return 0;
    std::cerr << "plprove: " << open.size() << " of " << certificates.size() + open.size()
              << " problems are open; the file has the others. Please report them\n";
    return exit_failure;
}

struct ShowRequest {
    std::string spec;
    std::string svg;
    std::string tikz;
    std::string highlight;
};

void show(const ShowRequest& request, const Deliver& deliver) {
    if (parse_general_spec(request.spec))
        throw BadInput(
            "problems with shared lines, with more than three views or with cameras that "
            "are not calibrated are not drawn: `plprove problem` says what is known of "
            "them");
    const Features problem = parse_spec(request.spec);
    Highlight highlight = Highlight::nothing;
    if (!request.highlight.empty()) {
        if (!has_five_points(problem))
            throw BadInput("no two views of " + notation(problem) +
                           " share exactly five points: leave --highlight out");
        if (request.svg.empty() && request.tikz.empty())
            throw BadInput(
                "the drawing for a terminal is not in colour: add --svg FILE or --tikz FILE");
        highlight = Highlight::five_points;
    }
    if (!request.svg.empty()) deliver(request.svg, draw_svg(problem, highlight));
    if (!request.tikz.empty()) deliver(request.tikz, draw_tikz(problem, highlight));
    if (request.svg.empty() && request.tikz.empty()) deliver("-", draw_text(problem));
}

} // namespace

Command add_problem_command(CLI::App& program, Deliver deliver) {
    const auto request = std::make_shared<ProblemRequest>();
    CLI::App* app = program.add_subcommand(
        "problem", "Say whether a problem is minimal, why, and what is known of it");
    app->add_option("PROBLEM", request->spec, problem_help)->required();
    app->add_flag("--json", request->json, "print JSON");
    app->add_option("--certificate", request->certificate,
                    "also write a certificate of the verdict to this file");
    app->footer(problem_examples + wrapped(list_of_names(), 80));
    return {app, [request, deliver = std::move(deliver)] {
                decide_problem(*request, deliver);
                return 0;
            }};
}

Command add_certify_command(CLI::App& program, Deliver deliver) {
    auto request = std::make_shared<CertifyRequest>();
    CLI::App* app = program.add_subcommand(
        "certify", "Write a certificate of the verdict on one problem, or on many");
    CLI::Option* const one = app->add_option("PROBLEM", request->spec, problem_help);
    CLI::Option* const family = add_family_option(
        *app, request->family,
        "instead of PROBLEM: all balanced problems of a paper with complete visibility, with "
        "calibrated (plmp) or projective cameras");
    CLI::Option* const list =
        app->add_option("--list", request->list,
                        "instead of PROBLEM: the problems in this file, one a line in the notation "
                        "of docs/notation.md (- for standard input)")
            ->type_name("FILE");
    one->excludes(family)->excludes(list);
    family->excludes(list);
    app->callback([one, family, list] {
        if (one->empty() && family->empty() && list->empty())
            throw CLI::RequiredError("PROBLEM, --family or --list");
    });
    app->add_option("-o,--output", request->path, "the file to write, - for standard output")
        ->capture_default_str();
    app->footer("Examples:\n"
                "  plprove certify 2394 -o chicago.plc\n"
                "  plprove certify '3*P/P/P + P/P/a' | plcheck /dev/stdin\n"
                "  plprove certify --family plmp -o plmp.plc\n"
                "  plprove certify --list mine.txt -o mine.plc");
    return {app, [request, deliver = std::move(deliver)] {
                if (!request->list.empty()) return certify_list(*request, deliver);
                deliver(request->path, certificate_text(*request));
                return 0;
            }};
}

Command add_show_command(CLI::App& program, Deliver deliver) {
    auto request = std::make_shared<ShowRequest>();
    CLI::App* app =
        program.add_subcommand("show", "Draw a problem: what each view sees, side by side");
    app->add_option("PROBLEM", request->spec, problem_help)->required();
    app->add_option("--svg", request->svg,
                    "write the picture to this file (- for standard output), instead of drawing "
                    "in the terminal")
        ->type_name("FILE");
    app->add_option("--tikz", request->tikz, "write it for LaTeX, likewise")->type_name("FILE");
    app->add_option("--highlight", request->highlight,
                    "five-point: in red, five points that two views share, which fix their "
                    "relative pose")
        ->type_name("WHAT")
        ->check(CLI::IsMember({"five-point"}));
    app->footer(
        "Examples:\n"
        "  plprove show '2*Pa/Pa/Pa + P/P/P'\n"
        "  plprove show Chicago --svg chicago.svg\n"
        "  plprove show P3P+five-point --highlight five-point --tikz p3p.tex\n"
        "                                       for LaTeX; the file says how to include it");
    return {app, [request, deliver = std::move(deliver)] {
                show(*request, deliver);
                return 0;
            }};
}

} // namespace plprove
