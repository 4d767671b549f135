// Fuzzed: plcheck from its command line to all that it prints, but for reading the files. The first
// line of the input is the command line, its words apart by tabs; the files that it names follow,
// apart by lines of four dashes. Whatever they are, the status, the last line and the report for
// programs say the same, and all is fit for a terminal.
#include "checker/command/options.h"
#include "tests/fuzz/require.h"
#include "tests/mutation/short_archive.h"
#include "tests/support/report.h"

#include <nlohmann/json.hpp>
#include <sstream>

using namespace checker;

namespace {

// Made before the clock of the fuzzer runs: thousands of replays a second, not one.
const Classification few = classification_of(classify(), short_classes);

/// The parts of a text, which stand apart by a separator.
std::vector<std::string> split(std::string_view text, std::string_view separator) {
    std::vector<std::string> parts;
    for (std::size_t end = 0; end != text.npos;) {
        end = text.find(separator);
        parts.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(text.size(), parts.back().size() + separator.size()));
    }
    return parts;
}

/// ASCII that moves no cursor.
bool is_fit(std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); });
}

/// What a command line asks for, and the words to which it points.
struct Command {
    std::vector<std::string> words;
    std::optional<Options> options{}; // none where it makes no sense
};

Command read_command(std::string_view line) {
    Command command{split(line.substr(0, line.find('\0')), "\t")};
    std::vector<char*> pointers;
    for (std::string& word : command.words)
        pointers.push_back(word.data());
    try {
        command.options = parse_options(pointers);
    } catch (const WrongUsage& usage) {
        require(is_fit(usage.reason) && usage.reason.size() < 1000, "a message unfit to read");
    }
    return command;
}

void require_sense(const Report& report, const Options& options) {
    const std::string last = conclusion(report);
    require(last.starts_with(report.status == 0 ? "VERIFIED: " : "NOT VERIFIED: "),
            "the last line and the status differ");
    require(report.findings.status <= report.status, "a refusal that the status does not show");
    require(report.judgement.verified || report.status > 0, "not proved, and verified");
    const bool expects = !std::holds_alternative<std::monostate>(options.expectation);
    if (expects && report.status == 0)
        require(last == "VERIFIED: " + report.judgement.statement + last.substr(last.rfind(" (")),
                "another statement than the one expected");
    const nlohmann::json for_programs = nlohmann::json::parse(json(report));
    require(for_programs.at("status") == report.status, "the report and the status differ");
    require(is_fit(detailed(report) + json(report) + errata(report) + complaints(report) + last),
            "a report unfit for a terminal");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const std::size_t end_of_line = std::min(bytes.find('\n'), bytes.size());
    Command command = read_command(bytes.substr(0, end_of_line));
    if (!command.options) return 0;
    const Options& options = *command.options;
    const std::string_view rest = bytes.substr(std::min(end_of_line + 1, bytes.size()));
    const std::vector<std::string> contents = split(rest, "----\n");
    std::vector<ReplayedFile> files;
    for (std::size_t i = 0; i < options.paths.size(); ++i)
        files.push_back(replay(few, options.paths[i], contents[std::min(i, contents.size() - 1)]));
    require_sense(summarize(few, std::move(files), options.expectation), options);
    return 0;
}
