// The report in JSON: it parses, and has the members that programs rely on, for each kind of file.
#include "tests/support/results.h"
#include "tests/support/text.h"

#include <nlohmann/json.hpp>

#include <set>

using namespace checker;
using Json = nlohmann::json;

namespace {

using Names = std::set<std::string>;

Json parsed(const Report& report) {
    return Json::parse(checker::json(report));
}

Json report_on(const std::vector<ReplayedFile>& files) {
    return parsed(summarize(all_classes(), files));
}

Names names_of(const Json& object) {
    Names names;
    for (const auto& [name, value] : object.items())
        names.insert(name);
    return names;
}

/// The members of every file, with those of its kind.
Names members_of_file(Names own) {
    own.insert({"file", "kind", "conforms", "sha256", "refused", "complaints"});
    return own;
}

/// The only file of a report, after a check of the members that all files have.
Json only_file(const Json& report, const std::string& kind, const Names& own, int status) {
    CHECK(names_of(report) == Names{"format", "status", "conclusion", "files", "claims", "families",
                                    "degree_claims", "certified_exactly", "certified_groups"});
    CHECK(report["conclusion"]["verified"] == (status == 0));
    CHECK(report["format"] == 2);
    CHECK(report["status"] == status);
    REQUIRE(report["files"].size() == 1);
    const Json& file = report["files"][0];
    CHECK(names_of(file) == members_of_file(own));
    CHECK(file["kind"] == kind);
    CHECK(file["conforms"] == !kind.empty());
    return file;
}

const std::string problem = "plcert 2 problem\nproblem 3*P/P/P\nverdict under-constrained 2\n";

ReplayedFile replayed(const std::string& name, const std::string& bytes) {
    return replay(all_classes(), name, bytes);
}

} // namespace

TEST_CASE("JSON of a classification file") {
    const Json report = report_on({whole_classification()});
    const Json file = only_file(report, "classification", {"certified"}, 0);
    CHECK(file["certified"] == 143494);
    CHECK(file["refused"] == 0);
    CHECK(file["complaints"].empty());
    CHECK(report["claims"].size() == 22 + 3 + 12);
    for (const Json& claim : report["claims"]) {
        CHECK(names_of(claim) == Names{"claim", "paper", "certified", "verdict", "counted"});
        CHECK(claim["claim"].is_string());
        CHECK(claim["verdict"].is_string());
        CHECK_FALSE(claim["certified"].is_null());
    }
    CHECK(report["claims"][0]["paper"] == 845161);
    CHECK(report["claims"][0]["certified"] == 845161);
    CHECK(report["claims"].back()["certified"] == "minimal");
    CHECK(report["degree_claims"].empty());
    CHECK(report["certified_exactly"].empty());
}

TEST_CASE("JSON of problem files, with a class and without") {
    const Json with_class =
        only_file(report_on({problem_of_class(2394)}), "problem", {"problem", "verdict"}, 0);
    CHECK(with_class["problem"] == "2*Pa/Pa/Pa + P/P/P");
    CHECK(with_class["verdict"] == "minimal, class 2394");
    const Json report = report_on({replayed("three.plc", problem)});
    const Json without_class = only_file(report, "problem", {"problem", "verdict"}, 0);
    CHECK(without_class["verdict"] == "under-constrained 2");
    CHECK(without_class["file"] == "three.plc");
    for (const Json& claim : report["claims"])
        CHECK(claim["certified"].is_null() == (claim["verdict"] == "not covered by these files"));
}

TEST_CASE("JSON of a refused problem file") {
    const std::string wrong = "plcert 2 problem\nproblem 3*P/P/P\nverdict under-constrained 1\n";
    const Json file =
        only_file(report_on({replayed("wrong.plc", wrong)}), "problem", {"problem", "verdict"}, 1);
    CHECK(file["verdict"] == "");
    CHECK(file["refused"] == 1);
    REQUIRE(file["complaints"].size() == 1);
    CHECK(names_of(file["complaints"][0]) == Names{"line", "reason"});
    CHECK(file["complaints"][0]["line"] == 3);
    CHECK(file["complaints"][0]["reason"] == "the verdict is under-constrained 2");
}

TEST_CASE("JSON of a degree file") {
    const Json report = report_on({degree_file({{2394, 100}, {6722, 216}})});
    const Json file = only_file(report, "degrees", {"degrees"}, 0);
    CHECK(file["degrees"] == Json::array({{{"class", 2394}, {"certified_at_least", 100}},
                                          {{"class", 6722}, {"certified_at_least", 216}}}));
    CHECK(report["certified_exactly"].empty());
}

TEST_CASE("JSON of a file that does not conform") {
    const Json report = report_on({replayed("old.plc", "plcert 1 problem\n")});
    const Json file = only_file(report, "", {}, 2);
    CHECK(file["refused"] == 0);
    REQUIRE(file["complaints"].size() == 1);
    CHECK(file["complaints"][0]["line"] == 1);
}

TEST_CASE("JSON of a file that cannot be read") {
    const Json report =
        report_on({problem_of_class(2394), {.name = "a", .content = Unreadable{"a reason"}}});
    CHECK(report["status"] == 2);
    CHECK(report["files"][1]["conforms"] == false);
    CHECK(report["files"][1]["complaints"] ==
          Json::array({{{"line", 0}, {"reason", "cannot be read: a reason"}}}));
    for (const Json& claim : report["claims"])
        CHECK(claim["verdict"] != "confirmed");
}

TEST_CASE("JSON of the degrees that theorems give") {
    const Json report = report_on(
        {whole_classification(), registration_file(relative_pose, 20), degree_file({{2394, 300}})});
    CHECK(report["status"] == 0);
    CHECK(report["certified_exactly"] == Json::array({{2394, 312}}));
    for (const Json& claim : report["degree_claims"])
        CHECK(names_of(claim) == Names{"claim", "claimed_exactly", "certified_at_least",
                                       "certified_exactly", "verdict", "witness"});
    const auto chicago = std::ranges::find_if(report["degree_claims"], [](const Json& claim) {
        return claim["claim"] == "3002_1, class 2394: 2*Pa/Pa/Pa + P/P/P";
    });
    REQUIRE(chicago != report["degree_claims"].end());
    CHECK((*chicago)["claimed_exactly"].is_null());
    CHECK((*chicago)["certified_exactly"] == 312);
}

TEST_CASE("what is quoted keeps JSON valid") {
    const ReplayedFile file{.name = "a\"b\\c", .content = Malformed{{1, "found `\"\\`"}}};
    const Json report = report_on({file});
    CHECK(report["files"][0]["file"] == "a\"b\\c");
    CHECK(report["files"][0]["complaints"][0]["reason"] == "found `\"\\`");
}

TEST_CASE("a file of problems has its family, the problems that it lacks, and each verdict") {
    const std::string bytes = "plcert 2 problems\nmodulus 2305843009213693951\n"
                              "problem projective: 5*P/P\nunbalanced\n";
    const Json file = only_file(report_on({replayed("file", bytes)}), "problems",
                                {"family", "missing", "problems"}, 0);
    CHECK(file["family"] == "");
    CHECK(file["missing"] == 0);
    CHECK(file["problems"] ==
          Json::parse(R"([{"problem": "projective: 5*P/P", "minimal": false}])"));
    const std::string family = with(bytes, "modulus", "family plmp\nmodulus");
    const Json refused = only_file(report_on({replayed("file", family)}), "problems",
                                   {"family", "missing", "problems"}, 1);
    CHECK(refused["missing"] == 39);
    CHECK(refused["refused"] == 2);
    CHECK(refused["problems"].empty());
}
