// Models of registrations: `plprove model` writes the committed bytes, and `plcheck` reports them
// to people and machines, with the degrees that follow.
#include "tests/support/programs.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace {
const std::string committed = certs + "models/registrations/*.plc";
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

TEST_CASE("plprove model writes the committed files, byte by byte") {
    for (const std::string name : {"s00_l1_i0_r", "s_l0_i0_r5", "s_l2_i0_r11", "s3_l0_i1_r"}) {
        const Outcome outcome =
            run(plprove + " model " + SOURCE_DIR + "/models/registrations/" + name + ".model -o -");
        CHECK(outcome.status == 0);
        CHECK(outcome.out == read_file(certs + "models/registrations/" + name + ".plc"));
    }
}

TEST_CASE("models of registrations alone bound no problem, as none is proved minimal") {
    const Outcome text = run(plcheck + " --json " + committed);
    CHECK(text.status == 0);
    const auto json = nlohmann::json::parse(text.out);
    CHECK(json["files"].size() == 89);
    for (const auto& file : json["files"])
        CHECK(file["certified_at_most"].get<int>() > 0);
    CHECK(json["certified_exactly"].empty());
}

TEST_CASE("the degrees of all extensions of the five-point problem are certified exact") {
    std::size_t found = 0;
    const nlohmann::json json = report_on_registrations();
    CHECK(json["status"] == 0);
    for (const auto& claim : json["degree_claims"]) {
        const std::string name = claim["claim"];
        if (name == "terminal, of any degree") {
            CHECK(claim["certified_exactly"] >= 3615);
        }
        if (name == "terminal, degree 160") CHECK(claim["verdict"] == "differs");
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
        CHECK(claim["verdict"] == "agrees");
    }
    CHECK(registrations == std::vector{8, 4, 8, 8});
}

TEST_CASE("2*Pa/Pa/Pa + P/P/P has exactly 312 solutions, by its problem file alone") {
    const TemporaryFolder folder;
    const std::string problem = (folder / "problem.plc").string();
    const std::string quoted = " '2*Pa/Pa/Pa + P/P/P' ";
    REQUIRE(run(plprove + " certify" + quoted + ">" + problem).status == 0);
    const Outcome exactly = run(plcheck + " --expect" + quoted + "--degree 312 " + problem);
    CHECK(exactly.status == 0);
    CHECK(run(plcheck + " --expect" + quoted + "--degree 313 " + problem).status == 1);
    const std::string degrees = certs + "degrees/three-points.plc";
    const Outcome alone = run(plcheck + " --json " + degrees);
    CHECK(nlohmann::json::parse(alone.out)["certified_exactly"].empty());
}

TEST_CASE(
    "the Chicago problem has exactly 312 solutions, certified, like others with three points") {
    const Outcome outcome =
        run(plcheck + " --json " + classification + certs + "degrees/three-points.plc");
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

TEST_CASE("plcheck names the theorem that certifies a degree, and its page") {
    struct Example {
        std::string problem, degree, theorem, page;
    };
    const std::vector<Example> examples{
        {"2*P/P/P + a/P/Pa + P/a/Pa + -/P/P", "416", "C", "three_views/4_classes.md"},
        {"Pabcde/Pabcde/Pabcde + a/P/Pa + P/a/a", "304", "K", "three_views/5_many_pins.md"},
        {"Pabcdef/Pabcdef/Pabcdef + 2*P/a/a", "64", "U8", "three_views/6_lines_through_a_point.md"},
        {"Pabcd/Pabcd/Pabcd + 2*a/a/a", "480", "K", "three_views/5_many_pins.md"}};
    for (const auto& [problem, degree, theorem, page] : examples) {
        const Outcome outcome = run(plcheck + " --expect '" + problem + "' --degree " + degree +
                                    " --why " + classification);
        CHECK(outcome.status == 0);
        const std::string reason = "\n- exactly " + degree + ", by Theorem " + theorem;
        CHECK(outcome.out.find(reason + " of proofs/" + page + "\n") != std::string::npos);
    }
}

TEST_CASE("an altered model of a registration bounds nothing, and an altered minor is refused") {
    const TemporaryFolder folder;
    const std::string file = (folder / "altered.plc").string();
    const std::string text = read_file(certs + "models/registrations/s00_l1_i0_r.plc");
    const auto with = [&](const std::string& old, const std::string& by) {
        std::string altered = text;
        const std::size_t place = altered.find(old);
        REQUIRE(place != std::string::npos);
        write_file(file, altered.replace(place, old.size(), by));
    };
    with("\nminor ", "\nminor 1");
    CHECK(run(plcheck + " " + file).status != 0);
    // 5*P/P has 20 solutions, if some class attains the product of the two bounds.
    const std::string problem = (folder / "problem.plc").string();
    REQUIRE(run(plprove + " certify 5*P/P >" + problem).status == 0);
    const std::string twenty = plcheck + " --expect 5*P/P --degree 20 " + classification + certs +
                               "models/registrations/s_l0_i0_r5.plc " + problem + ' ';
    with("minor", "minor");
    CHECK(run(twenty + file).status == 0);
    // Another name, or another line: another model, which says nothing of the registration.
    with("model registration_s00_l1_i0_r", "model another_name");
    CHECK(run(twenty + file).status == 1);
    with("unknown u , v", "unknown u , v\nnonzero 1");
    CHECK(run(twenty + file).status == 1);
}
