// Fuzzed: the checker's core, from the bytes of a file to the printed report. Whatever the bytes,
// it returns a report with complaints fit for a terminal, and every complaint names a line.
#include "checker/report.h"
#include "tests/fuzz/require.h"
#include "tests/mutation/short_archive.h"

#include <iterator>

using namespace checker;

namespace {

bool printable_ascii(std::string_view text) {
    return text.find_first_not_of(
               "\n !\"#$%&'()*+,-./0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]"
               "^_`abcdefghijklmnopqrstuvwxyz{|}~") == text.npos;
}

// Made before the clock of the fuzzer runs.
const Classification all = classify();
// Classification files are about a few classes: thousands of replays a second, not one.
const Classification few = classification_of(all, short_classes);

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const bool problem = bytes.starts_with("plcert 2 problem");
    std::vector<FileReport> files{replay(problem ? all : few, "fuzzed", bytes)};
    const FileReport& file = files.front();
    require(file.conforms || (file.verdicts.empty() && file.certified.empty()),
            "a file that does not conform proves something");
    require(file.conforms || file.complaints.size() == 1, "a syntax error is told otherwise");
    require(file.conforms || file.degrees.empty(), "a file that does not conform has degrees");
    require(file.kind != "classification" ||
                file.verdicts.size() + file.refused >= short_classes.size(),
            "a class is neither certified nor refused");
    const auto lines = static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), '\n')) + 1;
    for (const auto& [line, reason] : file.complaints) {
        require(line <= lines, "a complaint about a line that does not exist");
        require(printable_ascii(reason) && reason.size() < 1000,
                "a complaint unfit for a terminal");
    }
    if (problem) return 0; // a summary looks at all classes: some 10 ms
    const Report report = summarize(few, std::move(files));
    require(printable_ascii(text(report) + json(report) + complaints(report)),
            "a report unfit for a terminal");
    return 0;
}
