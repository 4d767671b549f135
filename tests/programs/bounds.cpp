// `plprove bounds` writes the committed bytes; `plcheck` reports them to people and machines.
#include "tests/support/program.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace {
const std::string plprove = PLPROVE;
const std::string plcheck = PLCHECK;
const std::string certs = std::string(SOURCE_DIR) + "/certs/";
const std::string committed = certs + "bounds.plc";
const std::string classification = certs + "classification.plc ";

/// What plcheck reports of all extensions of the five-point problem: once, as it takes seconds.
const nlohmann::json& report_on_registrations() {
    static const nlohmann::json report =
        nlohmann::json::parse(run(plcheck + " --json " + classification + committed + " " + certs +
                                  "degrees/registrations.plc")
                                  .out);
    return report;
}

} // namespace

TEST_CASE("plprove bounds writes the committed file, byte by byte") {
    const Outcome outcome = run(plprove + " bounds -o -");
    CHECK(outcome.status == 0);
    CHECK(outcome.out == read_file(committed));
}

TEST_CASE("plcheck tells how many problems are bounded, where they are proved minimal") {
    const Outcome text = run(plcheck + " --table " + classification + committed);
    CHECK(text.status == 0);
    CHECK(text.err.empty());
    CHECK(text.out.find("89 templates hold, 0 refused\n") != std::string::npos);
    CHECK(text.out.find(
              "\nat most   upper bounds of 74575 terminal problems, 70960 of them by theorem\n") !=
          std::string::npos);
    CHECK(
        text.out.find("\ncertified: 13 terminal problems have at most 64 solutions, 13 of them by "
                      "theorem\n"
                      "certified: 8 terminal problems have at most 80 solutions\n"
                      "certified: 548 terminal problems have at most 160 solutions\n") !=
        std::string::npos);
    const auto json =
        nlohmann::json::parse(run(plcheck + " --json " + classification + committed).out);
    CHECK(json["files"][1]["templates"] == 89);
    int by_templates = 0, by_theorem = 0, most = 0;
    for (const auto& count : json["terminal_problems"]) {
        by_templates += count["by_templates"].get<int>();
        by_theorem += count["by_theorem"].get<int>();
        CHECK(count["at_most"] > most); // in ascending order
        most = count["at_most"].get<int>();
    }
    CHECK(by_templates == 3615); // extensions of the five-point problem
    CHECK(by_theorem == 70960);
}

TEST_CASE("a file of bounds without a template says nothing of any problem") {
    const TemporaryFolder folder;
    write_file(folder / "empty.plc", "plcert 2 bounds\nmodulus 2305843009213693951\n");
    const Outcome empty = run(plcheck + " " + (folder / "empty.plc").string());
    CHECK(empty.status == 1);
    CHECK(empty.out.find("certified") == std::string::npos);
    CHECK(empty.out.find("\nVERIFIED") == std::string::npos);
    CHECK(empty.err.ends_with("empty.plc:0: refused: it has no record, so it proves nothing\n"));
}

TEST_CASE("templates alone bound no problem, as none is proved minimal") {
    const Outcome text = run(plcheck + " " + committed);
    CHECK(text.status == 0);
    CHECK(text.out == committed + ": 89 templates hold, 0 refused\nVERIFIED: 89 templates (" +
                          committed + ")\n");
    const auto json = nlohmann::json::parse(run(plcheck + " --json " + committed).out);
    CHECK(json["files"][0]["templates"] == 89);
    CHECK(json["terminal_problems"].empty());
}

TEST_CASE("the degrees of all extensions of the five-point problem are certified exact") {
    std::size_t found = 0;
    const nlohmann::json json = report_on_registrations();
    CHECK(json["status"] == 0);
    for (const auto& claim : json["degree_claims"]) {
        const std::string name = claim["claim"];
        if (name == "terminal, of any degree") {
            CHECK(claim["certified_exactly"] == 3615);
            CHECK(claim["by_theorem"] == 0);
        }
        if (name == "terminal, degree 160") CHECK(claim["verdict"] == "differs, certified");
        found += name == "terminal, of any degree" || name == "terminal, degree 160";
    }
    CHECK(found == 2);
}

TEST_CASE("four PL0Ps register a camera: 8, 4, 8 and 8 solutions beside the 20 relative poses") {
    const nlohmann::json json = report_on_registrations();
    std::vector<int> registrations;
    for (const auto& claim : json["degree_claims"]) {
        const std::string name = claim["claim"];
        if (!name.starts_with("- registration of its third camera")) continue;
        registrations.push_back(claim["certified_exactly"].get<int>());
        CHECK(claim["claimed_exactly"] == claim["certified_exactly"]);
        CHECK(claim["verdict"] == "agrees, certified");
    }
    CHECK(registrations == std::vector{8, 4, 8, 8});
}

TEST_CASE("2*Pa/Pa/Pa + P/P/P has exactly 312 solutions, by its problem file and a degree file") {
    const TemporaryFolder folder;
    const std::string problem = (folder / "problem.plc").string();
    REQUIRE(run(plprove + " certify '2*Pa/Pa/Pa + P/P/P' >" + problem).status == 0);
    const std::string degrees = certs + "degrees/three-points.plc";
    const Outcome outcome = run(plcheck + " --json " + problem + " " + degrees);
    CHECK(outcome.status == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    CHECK(json["certified_exactly"] == nlohmann::json::array({{2394, 312}}));
    const Outcome alone = run(plcheck + " --json " + degrees);
    CHECK(nlohmann::json::parse(alone.out)["certified_exactly"].empty());
}

TEST_CASE(
    "the Chicago problem has exactly 312 solutions, certified, like others with three points") {
    const Outcome outcome = run(plcheck + " --json " + classification + committed + " " + certs +
                                "degrees/three-points.plc");
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

TEST_CASE("plcheck says by which theorem of which page a degree is certified") {
    struct Example {
        std::string problem, degree, theorem, page;
    };
    const std::vector<Example> examples{
        {"2*P/P/P + a/P/Pa + P/a/Pa + -/P/P", "416", "C", "three_views/4_classes.md"},
        {"Pabcde/Pabcde/Pabcde + a/P/Pa + P/a/a", "304", "K", "three_views/5_many_pins.md"},
        {"Pabcd/Pabcd/Pabcd + Pa/Pa/Pa", "240", "U11", "three_views/6_lines_through_a_point.md"},
        {"Pabcd/Pabcd/Pabcd + 2*a/a/a", "480", "Y", "three_views/5_many_pins.md"}};
    const TemporaryFolder folder;
    const std::string degrees = (folder / "degrees.plc").string();
    for (const auto& [problem, degree, theorem, page] : examples) {
        const std::string quoted = " '" + problem + "' ";
        REQUIRE(run(plprove + " degree" + quoted + "-o " + degrees).status == 0);
        const Outcome outcome = run(plcheck + " --expect" + quoted + "--degree " + degree +
                                    " --why " + classification + degrees);
        CHECK(outcome.status == 0);
        const std::string reason = "\n- at most " + degree + ", by Theorem " + theorem;
        CHECK(outcome.out.find(reason + " of proofs/" + page + "\n") != std::string::npos);
    }
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
