// plcheck and degree files, as a user meets them: the example of FORMAT.md, alone and with others.
#include "tests/support/programs.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

namespace {

/// The file that section 9 shows.
std::string example_of_degrees() {
    const std::string format = read_file(certs + "FORMAT.md");
    const std::size_t start = format.find("\nplcert 2 degrees\n") + 1;
    return format.substr(start, format.find("```", start) - start);
}

std::size_t line_number(const std::string& text, std::size_t position) {
    const auto begin = text.begin();
    return 1 + static_cast<std::size_t>(
                   std::count(begin, begin + static_cast<std::ptrdiff_t>(position), '\n'));
}

} // namespace

TEST_CASE("the degree file in FORMAT.md holds") {
    const TemporaryFolder folder;
    write_file(folder / "one.plc", example_of_degrees());
    const Outcome outcome = run("cd " + folder.path().string() + " && " + plcheck + " one.plc");
    CHECK(outcome.status == 0);
    CHECK(outcome.out == "one.plc: 1 degree record holds, 0 refused\n"
                         "- class 2394: certified to have at least 1 solution\n"
                         "at least  lower bounds by 1 degree record\n"
                         "exactly   no degree: theorems are for classes certified minimal; add "
                         "classification.plc\n"
                         "VERIFIED: at least 1 solution of class 2394 (one.plc)\n");
    CHECK(outcome.err.empty());
}

TEST_CASE("a degree file is compared with the paper where the classification is given") {
    const TemporaryFolder folder;
    write_file(folder / "one.plc", example_of_degrees());
    const std::string files = certs + "classification.plc " + (folder / "one.plc").string();
    const Outcome outcome = run(plcheck + " --json " + files);
    CHECK(outcome.status == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    CHECK(json["files"][1]["degrees"] ==
          nlohmann::json::array({{{"class", 2394}, {"certified_at_least", 1}}}));
    std::size_t found = 0;
    for (const auto& claim : json["degree_claims"]) {
        if (claim["claim"] != "3002_1, class 2394: 2*Pa/Pa/Pa + P/P/P") continue;
        ++found;
        CHECK(claim["claimed_exactly"].is_null());
        CHECK(claim["certified_at_least"] == 312);
        CHECK(claim["certified_exactly"] == 312);
    }
    CHECK(found == 1);
    // The PL0Ps, with four registrations; complete visibility; three points and one line; two
    // tables.
    CHECK(json["degree_claims"].size() == (51 + 4) + 12 + 1 + (11 + 3) + (29 + 3));
}

TEST_CASE("an altered degree file is refused, and says why") {
    const TemporaryFolder folder;
    std::string altered = example_of_degrees();
    const std::size_t last = altered.rfind("real ");
    write_file(folder / "twice.plc", altered + altered.substr(last));
    const Outcome twice = run("cd " + folder.path().string() + " && " + plcheck + " twice.plc");
    CHECK(twice.status == 1);
    CHECK(twice.err == "twice.plc:" + std::to_string(line_number(altered, altered.size())) +
                           ": refused: class 2394: this may be the solution of line " +
                           std::to_string(line_number(altered, last)) + "\n");
    write_file(folder / "none.plc", altered.substr(0, last));
    const Outcome none = run("cd " + folder.path().string() + " && " + plcheck + " none.plc");
    CHECK(none.status == 2);
    CHECK(none.err == "none.plc:" + std::to_string(line_number(altered, last) - 1) +
                          ": does not conform to FORMAT.md: found nothing, expected `pair`\n");
}
