// `plprove recommend`: which minimal problems matches offer.
#include "tests/support/programs.h"

#include <doctest/doctest.h>
#include <map>
#include <nlohmann/json.hpp>

namespace {

nlohmann::json recommended(const std::string& matches) {
    const Outcome outcome = run(plprove + " recommend '" + matches + "' --json");
    REQUIRE(outcome.status == 0);
    CHECK(outcome.err.empty());
    return nlohmann::json::parse(outcome.out);
}

/// The problems recommended for these matches, and their degrees.
std::map<std::string, int> degrees_recommended(const std::string& matches) {
    std::map<std::string, int> degrees;
    const nlohmann::json report = recommended(matches);
    for (const auto& problem : report["problems"])
        degrees[problem["problem"]] = problem["degree"];
    return degrees;
}

} // namespace

TEST_CASE("plprove recommend lists what matches offer, the fastest first, to people and machines") {
    const nlohmann::json report = recommended("9*Pa/Pa/Pa + 4*P/P/-");
    CHECK(report["matches"] == "9*Pa/Pa/Pa + 4*P/P/-");
    double last = 0;
    for (const auto& problem : report["problems"]) {
        CHECK(problem["expected_ms"] >= last);
        CHECK(problem["rotation_error_degrees"] > 0);
        last = problem["expected_ms"];
    }
    const Outcome people = run(plprove + " recommend '9*Pa/Pa/Pa + 4*P/P/-'");
    CHECK(people.status == 0);
    CHECK(lines_of(people.out).size() == report["problems"].size() + 1);
    CHECK(lines_of(people.out)[1].starts_with(std::string(report["problems"][0]["problem"])));
}

TEST_CASE("the matches of a problem that is recommended offer it, and its degree is certified") {
    // Enough of everything: all problems of the list are there.
    const auto all = degrees_recommended("9*Pabc/Pabc/Pabc + 9*a/a/a");
    CHECK(all.size() > 15);
    for (const auto& [problem, degree] : all) {
        CAPTURE(problem);
        CHECK(degrees_recommended(problem).contains(problem));
        const std::string known = run(plprove + " problem '" + problem + "'").out;
        CHECK(contains(known, "\ndegree      " + std::to_string(degree) + " certified\n"));
    }
}

TEST_CASE("matches that miss a view, or have too few lines, offer fewer problems") {
    CHECK(degrees_recommended("5*P/P") == std::map<std::string, int>{{"5*P/P", 20}});
    CHECK(degrees_recommended("4*P/P").empty());
    CHECK(degrees_recommended("5*P/P/- + 2*a/a/a").empty());
    CHECK(degrees_recommended("5*P/P/- + 3*a/a/a").size() == 1);
    CHECK(degrees_recommended("P/P/P + 2*Pa/Pa/Pa").contains("P/P/P + 2*Pa/Pa/Pa"));
    CHECK(degrees_recommended("P/P/P + 2*Pa/Pa/P").empty());
    CHECK(contains(run(plprove + " recommend 4*P/P").out, "too few matches"));
}

TEST_CASE("plprove recommend reads files of images, and refuses what is none") {
    const TemporaryFolder folder;
    const std::string images = (folder / "images.json").string();
    REQUIRE(run(plprove + " solve --example Chicago -o " + images).status == 0);
    CHECK(degrees_recommended(images) == degrees_recommended("P/P/P + 2*Pa/Pa/Pa"));
    const std::string wrong = (folder / "wrong.json").string();
    for (const char* text : {"{", "[]", "{\"features\": 7}", "{\"features\": [{}]}",
                             "{\"features\": [{\"views\": [7]}]}", "{\"features\": []}",
                             "{\"features\": [{\"views\": [{\"lines\": {\"?\": 1}}]}]}"}) {
        CAPTURE(text);
        write_file(wrong, text);
        const Outcome outcome = run(plprove + " recommend " + wrong);
        CHECK(outcome.status == 2);
        CHECK(outcome.out.empty());
        CHECK(!outcome.err.empty());
    }
    CHECK(run(plprove + " recommend 5*P/P/P/P").status == 2);
    CHECK(run(plprove + " recommend").status == 3);
}
