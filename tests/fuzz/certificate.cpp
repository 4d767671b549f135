// Fuzzed: the checker's core, from the bytes of a file to the printed report. Whatever the bytes,
// it returns a report with complaints fit for a terminal, and every complaint names a line.
#include "checker/problem/notation.h"
#include "tests/fuzz/require.h"
#include "tests/mutation/short_archive.h"
#include "tests/support/report.h"

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

void require_fit(const Complaint& complaint, std::size_t lines) {
    require(complaint.line <= lines, "a complaint about a line that does not exist");
    require(printable_ascii(complaint.reason) && complaint.reason.size() < 1000,
            "a complaint unfit for a terminal");
}

/// What holds of every replayed file, whatever its bytes.
void require_sense(const ReplayedFile& file, std::string_view bytes) {
    const auto lines = static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), '\n')) + 1;
    if (const auto* malformed = std::get_if<Malformed>(&file.content))
        require_fit(malformed->complaint, lines);
    const Refusals& refusals = refusals_of(file);
    require(refusals.first.size() == std::min(refusals.count, Refusals::most_reported),
            "a refusal is not told");
    for (const Complaint& complaint : refusals.first)
        require_fit(complaint, lines);
    if (const auto* content = std::get_if<ClassificationFile>(&file.content))
        require(content->verdicts.size() + refusals.count >= short_classes.size(),
                "a class is neither certified nor refused");
    if (const auto* content = std::get_if<ProblemFile>(&file.content)) {
        require(content->verdict.empty() == (refusals.count > 0),
                "a problem file has a verdict and is refused, or neither");
        require(!content->of_class || refusals.count == 0, "a refused file proves something");
    }
    if (const auto* content = std::get_if<checker::ProblemsFile>(&file.content)) {
        require(content->verdicts.size() + refusals.count > 0, "a record is not told");
        require(content->missing == 0 || refusals.count > 0, "a family lacks problems, and holds");
    }
    if (const auto* content = std::get_if<ModelFile>(&file.content))
        require(content->records > 0 || (content->at_least == 0 && !content->at_most),
                "a bound without a record");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const bool problem = bytes.starts_with("plcert 2 problem");
    std::vector<ReplayedFile> files{replay(problem ? all : few, "fuzzed", bytes)};
    require_sense(files.front(), bytes);
    try { // the same bytes as the problem of --expect
        parse_problem(bytes);
    } catch (const Malformed& malformed) {
        require_fit(malformed.complaint, 1);
    }
    if (problem) return 0; // a summary looks at all classes: some 10 ms
    const Report report = summarize(few, std::move(files));
    require(report.status >= 0 && report.status <= 2, "a status that the help does not have");
    require(printable_ascii(detailed(report) + json(report) + errata(report) + complaints(report)),
            "a report unfit for a terminal");
    return 0;
}
