// plprove: finds certificates and writes them. What a certificate proves is decided by plcheck, not here.
#include "prover/classification/archive.h"
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

/// Input that names no problem: reported, exit status 2.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

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

/// `2394` or `#2394`.
std::size_t parse_number(std::string text, std::size_t count) {
    const std::string digits = text.substr(text.starts_with('#') ? 1 : 0);
    if (digits.empty() || digits.size() > 6 ||
        digits.find_first_not_of("0123456789") != std::string::npos || std::stoul(digits) >= count)
        throw InputError("'" + text + "' is no number of a label class; expected 0 to " +
                         std::to_string(count - 1));
    return std::stoul(digits);
}

void prove_problem(const std::string& id, const std::string& path) {
    const std::vector<Signature> classes = label_classes();
    const std::size_t number = parse_number(id, classes.size());
    deliver(path, write(certify_problem(problem_of(classes[number]), number)));
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

    std::string id;
    std::string problem_path = "-";
    CLI::App* certify = app.add_subcommand(
        "certify", "Certify one problem, with coordinates of its own, as small as they get");
    certify->add_option("ID", id, "the authors' number of the problem, such as 2394")->required();
    certify->add_option("-o,--output", problem_path, "the file to write, - for standard output")
        ->capture_default_str();

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : exit_usage;
    }
    if (*classification) prove_classification(path);
    if (*certify) prove_problem(id, problem_path);
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const InputError& error) {
        std::cerr << "plprove: " << error.what() << '\n';
        return exit_input;
    } catch (const std::exception& error) {
        std::cerr << "plprove: " << error.what() << '\n';
        return exit_failure;
    }
}
