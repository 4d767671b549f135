// plcheck for a page: files come in as bytes; what the command prints, and its status, go out.
// The page only moves bytes and shows text. One Run is one call of the command.
#include "checker/command/options.h"
#include "checker/replay.h"
#include "checker/report/report.h"
#include "checker/version.h"

#include <emscripten.h>

using namespace checker;

// Tells the page how far a file is.
EM_JS(void, tell_progress, (unsigned line, unsigned records, unsigned solutions), {
    if (Module.progress) Module.progress(line, records, solutions);
});

namespace {

/// The words of a text, one a line.
std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

/// One call of the command, and what it has printed so far.
struct Run {
    explicit Run(std::string_view text) : arguments(lines_of(text)) {}

    std::vector<std::string> arguments;
    Options options{};
    Classification classes = classify();
    std::vector<ReplayedFile> files{};
    std::string output{}, errors{}, report{};
    int status = 0;
};

void parse(Run& run) {
    std::vector<char*> pointers;
    for (std::string& argument : run.arguments)
        pointers.push_back(argument.data());
    try {
        run.options = parse_options(pointers);
    } catch (const WrongUsage& usage) {
        run.errors = "plcheck: " + usage.reason + '\n';
        run.status = 3;
    }
}

/// What is printed after the lines on the files.
std::string rest_of(const Report& report, const Options& options) {
    std::string text = summary(report);
    if (options.table) text += table(report);
    if (options.errata) text += errata(report);
    if (options.why) text += why(report);
    return text + conclusion(report);
}

} // namespace

extern "C" {

/// Begins a call with these arguments, one a line: options, then names of files. To be freed by
/// end_run.
EMSCRIPTEN_KEEPALIVE Run* begin_run(const char* arguments) {
    Run* run = new Run(arguments);
    parse(*run);
    return run;
}

/// Replays the next file.
EMSCRIPTEN_KEEPALIVE void replay_file(Run* run, const char* name, const char* bytes,
                                      std::size_t size) {
    const Watch watch = [](const Progress& progress) {
        tell_progress(progress.line, progress.records, progress.solutions);
    };
    run->files.push_back(replay(run->classes, name, {bytes, size}, {watch, 1}));
    run->output += finding(run->files.back());
    run->errors += complaints(run->files.back());
}

/// Says what the files prove together, once all are replayed.
EMSCRIPTEN_KEEPALIVE void conclude_run(Run* run) {
    const Report report = summarize(run->classes, std::move(run->files), run->options.expectation);
    run->errors += objections(report);
    run->output += rest_of(report, run->options);
    run->report = json(report);
    run->status = report.status;
}

/// The status of the command, and what it prints; `report_of` is what it prints with --json.
EMSCRIPTEN_KEEPALIVE int status_of(const Run* run) {
    return run->status;
}
EMSCRIPTEN_KEEPALIVE const char* output_of(const Run* run) {
    return run->output.c_str();
}
EMSCRIPTEN_KEEPALIVE const char* errors_of(const Run* run) {
    return run->errors.c_str();
}
EMSCRIPTEN_KEEPALIVE const char* report_of(const Run* run) {
    return run->report.c_str();
}
EMSCRIPTEN_KEEPALIVE void end_run(Run* run) {
    delete run;
}

/// The version of plcheck.
EMSCRIPTEN_KEEPALIVE const char* version_of_checker() {
    return software_version.data();
}
}
