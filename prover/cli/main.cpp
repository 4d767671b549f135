// plprove: finds certificates and writes them. What a certificate proves is decided by plcheck, not here.
#include "prover/classification/archive.h"
#include "prover/classification/problem_certificate.h"
#include "prover/problem/spec.h"
#include "prover/cli/atomic_file.h"
#include "prover/cli/progress.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <system_error>

namespace {

using namespace plprove;

constexpr int exit_failure = 1;
constexpr int exit_input = 2;
constexpr int exit_usage = 3;

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
    const std::vector<Signature> classes = label_classes();
    Archive archive;
    {
        ProgressLine line("certifying label classes", classes.size());
        archive = certify_classification(classes, [&](std::size_t done) { line.show(done); });
    }
    deliver(path, write(archive));
    if (path != "-")
        std::cerr << "wrote " << path << ": certificates of " << archive.records.size()
                  << " label classes, " << archive.pools.size() << " pool(s) of coordinates\n";
}

void prove_problem(const std::string& spec, const std::string& path) {
    deliver(path, write(certify_problem(parse_spec(spec))));
}

int run(int argc, char** argv) {
    CLI::App app("Finds certificates for point-line minimal problems; plcheck checks them.",
                 "plprove");
    app.footer("Examples:\n"
               "  plprove classification -o all.plc   certify all 143,494 label classes\n"
               "  plprove certify 2394 -o chicago.plc certify one problem, self-contained\n"
               "  plcheck all.plc                     believe nothing, replay everything\n\n"
               "Exit status: 0 done, 1 failure, 2 bad input, 3 usage.");
    app.set_version_flag("--version", "plprove 1.0.0, certificate format 1");
    app.require_subcommand(1);

    std::string path = "certs/classification.plc";
    CLI::App* classification = app.add_subcommand(
        "classification", "Certify every label class of balanced signatures in one archive");
    classification->add_option("-o,--output", path, "the archive to write, - for standard output")
        ->capture_default_str();

    std::string spec;
    std::string problem_path = "-";
    CLI::App* certify = app.add_subcommand(
        "certify", "Certify one problem, with coordinates of its own, as small as they get");
    certify->add_option("PROBLEM", spec, problem_help)->required();
    certify->add_option("-o,--output", problem_path, "the file to write, - for standard output")
        ->capture_default_str();

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : exit_usage;
    }
    if (*classification) prove_classification(path);
    if (*certify) prove_problem(spec, problem_path);
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const NotationError& error) {
        std::cerr << "plprove: not a problem: " << error.what() << '\n';
        return exit_input;
    } catch (const std::exception& error) {
        std::cerr << "plprove: " << error.what() << '\n';
        return exit_failure;
    }
}
