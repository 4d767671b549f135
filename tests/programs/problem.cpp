// plprove problem, show and export of scripts, and plcheck on the certificates of verdicts, as
// users run them.
#include "tests/support/programs.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

namespace {

nlohmann::json decide(const std::string& spec) {
    const Outcome outcome = run(plprove + " problem --json '" + spec + "'");
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    return nlohmann::json::parse(outcome.out);
}

} // namespace

TEST_CASE("a minimal problem is found in the catalogue, however it is named") {
    for (const char* spec : {"2*Pa/Pa/Pa + P/P/P", "#2394", "2394",
                             "{{0,1},{{{1,1},{1,1,1}},{{1,1},{1,1,1}},{{1,1},{1,1,1}}}}"}) {
        const auto report = decide(spec);
        CHECK(report["verdict"] == "minimal");
        CHECK(report["number"] == 2394);
        CHECK(report["families"]["plmp"] == "3002_1");
        CHECK(report["degree"]["value"] == 312);
        CHECK(report["degree"]["status"] == "certified");
    }
}

TEST_CASE("a problem that is no minimal one is told why") {
    CHECK(decide("3*P/P/P + P/P/a")["verdict"] == "camera-minimal");
    CHECK(decide("3*P/P/P + P/P/a")["families"]["trifocal_linear"] == true);
    CHECK(decide("4*P/P/P")["verdict"] == "over-constrained");
    CHECK(decide("P/P/P")["verdict"] == "under-constrained");
    CHECK(decide("5*P/P")["verdict"] == "minimal");
    const auto epipolar = decide("6*P/P/- + 5*P/-/P");
    CHECK(epipolar["verdict"] == "obstructed");
    CHECK(contains(epipolar["reasons"].dump(), "views 1 and 2 share 6 points"));
    const auto star = decide("Pabc/Pabc/Pabc + 5*-/P/P");
    CHECK(contains(star["reasons"].dump(), "view 1 sees only the point with 3 pins"));
}

TEST_CASE("an obstructed problem is in no family of minimal ones") {
    const std::string obstructed = "6*P/P/- + 5*P/-/P"; // views 1 and 3 share five points
    CHECK(decide(obstructed)["families"]["five_point_extension"] == false);
    const Outcome text = run(plprove + " problem '" + obstructed + "'");
    CHECK(!contains(text.out, "five-point"));
    CHECK(decide("3")["families"]["plmp"].is_null()); // a point with seven pins, complete
    CHECK(decide("6779")["families"]["five_point_extension"] == true);
}

TEST_CASE(
    "a problem of one's own in three calibrated views has its exact degree by its certificate") {
    const TemporaryFolder folder;
    const std::string file = (folder / "own.plc").string();
    for (const auto& [problem, degree] : std::map<std::string, int>{
             {"2*P/P/P + a/Pa/Pa + a/a/a", 240},
             {"3*P/P/P + P/P/a", 272},
             {"2*Pa/Pa/Pa + P/P/P + Pab/-/-", 312},
             {"2*PL/PL/PL + P/P/P + a/a/a", 216}, // two points imply the line L
             {"2*PLa/PLa/PLa + P/P/P", 312}}) {
        CAPTURE(problem);
        const Outcome text = run(plprove + " problem '" + problem + "' --certificate " + file);
        CHECK(text.status == 0);
        const std::string command = " --expect '" + problem + "' --degree ";
        const std::string degree_and_file = std::to_string(degree) + ' ' + file;
        CHECK(contains(text.out, "\ncheck       plcheck" + command + degree_and_file + '\n'));
        CHECK(run(plcheck + command + degree_and_file).status == 0);
        CHECK(run(plcheck + command + std::to_string(degree + 1) + ' ' + file).status == 1);
    }
    const std::string implied = "2*PL/PL/PL + P/P/P + a/a/a";
    CHECK(decide(implied)["degree"]["value"] == 216);
    CHECK(decide(implied)["degree"]["source"] == "that of 3*P/P/P + a/a/a");
    // A line that a view sees with one of its two points is not implied.
    const std::string other = "PL/PL/PL + PL/PL/L + 2*P/P/P";
    const Outcome text = run(plprove + " problem '" + other + "' --certificate " + file);
    CHECK(contains(text.out, "verdict     minimal"));
    CHECK(contains(text.out, "none on file"));
    CHECK(!contains(text.out, "\ncheck "));
    CHECK(contains(run(plcheck + " --expect '" + other + "' --degree 216 " + file).out,
                   "no file bounds its degree from below"));
    // Nor is one with more points.
    CHECK(!contains(run(plprove + " problem '3*PL/PL/PL + P/P/P'").out, "that of"));
}

TEST_CASE("a terminal problem is told from its class") {
    const std::string of_class = "#6723 (3*P/P/P + Pa/P/a), swap class #6723";
    const auto number_of = [](const std::string& spec) {
        const std::string text = run(plprove + " problem '" + spec + "'").out;
        const std::size_t begin = text.find("\nnumber      ") + 13;
        return text.substr(begin, text.find('\n', begin) - begin);
    };
    CHECK(number_of("3*P/P/P + P/P/a").starts_with("terminal problem of " + of_class));
    CHECK(number_of("P/P/a + 3*P/P/P").starts_with("terminal problem of " + of_class));
    CHECK(number_of("3*P/P/P + P/P/a + a/-/-").starts_with("reduces to a problem of " + of_class));
    CHECK(number_of("3*P/P/P + Pa/P/a + a/-/-").starts_with("reduces to " + of_class));
    CHECK(number_of("3*P/P/P + Pa/P/a").starts_with("#6723 of the label classes"));
    CHECK(number_of("3*P/P/P + P/Pa/a").starts_with("#6723 of the label classes"));
    CHECK(number_of("P/P/P + 2*a/a/a + a/P/P + P/Pa/a")
              .starts_with("with its dangling pins fixed, #"));
    CHECK(decide("3*P/P/P + P/P/a")["standing"] == "terminal problem");
    CHECK(decide("3*P/P/P + P/P/a")["class"] == "3*P/P/P + Pa/P/a");
    CHECK(decide("6723")["standing"] == "member");
}

TEST_CASE("a problem that is not minimal is told what is minimal one feature away") {
    const std::string text = run(plprove + " problem '3*P/P/P + P/-/P'").out;
    CHECK(contains(text, "\nhint        add -/P/P: minimal, #6725, degree 384\n"
                         "            add P/-/P: minimal, #6724, degree 160\n"));
    const auto json = decide("3*P/P/P + P/-/P");
    REQUIRE(json["hints"].size() == 6);
    CHECK(json["hints"][1]["add"] == "P/-/P");
    CHECK(json["hints"][1]["drop"].is_null());
    for (const auto& hint : json["hints"]) {
        const auto minimal = decide(hint["problem"]);
        CHECK(minimal["verdict"] == hint["verdict"]);
        CHECK(minimal["number"] == hint["number"]);
        CHECK(minimal["degree"] == hint["degree"]);
    }
    CHECK(!decide("2394").contains("hints"));
    // There are more than eight; the text shows the first.
    const std::string many = run(plprove + " problem 'P/P/P + 5*P/P/- + 3*a/P/a'").out;
    CHECK(contains(many, "more: --json lists all\n"));
}

TEST_CASE("text and JSON say the same") {
    const Outcome text = run(plprove + " problem '4*Pabc/Pab/P + Pa/a/-'");
    const auto json = decide("4*Pabc/Pab/P + Pa/a/-");
    CHECK(contains(text.out, "over-constrained by 1"));
    CHECK(json["constraints"] == 12);
    for (const auto& step : json["reduction"])
        CHECK(contains(text.out, step["feature"].get<std::string>() + " -> "));
}

TEST_CASE("a report fits 100 columns") {
    for (const char* spec :
         {"2394", "0", "3", "4*P/P/- + Pabcdefg/Pabcdefg/-", "3*P/P/P + P/P/a"}) {
        CAPTURE(spec);
        const std::string text = run(plprove + " problem '" + spec + "'").out;
        const auto report = decide(spec);
        std::string words; // without line ends and columns
        for (const std::string& line : lines_of(text)) {
            CHECK(line.size() <= 100);
            words += ' ' + line.substr(std::min(line.size(), line.find_first_not_of(' ')));
        }
        for (const auto& reason : report["reasons"])
            CHECK(contains(words, ' ' + reason.get<std::string>()));
    }
}

TEST_CASE("the certificate of a verdict proves it to the checker") {
    const TemporaryFolder folder;
    const auto file = (folder / "verdict.plc").string();
    for (const auto& [spec, verdict] : std::initializer_list<std::pair<const char*, const char*>>{
             {"2*Pa/Pa/Pa + P/P/P", "certified minimal"},
             {"3*P/P/P + P/P/a", "certified camera-minimal"},
             {"6*P/P/- + 5*P/-/P", "certified obstructed"},
             {"Pabcdefgh/Pabcdefgh/Pabcdefgh", "certified obstructed"},
             {"P/b/a + 10*P/P/-", "certified obstructed, class 130461"},
             {"4*Pabc/Pab/P", "certified over-constrained 1"},
             {"5*P/P + a/b", "certified camera-minimal"},
             // Pins that reduction removes make no obstruction.
             {"4*P/P + Pabcdefg/Pabcdefg", "certified minimal"},
             {"3*P/P/P + P/P/- + Pabcdefg/Pabcdefg/-", "certified minimal, class 6724"},
             {"2*P/P/P + a/a/a + 2*P/P/- + Pabcdef/Pabcdef/-", "certified minimal, class 6779"}}) {
        CAPTURE(spec);
        CHECK(run(plprove + " problem '" + spec + "' --certificate " + file).status == 0);
        const Outcome checked = run(plcheck + " " + file);
        CHECK(checked.status == 0);
        CHECK(contains(checked.out, verdict));
    }
}

TEST_CASE("evidence that needs more than a line of the format goes on in the next one") {
    const TemporaryFolder folder;
    const auto file = (folder / "verdict.plc").string();
    const std::string spec = "3*P/P/P + a/a/a + 70*-/-/-(abcdefghijklmnopqrstuvwxyz)";
    CHECK(run(plprove + " problem '" + spec + "' --certificate " + file).status == 0);
    std::size_t longest = 0;
    for (const std::string& line : lines_of(read_file(file)))
        longest = std::max(longest, line.size());
    CHECK(longest == 16384);
    const Outcome checked = run(plcheck + " " + file);
    CHECK(checked.status == 0);
    CHECK(contains(checked.out, "certified camera-minimal"));
}

TEST_CASE("a problem that leaves much of the scene open is certified soon") {
    const TemporaryFolder folder;
    const auto file = (folder / "verdict.plc").string();
    const std::string spec = "3*P/P/P + a/a/a + 990*P/-/-(abcdefghijklmnopqrstuvwxyz)";
    const Outcome outcome =
        run("ulimit -t 20; " + plprove + " problem '" + spec + "' --certificate " + file);
    CHECK(outcome.status == 0);
    const Outcome checked = run(plcheck + " " + file);
    CHECK(checked.status == 0);
    CHECK(contains(checked.out, "certified camera-minimal, class 6722"));
}

TEST_CASE("what is no problem is refused with the column") {
    const Outcome outcome = run(plprove + " problem 'P/P/P + ab/P/P'");
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(contains(outcome.err, "column 10"));
    CHECK(contains(outcome.err, "Definition 1"));
    CHECK(run(plprove + " show 'P/P'/").status == 2);
    CHECK(run(plprove + " export --julia 'P//P'").status == 2);
}
