// plprove: finds certificates and writes them. What a certificate proves is decided by plcheck, not
// here.
#include "prover/cli/program.h"

#include "prover/cli/arguments.h"
#include "prover/cli/catalogue_commands.h"
#include "prover/cli/degree_commands.h"
#include "prover/cli/degrees_command.h"
#include "prover/cli/generate_command.h"
#include "prover/cli/group_command.h"
#include "prover/cli/model_command.h"
#include "prover/cli/problem_commands.h"
#include "prover/cli/recommend_command.h"
#include "prover/cli/solve_command.h"
#include "prover/cli/template_command.h"
#include "prover/cli/written_model.h"
#include "prover/format/version.h"
#include "prover/minimal/classification_file.h"
#include "prover/minimal/problem_file.h"
#include "prover/scripts/equation_scripts.h"
#include "prover/system/atomic_file.h"
#include "prover/system/exit.h"
#include "prover/system/progress.h"
#include "prover/system/ranks.h"

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <vector>

namespace plprove {

namespace {

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
                     "print a Macaulay2 script with the equations of this problem, as a model has "
                     "them (docs/models.md)")
        ->type_name("PROBLEM");
    catalogue.app
        ->add_option("--julia", request->julia,
                     "print a script for HomotopyContinuation.jl with them")
        ->type_name("PROBLEM");
    return {catalogue.app, [request, catalogue] {
                if (!request->macaulay2.empty())
                    deliver("-", macaulay2_script(model_of_problem(request->macaulay2)));
                if (!request->julia.empty())
                    deliver("-", julia_script(model_of_problem(request->julia)));
                return catalogue.run();
            }};
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
    return {add_problem_command(program, deliver),
            add_show_command(program, deliver),
            add_list_command(program, deliver),
            add_certify_command(program, deliver),
            classification_command(program),
            add_degree_command(program, deliver, compute),
            add_group_command(program, deliver),
            add_degrees_command(program, compute),
            add_collect_command(program),
            add_model_command(program, deliver),
            add_template_command(program, deliver),
            add_generate_command(program, deliver),
            add_solve_command(program, deliver),
            add_start_command(program, deliver),
            add_recommend_command(program, deliver),
            export_command(program)};
}

int run(int argc, char** argv, const ComputeDegree& compute) {
    CLI::App program(summary, "plprove");
    const std::vector<Command> commands = set_up(program, compute);
    const std::vector<std::string> words = words_of(argc, argv);
    try {
        program.parse(for_cli11(program, words));
    } catch (const CLI::ParseError& error) {
        leave_words_to_rank_0(error.get_exit_code() == 0 ? 0 : exit_usage);
        if (error.get_exit_code() != 0) {
            std::cerr << "plprove: " << usage_advice(program, words, error) << '\n';
            return exit_usage;
        }
        program.exit(error);
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

int run_plprove(int argc, char** argv, const ComputeDegree& compute) {
    std::signal(SIGXFSZ, SIG_IGN); // a file beyond the user's limit is a failed write
    try {
        return run(argc, argv, compute);
    } catch (const NotationError& error) {
        std::cerr << "plprove: not a problem: " << error.what()
                  << "\n  `plprove problem --help` explains how to name a problem\n";
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
