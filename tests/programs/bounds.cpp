// `plprove bounds` writes the committed bytes; `plcheck` reports them to people and machines.
#include "tests/support/program.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <utility>
#include <vector>

namespace {
const std::string plprove = PLPROVE;
const std::string plcheck = PLCHECK;
const std::string committed = std::string(SOURCE_DIR) + "/certs/bounds.plc";
} // namespace

TEST_CASE("plprove bounds writes the committed file, byte by byte") {
    const Outcome outcome = run(plprove + " bounds -o -");
    CHECK(outcome.status == 0);
    CHECK(outcome.out == read_file(committed));
}

TEST_CASE("plcheck tells how many problems are bounded") {
    const Outcome text = run(plcheck + " " + committed);
    CHECK(text.status == 0);
    CHECK(text.err.empty());
    CHECK(text.out.find("89 templates hold, 0 refused\n"
                        "- certified: 13 terminal problems have at most 64 solutions\n"
                        "- certified: 8 terminal problems have at most 80 solutions\n"
                        "- certified: 548 terminal problems have at most 160 solutions\n") !=
          std::string::npos);
    const auto json = nlohmann::json::parse(run(plcheck + " --json " + committed).out);
    CHECK(json["files"][0]["templates"] == 89);
    int problems = 0;
    for (const auto& [solutions, count] : json["files"][0]["terminal_problems_at_most"].items())
        problems += count.get<int>();
    // Extensions; six or five lines through a point; three points; two, and a line.
    CHECK(problems == 3615 + 28 + 18 + 5);
}

TEST_CASE("the degrees of all extensions of the five-point problem are certified exact") {
    const std::string certs = std::string(SOURCE_DIR) + "/certs/";
    const Outcome outcome = run(plcheck + " --json " + certs + "classification.plc " + committed +
                                " " + certs + "degrees/registrations.plc");
    CHECK(outcome.status == 0);
    std::size_t found = 0;
    const auto json = nlohmann::json::parse(outcome.out);
    for (const auto& claim : json["degree_claims"]) {
        const std::string name = claim["claim"];
        if (name == "terminal, of any degree") CHECK(claim["certified_exactly"] == 3615);
        if (name == "terminal, degree 160") CHECK(claim["verdict"] == "differs, certified");
        found += name == "terminal, of any degree" || name == "terminal, degree 160";
    }
    CHECK(found == 2);
}

TEST_CASE(
    "the Chicago problem has exactly 312 solutions, certified, like others with three points") {
    const std::string certs = std::string(SOURCE_DIR) + "/certs/";
    const Outcome outcome = run(plcheck + " --json " + certs + "classification.plc " + committed +
                                " " + certs + "degrees/three-points.plc");
    CHECK(outcome.status == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    const std::vector<std::pair<int, int>> exact = json["certified_exactly"];
    // With the classes that have features exchanged for P/a/a.
    CHECK(exact == std::vector<std::pair<int, int>>{{811, 224},
                                                    {2394, 312},
                                                    {2446, 304},
                                                    {2447, 376},
                                                    {2448, 376},
                                                    {6722, 216},
                                                    {6723, 272},
                                                    {6725, 384},
                                                    {6726, 464},
                                                    {6727, 368},
                                                    {6728, 464},
                                                    {6729, 368},
                                                    {6730, 448},
                                                    {6731, 520},
                                                    {6732, 448},
                                                    {6733, 520},
                                                    {6734, 448},
                                                    {6735, 520}});
}

TEST_CASE("an altered file of bounds is refused with the line of the template") {
    const TemporaryFolder folder;
    std::string text = read_file(committed);
    const std::size_t place = text.find("minor ");
    REQUIRE(place != std::string::npos);
    text[place + 6] = text[place + 6] == '1' ? '2' : '1';
    write_file(folder / "bounds.plc", text);
    const Outcome outcome = run(plcheck + " " + (folder / "bounds.plc").string());
    CHECK(outcome.status == 1);
    CHECK(outcome.err.find("bounds.plc:3: refused: the minor is ") != std::string::npos);
}
