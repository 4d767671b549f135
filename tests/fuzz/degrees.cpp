// Fuzzed: the reader of certs/degrees.csv. What is accepted is in range, and what is not is refused
// with the number of the line.
#include "prover/catalogue/degrees.h"
#include "tests/fuzz/require.h"

#include <algorithm>
#include <stdexcept>

using namespace plprove;

// Enumerated before the clock of the fuzzer runs.
static const std::size_t number_of_classes = label_classes().size();

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text(reinterpret_cast<const char*>(data), size);
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        lines.push_back(text.substr(0, text.find('\n')));
        text.remove_prefix(std::min(lines.back().size() + 1, text.size()));
    }
    std::vector<DegreeRecord> records;
    try {
        records = parse_degrees(lines);
    } catch (const std::runtime_error& error) {
        require(std::string_view(error.what()).starts_with("degrees.csv, line "),
                "a message without a place");
        return 0;
    }
    require(records.size() <= lines.size(), "more records than lines");
    for (const DegreeRecord& record : records)
        require(record.number < number_of_classes && record.degree > 0 && !record.source.empty() &&
                    !name(record.status).empty(),
                "a record out of range");
    const DegreeTable table(std::move(records), label_classes());
    for (const DegreeRecord& record : table.records()) {
        const std::size_t constraint = class_number(
            label_classes(), constraint_representative(label_classes()[record.number]));
        const std::vector<DegreeRecord> found = table.find(record.number, constraint);
        require(std::ranges::count_if(found,
                                      [&](const DegreeRecord& other) {
                                          return other.number == record.number &&
                                                 other.status == record.status;
                                      }) == 1,
                "a record that is not found once");
    }
    return 0;
}
