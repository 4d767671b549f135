// The command plcheck: reads files, has the core replay them, tells of each as it goes, prints the
// report.
#include "checker/command/options.h"
#include "checker/command/progress.h"
#include "checker/degrees/krawczyk.h"
#include "checker/report/report.h"
#include "checker/version.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <unistd.h>

using namespace checker;
static constexpr std::string_view help = R"(Usage: plcheck [OPTION]... [--] FILE...

    plcheck classification.plc               every count of the classification, from certificates
    plcheck --table classification.plc       the degree of each minimal class by theorem, too
    plcheck classification.plc degrees.plc   compare the solutions in a file with the theorem
    plcheck problem.plc                      replay the verdict on one problem
    plcheck certs/plmp.plc                   replay the verdicts on a family, and count them
    plcheck degrees.plc                      certify that the solutions of classes exist
    plcheck certs/solutions/plmp.plc         the same, of problems in general
    plcheck --table certs/models/*.plc       how many solutions models have, and what is claimed

What do you expect? Status 0 then says that the files prove just that:
    --expect PROBLEM     a problem like '2*Pa/Pa/Pa + P/P/P' or 'projective: 7*P/P', or the file of
                         a model, models/p3p.model; add some of the next three
    --verdict VERDICT    minimal, camera-minimal, not-minimal, obstructed, under-constrained or
                         over-constrained
    --degree N           exactly N solutions for the cameras; '>=N' at least N
    --group GROUP        how images permute these solutions: S312 in any way; '>=A312' in any even
                         way, at least; '<S8 wr S2 wr S10' in half of the ways that keep 10 blocks
                         of 2 blocks of 8 together; 'S2 wr S136' in all that keep 136 pairs
    --classification     that every label class has a certificate
    --family FAMILY      that every problem of it has one: plmp, projective, or what plprove list
                         --family names for other cameras
    --expect-list FILE   that every problem of a list has one, one problem a line, in any order and
                         spelling; with --verdict, that each has this verdict

What to print, beside a line for each file and a summary; the last line is the result:
    --table              every count and every degree, beside those of the paper
    --errata             each count that differs from the paper, why it does, and a witness
    --why                why the files prove what they do
    --quiet              the last line only
    --json               a report for a program, see docs/report.schema.json

    --threads N          replay a degree file with N threads (default: one a core); the report is
                         the same
    --effort N           refuse a file that takes more effort (default: 100000, a minute or so of one
                         core; 1000000 is ten minutes)

    --version            the version, the format, and where to read what you have to trust
    --help               this text

A problem is the same in another order of its features and with other names of pins. A file about
it with the photos in another order does not count; a record of its label class does.
plcheck believes no file. certs/FORMAT.md says what it verifies. A file chooses its own claim: say
what you expect.
Exit status: 0 verified: every file holds, and proves what is expected; 1 something is refused, or
what is expected is not proved; 2 a file cannot be read or parsed, or the report cannot be written;
3 wrong usage.
)";

static constexpr std::string_view trusted = R"(
For each kind of claim, README.md (What you must trust) names the folders of the checker that
decide it and the pages that prove it. proofs/README.md is the map of these pages.
plcheck trusts no certificate, no program that wrote one, and no number of a paper.
)";
static constexpr std::string_view with_arb = "This plcheck was built with Arb.\n";
static constexpr std::string_view without_arb =
    "This plcheck was built without Arb: it refuses solutions that are given by\n"
    "decimals, in degree files and files of solutions. Install FLINT with Arb\n"
    "(Debian: libflint-dev libflint-arb-dev) and build plcheck again to check them.\n";

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

/// Reads a file, at most one chunk more than may be parsed. False if it cannot be read.
static bool read(const char* path, std::string& bytes) {
    std::ifstream in(path, std::ios::binary);
    std::string chunk(1 << 20, '\0');
    while (in && bytes.size() <= largest_file) {
        in.read(chunk.data(), std::ssize(chunk));
        bytes.append(chunk, 0, static_cast<std::size_t>(in.gcount()));
    }
    return in.good() || in.eof();
}

static ReplayedFile read_and_replay(const Classification& classes, const char* path,
                                    const Options& options, ProgressBar& bar) {
    std::string bytes;
    if (!read(path, bytes))
        return {.name = printable(path, 4096), .content = Unreadable{std::strerror(errno)}};
    bar.begin(bytes);
    const Watch watch = [&](const Progress& progress) { bar.update(progress); };
    ReplayedFile file = replay(classes, path, bytes, {watch, options.threads, options.effort});
    bar.clear();
    return file;
}

static std::uintmax_t size_of(const std::vector<const char*>& paths) {
    std::uintmax_t sum = 0;
    for (const char* path : paths) {
        std::error_code error; // a pipe has no size
        const std::uintmax_t size = std::filesystem::file_size(path, error);
        if (!error) sum += size;
    }
    return sum;
}

/// Replays the files, and tells of each when it is done.
static std::vector<ReplayedFile> replay_all(const Classification& classes, const Options& options) {
    const bool told = !options.json && !options.quiet;
    ProgressBar bar(size_of(options.paths), !options.quiet && isatty(STDERR_FILENO) == 1);
    std::vector<ReplayedFile> files;
    for (const char* path : options.paths) {
        files.push_back(read_and_replay(classes, path, options, bar));
        std::cerr << complaints(files.back());
        if (told) std::cout << finding(files.back()) << std::flush;
    }
    return files;
}

/// What is printed after the lines on the files.
static std::string rest_of(const Report& report, const Options& options) {
    if (options.json) return json(report);
    std::string text;
    if (!options.quiet) text += summary(report);
    if (options.table) text += table(report);
    if (options.errata) text += errata(report);
    if (options.why) text += why(report);
    return text + conclusion(report);
}

int main(int count, char** values) try {
    std::signal(SIGPIPE, SIG_IGN); // a closed pipe is a failed write
    const std::string_view only = count == 2 ? values[1] : "";
    if (only == "--help" || only == "-h") return write(help, 0);
    if (only == "--version") return write(version(), 0);
    const std::span arguments(values, static_cast<std::size_t>(count));
    const Options options = parse_options(arguments.subspan(1));
    const Classification classes = classify();
    const Report report =
        summarize(classes, replay_all(classes, options), options.expectation, options.table);
    std::cerr << objections(report);
    return write(rest_of(report, options), report.status);
} catch (const WrongUsage& usage) {
    return fail(usage.reason, 3);
} catch (const std::bad_alloc&) {
    return fail("out of memory", 2);
}
