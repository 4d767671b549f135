// `plprove solve` of models: what it prints, and what it refuses.
#include "tests/support/program.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace {
const std::string plprove = PLPROVE;
const std::string p3p = std::string(SOURCE_DIR) + "/models/p3p.model";
} // namespace

TEST_CASE("plprove solve solves a model for its example, with any number of threads") {
    const TemporaryFolder folder;
    const std::string data = (folder / "data.json").string();
    REQUIRE(run(plprove + " solve --example " + p3p + " -o " + data).status == 0);
    const Outcome people = run(plprove + " solve " + p3p + ' ' + data);
    CHECK(people.status == 0);
    CHECK(people.err.empty());
    CHECK(people.out.find("solutions   8 of 8: as many as there are modulo a prime\n") !=
          std::string::npos);
    CHECK(people.out.find("\n1           s = [") != std::string::npos);
    const Outcome machines = run(plprove + " solve --json --threads 1 " + p3p + ' ' + data);
    const auto json = nlohmann::json::parse(machines.out);
    CHECK(json["degree"] == 8);
    CHECK(json["solutions"].size() == 8);
    CHECK(json["solutions"][0]["real"] == true);
    CHECK(json["solutions"][0]["unknowns"]["s"].size() == 3);
    CHECK(run(plprove + " solve --json --threads 3 " + p3p + ' ' + data).out == machines.out);
    const auto real =
        nlohmann::json::parse(run(plprove + " solve --json --real " + p3p + ' ' + data).out);
    CHECK(real["found"] == 8);
    for (const auto& solution : real["solutions"])
        CHECK(solution["real"] == true);
}

TEST_CASE("plprove solve says which entry of the data is wrong, and how") {
    const TemporaryFolder folder;
    const std::string data = (folder / "data.json").string();
    const auto complaint = [&](const std::string& text) {
        write_file(data, text);
        const Outcome outcome = run(plprove + " solve " + p3p + ' ' + data);
        CHECK(outcome.status == 2);
        CHECK(outcome.out.empty());
        return outcome.err;
    };
    const std::string start = "plprove: " + data;
    const std::string x = R"("x": [[1, 0, 1], [0, 1, 1], [0, 0, 1]])";
    CHECK(complaint("{" + x + "}") == start + " has no entry 'd': it needs a list of 3 numbers\n");
    CHECK(complaint("{" + x + R"(, "d": [1, 2, 3], "dd": 1})") ==
          start + ": the model has no data 'dd': did you mean 'd'?\n");
    CHECK(complaint("{" + x + R"(, "d": [1, 2]})") ==
          start + ": found a list of 2 values at d: d is a list of 3 numbers\n");
    CHECK(complaint(R"({"x": [[1, 0, 1], [0, "a", 1], [0, 0, 1]], "d": [1, 2, 3]})") ==
          start + ": found '\"a\"' at x[2][2]: x is a list of 3 lists of 3 numbers\n");
    CHECK(complaint("{" + x + R"(, "d": [1, 2, 3], "d": [1, 2, 3]})") ==
          start + ": the entry 'd' is there twice: leave one\n");
    CHECK(complaint("[]").starts_with(start + " is no JSON object"));
    CHECK(complaint("{").starts_with(start + " is no JSON: "));
    CHECK(complaint("{" + x + R"(, "d": [1, 2, 1e999]})").starts_with(start + " is no JSON: "));
}

TEST_CASE("plprove solve refuses what it cannot do with a model") {
    CHECK(
        run(plprove + " solve " + p3p).err.starts_with("plprove: solve needs a file of data for "));
    CHECK(run(plprove + " solve " + p3p + " none.json --start none").status == 2);
    CHECK(run(plprove + " solve none.model none.json").status == 2);
    const TemporaryFolder folder;
    const std::string wrong = (folder / "wrong.model").string();
    write_file(wrong, "model m\ndata a\nunknown x\nequation y = a\n");
    CHECK(run(plprove + " solve " + wrong + ' ' + wrong)
              .err.starts_with("plprove: " + wrong + ", line 4, column 10: found 'y'"));
}
