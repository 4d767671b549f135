// The command plcheck: reads files, has the core replay them, prints the report.
#include "checker/degrees/krawczyk.h"
#include "checker/report/report.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iostream>

using namespace checker;
static constexpr std::string_view help = R"(usage:
    plcheck classification.plc         derive every count of the classification from certificates
    plcheck problem.plc                replay the verdict on one problem
    plcheck degrees.plc                prove that classes have at least so many solutions
    plcheck classification.plc bounds.plc degrees.plc
                                       and compare the camera-degrees with the paper
    plcheck classification.plc SHA256SUMS
                                       and compare the files with the digests of a list
    plcheck --json classification.plc  the same for a program
    plcheck --errata classification.plc
                                       each count that differs from the paper, with a witness
    plcheck --version                  the format, and what has to be trusted
Certificates are as certs/FORMAT.md says; none is believed. Exit status: 0 every certificate holds,
1 one is refused, 2 a file cannot be read or parsed, or the report not be written, 3 usage.
)";

static constexpr std::string_view version = R"(plcheck, certificate format 1
To be trusted: the sources in checker/, the C++ compiler and its standard library, GMP, the machine;
certs/FORMAT.md and proofs/ for what follows. Not trusted: the files and the program behind them.
)";
static constexpr std::string_view with_arb = "For degree files, to be trusted, too: Arb, FLINT.\n";
static constexpr std::string_view without_arb = "Built without Arb: degree files are refused.\n";

/// Says what is wrong, and returns the status.
static int fail(const std::string& what, int status) {
    std::cerr << "plcheck: " << what << '\n';
    return status;
}

/// Writes the text, and returns the status unless that fails.
static int write(std::string_view text, int status) {
    std::cout << text << std::flush;
    return std::cout ? status : fail("cannot write the report: is the output closed, or full?", 2);
}

int main(int count, char** values) try {
    std::signal(SIGPIPE, SIG_IGN); // a closed pipe is a failed write
    std::string (*print)(const Report&) = text;
    std::vector<const char*> paths;
    for (int i = 1; i < count; ++i) {
        const std::string_view option = values[i];
        if (option == "--help" || option == "-h") return write(help, 0);
        if (option == "--version") return write(say(version, has_arb ? with_arb : without_arb), 0);
        if (option == "--json")
            print = json;
        else if (option == "--errata")
            print = errata;
        else if (option.starts_with('-'))
            return fail("unknown option " + printable(option, 40) + ", see --help", 3);
        else
            paths.push_back(values[i]);
    }
    if (paths.empty()) return fail("no file given, see --help", 3);
    const Classification classes = classify();
    std::vector<ReplayedFile> files;
    int status = 0;
    for (const char* path : paths) {
        std::ifstream in(path, std::ios::binary);
        std::string bytes, chunk(1 << 20, '\0');
        while (in && bytes.size() <= largest_file) { // one chunk more than may be parsed, at most
            in.read(chunk.data(), std::ssize(chunk));
            bytes.append(chunk, 0, static_cast<std::size_t>(in.gcount()));
        }
        if (in.good() || in.eof())
            files.push_back(replay(classes, path, bytes));
        else
            status = fail("cannot read " + printable(path, 4096) + ": " + std::strerror(errno), 2);
    }
    const Report report = summarize(classes, std::move(files));
    std::cerr << complaints(report);
    return write(print(report), std::max(status, report.status));
} catch (const std::bad_alloc&) {
    return fail("out of memory", 2);
}
