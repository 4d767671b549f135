// Fuzzed: what a sweep reads back. What is taken for whole survives being written,
// conforms to the format, and loses nothing when it is merged with itself.
#include "prover/degree_sweep/sweep_result.h"
#include "checker/replay.h"
#include "tests/fuzz/require.h"

#include <sstream>

using namespace plprove;

namespace {

// Enumerated before the clock of the fuzzer runs.
const std::size_t number_of_classes = label_classes().size();

std::optional<SweepResult> parse(const std::string& text, bool whole) {
    std::istringstream file(text);
    return parse_sweep_result(file, whole);
}

/// plcheck can read the file. (It knows no class here, so it proves nothing, which takes no time.)
void require_format(const std::string& text) {
    const checker::ReplayedFile file = checker::replay(checker::Classification{}, "fuzzed", text);
    require(std::holds_alternative<checker::DegreeFile>(file.content) ||
                std::holds_alternative<checker::SolutionsFile>(file.content),
            "a result that does not conform to FORMAT.md");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::optional<SweepResult> head = parse(text, false);
    const std::optional<SweepResult> result = parse(text, true);
    require(!result || head, "a whole result without a head");
    if (!result) return 0;
    require(!result->run.problem.empty() || result->run.number < number_of_classes ||
                result->record.empty(),
            "no such class");
    const std::string written = write(*result);
    if (!result->record.empty()) require_format(written);
    const std::optional<SweepResult> again = parse(written, true);
    require(again && write(*again) == written, "a result does not survive a round trip");
    const SweepResult both = merged(*result, *again);
    require(both.run.degree == result->run.degree,
            "a result loses solutions when it is merged with itself");
    require(parse(write(both), true).has_value(), "a merged result is damaged");
    return 0;
}
