// plprove: finds certificates and writes them. What a certificate proves is decided by plcheck, not
// here.
#include "prover/cli/program.h"

#include "prover/bundle/bundle.h"
#include "prover/classification/classification_file.h"
#include "prover/classification/problem_certificate.h"
#include "prover/cli/bounds_command.h"
#include "prover/cli/catalogue_commands.h"
#include "prover/cli/degree_commands.h"
#include "prover/cli/describe.h"
#include "prover/cli/degrees_command.h"
#include "prover/cli/problem_report.h"
#include "prover/drawing/drawing.h"
#include "prover/format/version.h"
#include "prover/problem/spec.h"
#include "prover/scripts/scripts.h"
#include "prover/system/atomic_file.h"
#include "prover/system/exit.h"
#include "prover/system/progress.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <vector>

namespace plprove {

namespace {

constexpr const char* problem_help =
    "a problem: the authors' number (2394), notation ('2*Pa/Pa/Pa + P/P/P'), a signature of 27 "
    "numbers, or the authors' Macaulay2 encoding";

/// To the file, or to standard output for the name "-".
void deliver(const std::string& path, const std::string& text) {
    if (path != "-") return write_atomically(path, text);
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        throw std::system_error(errno, std::generic_category(), "cannot write to standard output");
}

void prove_classification(const std::string& path) {
    ClassificationFile file;
    {
        ProgressLine line("certifying label classes", label_classes().size());
        file = certify_classification(label_classes(), [&](std::size_t done) { line.show(done); });
    }
    deliver(path, write(file));
    if (path != "-")
        std::cerr << "wrote " << path << ": certificates of " << file.records.size()
                  << " label classes, " << file.pools.size() << " pool(s) of coordinates\n";
}

Command classification_command(CLI::App& program) {
    auto path = std::make_shared<std::string>("certs/classification.plc");
    CLI::App* app = program.add_subcommand(
        "classification", "Write certificates of all 143,494 label classes into one file");
    app->add_option("-o,--output", *path, "the file to write, - for standard output")
        ->capture_default_str();
    app->footer("Examples:\n"
                "  plprove classification -o all.plc    takes seconds\n"
                "  plcheck all.plc                      replays every certificate");
    return {app, [path] {
                prove_classification(*path);
                return 0;
            }};
}

Command certify_command(CLI::App& program) {
    struct Request {
        std::string spec;
        std::string path = "-";
    };
    auto request = std::make_shared<Request>();
    CLI::App* app =
        program.add_subcommand("certify", "Write a certificate of the verdict on one problem");
    app->add_option("PROBLEM", request->spec, problem_help)->required();
    app->add_option("-o,--output", request->path, "the file to write, - for standard output")
        ->capture_default_str();
    app->footer("Examples:\n"
                "  plprove certify 2394 -o chicago.plc\n"
                "  plprove certify '3*P/P/P + P/P/a' | plcheck /dev/stdin");
    return {app, [request] {
                deliver(request->path, write(certify_problem(parse_spec(request->spec))));
                return 0;
            }};
}

void decide_problem(const std::string& spec, bool json, const std::string& certificate) {
    const Problem problem = parse_spec(spec);
    const Decision decision = decide(problem);
    std::vector<DegreeRecord> degrees;
    if (decision.classes)
        degrees = degrees_of_class(parse_degrees(degree_lines()), label_classes(),
                                   decision.classes->label, decision.classes->constraint);
    // The certificate first: where it fails, nothing is said that it was to prove.
    if (!certificate.empty()) deliver(certificate, write(certify_problem(problem)));
    deliver("-", json ? json_report(decision, degrees) : text_report(decision, degrees));
}

Command problem_command(CLI::App& program) {
    struct Request {
        std::string spec;
        std::string certificate;
        bool json = false;
    };
    auto request = std::make_shared<Request>();
    CLI::App* app = program.add_subcommand(
        "problem", "Say whether a problem is minimal, why, and what is known of it");
    app->add_option("PROBLEM", request->spec, problem_help)->required();
    app->add_flag("--json", request->json, "print JSON");
    app->add_option("--certificate", request->certificate,
                    "also write a certificate of the verdict to this file");
    app->footer("Examples:\n"
                "  plprove problem '2*Pa/Pa/Pa + P/P/P'\n"
                "  plprove problem '#2394' --json\n"
                "  plprove problem '3*P/P/P + P/P/a' --certificate mine.plc\n"
                "  plcheck mine.plc");
    return {app, [request] {
                decide_problem(request->spec, request->json, request->certificate);
                return 0;
            }};
}

Command show_command(CLI::App& program) {
    struct Request {
        std::string spec;
        std::string svg;
    };
    auto request = std::make_shared<Request>();
    CLI::App* app =
        program.add_subcommand("show", "Draw a problem: what each view sees, side by side");
    app->add_option("PROBLEM", request->spec, problem_help)->required();
    app->add_option("--svg", request->svg,
                    "write the picture to this file (- for standard output), instead of drawing "
                    "in the terminal");
    app->footer("Examples:\n"
                "  plprove show '2*Pa/Pa/Pa + P/P/P'\n"
                "  plprove show 2394 --svg chicago.svg  for a paper");
    return {app, [request] {
                const Problem problem = parse_spec(request->spec);
                if (request->svg.empty())
                    deliver("-", draw_text(problem));
                else
                    deliver(request->svg, draw_svg(problem));
                return 0;
            }};
}

/// `export` of the catalogue, with the scripts of single problems beside it.
Command export_command(CLI::App& program) {
    struct Request {
        std::string macaulay2;
        std::string julia;
    };
    auto request = std::make_shared<Request>();
    const Command catalogue = add_export_command(program, deliver);
    catalogue.app
        ->add_option("--macaulay2", request->macaulay2,
                     "print a Macaulay2 script with the equations of this problem")
        ->type_name("PROBLEM");
    catalogue.app
        ->add_option(
            "--julia", request->julia,
            "print a script for HomotopyContinuation.jl with the equations of this problem")
        ->type_name("PROBLEM");
    return {catalogue.app, [request, catalogue] {
                if (!request->macaulay2.empty())
                    deliver("-", macaulay2_script(parse_spec(request->macaulay2)));
                if (!request->julia.empty()) deliver("-", julia_script(parse_spec(request->julia)));
                return catalogue.run();
            }};
}

struct BundleRequest {
    std::string source = ".";
    std::string path;
    bool checker = false;
};

void write_bundle(const BundleRequest& request) {
    const std::string folder =
        request.checker ? std::string("plcheck-") + software_version : bundle_folder;
    const Files files =
        request.checker
            ? checker_archive(request.source, write(certify_problem(parse_spec("2394"))))
            : bundle(request.source);
    deliver(request.path.empty() ? folder + ".tar.zst" : request.path, tar_zst(files, folder));
}

Command bundle_command(CLI::App& program) {
    auto request = std::make_shared<BundleRequest>();
    CLI::App* app = program.add_subcommand(
        "bundle",
        "Pack the certificates, the proofs and the checker's sources into one file to keep");
    app->add_option("-o,--output", request->path,
                    "the file to write, - for standard output (default: "
                    "point-line-certificates.tar.zst, or plcheck-VERSION.tar.zst)");
    app->add_flag("--checker", request->checker,
                  "pack the checker alone: its sources, the format and one certificate");
    app->add_option("--source", request->source, "the project's source folder")
        ->capture_default_str();
    app->footer("Examples:\n"
                "  plprove bundle                       in the project's source folder\n"
                "  tar -xf point-line-certificates.tar.zst\n"
                "                                       its README says how to check everything\n"
                "  plprove bundle --checker             for those who have certificates");
    return {app, [request] {
                write_bundle(*request);
                return 0;
            }};
}

/// The words of the command line, last first, as CLI11 wants them; the filter that follows
/// --classes or --also is tied to it, since it may begin with dashes of its own.
std::vector<std::string> words_of(int argc, char** argv) {
    std::vector<std::string> words;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const bool takes_filter = word == "--classes" || word == "--also";
        words.push_back(takes_filter && i + 1 < argc ? word + '=' + argv[++i] : word);
    }
    std::ranges::reverse(words);
    return words;
}

/// What to call instead of a command that has another name now; nothing if there is none.
std::optional<std::string> renamed(int argc, char** argv) {
    if (argc > 1 && std::string_view(argv[1]) == "archive")
        return "the command `archive` is called `bundle` now: run `plprove bundle`";
    return std::nullopt;
}

std::string version_text() {
    return std::string("plprove ") + software_version + ", certificate format " + format_version;
}

constexpr const char* summary =
    "Which points and lines in two or three photos fix the cameras? plprove decides, and writes "
    "certificates.\nplcheck replays them and believes nothing.";

/// Gives the program its commands, and the texts of its help.
std::vector<Command> set_up(CLI::App& program, const ComputeDegree& compute) {
    program.footer("Examples:\n"
                   "  plprove problem 'P/P/P + 4*a/a/a'    is it minimal, and why?\n"
                   "  plprove show 'P/P/P + 4*a/a/a'       what does each view see?\n"
                   "  plprove degree 2394                  how many solutions has it?\n"
                   "  plprove list --minimal --pl0p        which problems are of this family?\n"
                   "  plprove certify 2394 -o chicago.plc  write a certificate ...\n"
                   "  plcheck chicago.plc                  ... and replay it\n\n"
                   "`plprove COMMAND --help` explains a command.\n"
                   "Exit status: 0 done, 1 failed, 2 bad input, 3 wrong use.");
    program.set_version_flag("--version", version_text());
    program.require_subcommand(1);
    return {problem_command(program),
            show_command(program),
            add_list_command(program, deliver),
            certify_command(program),
            classification_command(program),
            add_bounds_command(program, deliver),
            add_degree_command(program, deliver, compute),
            add_degrees_command(program, compute),
            export_command(program),
            bundle_command(program)};
}

int run(int argc, char** argv, const ComputeDegree& compute) {
    if (const std::optional<std::string> advice = renamed(argc, argv)) {
        std::cerr << "plprove: " << *advice << '\n';
        return exit_usage;
    }
    CLI::App program(summary, "plprove");
    const std::vector<Command> commands = set_up(program, compute);
    try {
        program.parse(words_of(argc, argv));
    } catch (const CLI::ParseError& error) {
        if (program.exit(error) != 0) return exit_usage;
        if (!std::cout.flush())
            throw std::runtime_error(
                "cannot write to standard output: is it closed, or the disk full?");
        return 0;
    }
    for (const Command& command : commands)
        if (command.app->parsed()) return command.run();
    return 0;
}

} // namespace

std::string describe_plprove() {
    CLI::App program(summary, "plprove");
    set_up(program, {});
    return describe(program);
}

int run_plprove(int argc, char** argv, const ComputeDegree& compute) {
    std::signal(SIGXFSZ, SIG_IGN); // a file beyond the user's limit is a failed write
    try {
        return run(argc, argv, compute);
    } catch (const NotationError& error) {
        std::cerr << "plprove: not a problem: " << error.what() << '\n';
        return exit_input;
    } catch (const BadInput& error) {
        std::cerr << "plprove: " << error.what() << '\n';
        return exit_input;
    } catch (const std::exception& error) {
        std::cerr << "plprove: " << error.what() << '\n';
        return exit_failure;
    }
}

} // namespace plprove
