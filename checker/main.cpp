// The command plcheck: reads files, has the core replay them, prints the report.
#include "checker/degrees/krawczyk.h"
#include "checker/report/report.h"
#include "checker/version.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iostream>

using namespace checker;
static constexpr std::string_view help = R"(usage: plcheck [--json | --errata] FILE...

    plcheck classification.plc         derive every count of the classification from certificates
    plcheck problem.plc                replay the verdict on one problem
    plcheck degrees.plc                certify that classes have at least so many solutions
    plcheck classification.plc degrees.plc
                                       the same; add upper bounds by theorem, compare with the paper
    plcheck classification.plc bounds.plc degrees.plc
                                       the same; add the upper bounds that templates certify
    plcheck classification.plc SHA256SUMS
                                       the same counts; compare the file with its digest in a list

    --json      print the report for a program
    --errata    print each count that differs from the paper, why it does, and a witness
    --version   print the version, the format, and what you have to trust for each kind of claim
    --help      print this text

plcheck believes no file. certs/FORMAT.md says what it verifies. A file states its own claim:
plcheck prints the claim, and the exit status says whether it holds.
Exit status: 0 every certificate holds, 1 one is refused, 2 a file cannot be read or parsed, or the
report cannot be written, 3 wrong usage.
)";

static constexpr std::string_view trusted = R"(
To believe a claim, trust what stands beside it. The folders are those of checker/.

every claim           the C++ compiler and its library, GMP, the operating system, the machine;
                      certs/FORMAT.md; main.cpp, replay.* and report, which print the claim
a classification      file, algebra, problem, classification; proofs/classification.md
its counts            also counts
one problem           file, algebra, problem, classification, verdict;
                      proofs/classification.md and problems.md
at least n solutions  file, algebra, problem, degrees; Arb (FLINT);
                      proofs/classification.md, problems.md and degrees.md
at most n solutions   all of the classification, degrees and bounds; proofs/upper_bounds.md
... by theorem        also the table bounds/theorems.h; the proofs that upper_bounds.md names; for
                      Theorem U17, FLINT and what proofs/computations/two_points.cpp prints
a digest              digests

Not trusted: certificate files, the programs that wrote them, the numbers of the paper (paper).
)";
static constexpr std::string_view with_arb = "This plcheck was built with Arb.\n";
static constexpr std::string_view without_arb =
    "This plcheck was built without Arb: it refuses degree files. Install FLINT with Arb (Debian:\n"
    "libflint-dev libflint-arb-dev) and build plcheck again to check them.\n";

static std::string version() {
    return say("plcheck ", software_version, ", certificate format ", format_version, '\n', trusted,
               has_arb ? with_arb : without_arb);
}

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
        if (option == "--version") return write(version(), 0);
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
