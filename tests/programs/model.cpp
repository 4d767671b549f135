// `plprove model`: what it prints, writes and refuses.
#include "tests/support/program.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <string>

namespace {
const std::string plcheck = PLCHECK;
const std::string plprove = PLPROVE;
const std::string models = std::string(SOURCE_DIR) + "/models/";
const std::string committed = std::string(SOURCE_DIR) + "/certs/models/";
} // namespace

TEST_CASE("plprove model writes the committed certificates, byte by byte") {
    for (const std::string name : {"p3p", "three_points_upright", "rolling_shutter", "p2p1l"}) {
        const Outcome outcome = run(plprove + " model " + models + name + ".model -o -");
        CHECK(outcome.status == 0);
        CHECK(outcome.err.empty());
        CHECK(outcome.out == read_file(committed + name + ".plc"));
    }
}

TEST_CASE("plprove model reports to people and to machines") {
    const Outcome people = run(plprove + " model " + models + "p3p.model");
    CHECK(people.status == 0);
    CHECK(people.out.find("12 data, 3 unknowns, 3 equations\n") != std::string::npos);
    CHECK(people.out.find("claimed 8, at least 8, at most 8: exactly 8\n") != std::string::npos);
    const Outcome machines = run(plprove + " model --json - < " + models + "p3p.model");
    const auto json = nlohmann::json::parse(machines.out);
    CHECK(json["model"] == "p3p");
    CHECK(json["minimal"] == true);
    CHECK(json["at_least"] == 8);
    CHECK(json["at_most"] == 8);
}

TEST_CASE("plprove model writes scripts with all data, unknowns, equations and conditions") {
    const std::string file = models + "rolling_shutter.model";
    for (const std::string language : {"--macaulay2", "--julia"}) {
        CAPTURE(language);
        const std::string mark = language == "--julia" ? "_" : "'";
        const Outcome outcome = run(plprove + " model " + file + " " + language);
        CHECK(outcome.status == 0);
        CHECK(outcome.err.empty());
        CHECK(outcome.out == run(plprove + " model - " + language + " < " + file).out);
        // x[6][3], t[3], and what is computed: its name is no other's.
        for (const std::string& name :
             {"x" + mark + "6" + mark + "3", "t" + mark + "3", "t" + mark + mark + "3"})
            CHECK(outcome.out.find(name) != std::string::npos);
        CHECK(run(plprove + " model " + file + " --json " + language).status == 3);
    }
    CHECK(run(plprove + " model " + models + "p3p.model --macaulay2 --julia").status == 3);
}

TEST_CASE("Macaulay2 counts as many zeros as plprove, or some for each solution that counts once") {
    if (run("command -v M2").status != 0) {
        MESSAGE("skipped: there is no program M2 on the PATH");
        return;
    }
    const TemporaryFolder folder;
    const std::string script = (folder / "model.m2").string();
    const std::string upright = (folder / "upright.model").string(); // has names with _
    REQUIRE(run(plprove + " model --from 'upright: 3*P/P' -o " + upright).status == 0);
    REQUIRE(run(plprove + " model " + upright + " --macaulay2 -o " + script).status == 0);
    CHECK(run("M2 --script " + script).out.ends_with("\ndimension  0\nsolutions  4\n"));
    const std::map<std::string, int> zeros{{"p3p", 8},          {"apollonius", 2},
                                           {"transversals", 2}, {"rolling_shutter", 20},
                                           {"two_circles", 8},  {"six_points_focal", 4 * 15}};
    for (const auto& [name, count] : zeros) {
        CAPTURE(name);
        const std::string file = models + name + ".model";
        REQUIRE(run(plprove + " model " + file + " --macaulay2 -o " + script).status == 0);
        const Outcome outcome = run("M2 --script " + script);
        CHECK(outcome.err.empty());
        const std::string unknowns = std::to_string(
            nlohmann::json::parse(run(plprove + " model --json " + file).out)["unknowns"]
                .get<int>());
        const std::string counted = name == "six_points_focal" || name == "transversals"
                                        ? "counted    finitely many values\n"
                                        : "";
        CHECK(outcome.out ==
              "equations  " + unknowns + "\nunknowns   " + unknowns + "\nrank       " + unknowns +
                  ", at a known solution\nminimal    yes: the known solution is "
                  "regular\n" +
                  counted + "dimension  0\nsolutions  " + std::to_string(count) + '\n');
    }
}

TEST_CASE("export writes the scripts of a problem's model, in all views and for all cameras") {
    const TemporaryFolder folder;
    const std::string file = (folder / "written.model").string();
    for (const std::string problem : {"Chicago", "5*P/P + a/-", "projective: 6*P/P/P",
                                      "focal: 3*PL/PL + 4*P/P", "3*P/P/P/P + 2*a/a/a/a"})
        for (const std::string language : {"--macaulay2", "--julia"}) {
            CAPTURE(problem);
            REQUIRE(run(plprove + " model --from '" + problem + "' -o " + file).status == 0);
            const Outcome script = run(plprove + " model " + file + " " + language);
            CHECK(script.out.find(problem == "Chicago" ? "2*Pa/Pa/Pa + P/P/P" : problem) !=
                  std::string::npos);
            CHECK(run(plprove + " export " + language + " '" + problem + "'").out == script.out);
        }
    for (const std::string problem : {"2*-/-/-(Pa)", "40*-/P/P", "P//P"}) {
        CAPTURE(problem);
        const Outcome refused = run(plprove + " export --julia '" + problem + "'");
        CHECK(refused.status == 2);
        CHECK(refused.err == run(plprove + " model --from '" + problem + "'").err);
        CHECK(!refused.err.empty());
    }
}

TEST_CASE("Macaulay2 finds by ranks which problems are minimal, and which fix their cameras") {
    if (run("command -v M2").status != 0) {
        MESSAGE("skipped: there is no program M2 on the PATH");
        return;
    }
    struct Verdict {
        bool minimal, camera_minimal;
    };
    const std::map<std::string, Verdict> problems{
        {"2*Pa/Pa/Pa + P/P/P", {true, true}},
        {"2*Pa/Pa/Pa + Pab/Pa/P", {false, true}}, // the pin dangles
        {"2*Pab/Pa/Pa + P/P/P + a/-/-", {false, true}},
        {"3*P/P/P + a/a/a", {true, true}},
        {"P/P/P + 4*a/a/a", {true, true}},
        {"Pabcdefg/Pabcdefg/Pabcdefg + P/a/a", {false, false}},
        {"11*P/P/-", {false, false}},
        {"6*P/P", {false, false}},
        {"5*P/P + a/-", {false, true}},
        {"Pa/P/P + 2*-/a/a + P/P/P(a)", {false, false}},
        {"projective: 6*P/P/P", {true, true}},
    };
    const TemporaryFolder folder;
    const std::string path = (folder / "problem.m2").string();
    for (const auto& [problem, verdict] : problems) {
        CAPTURE(problem);
        std::string script = run(plprove + " export --macaulay2 '" + problem + "'").out;
        const std::size_t counting = script.find("-- The count may take long");
        REQUIRE(counting != std::string::npos);
        write_file(path, script.substr(0, counting));
        const Outcome outcome = run("M2 --script " + path);
        CHECK(outcome.status == 0);
        CHECK(outcome.err.empty());
        const auto says = [&](const std::string& words) {
            return outcome.out.find(words) != std::string::npos;
        };
        CHECK(says("\nminimal    yes: ") == verdict.minimal);
        CHECK(says("\nminimal    not shown: ") == !verdict.minimal);
        CHECK(says("\ncounted    finitely many values") == verdict.camera_minimal);
        CHECK(says("\ncounted    not shown: ") == !verdict.camera_minimal);
    }
}

TEST_CASE("a script without a known solution counts zeros for random data") {
    // There are no data to choose, and a cubic equation is not solved for unknowns.
    const TemporaryFolder folder;
    const std::string file = (folder / "none.model").string();
    write_file(file, "model none\ndata a\nunknown x\nequation x^3 = 2*x^2 - 7\n");
    const std::string script = run(plprove + " model --macaulay2 " + file).out;
    CHECK(script.find("for random data, and counts") != std::string::npos);
    CHECK(script.find("known =") == std::string::npos);
    CHECK(script.find("\nscan(conditions") != std::string::npos);
}

TEST_CASE("plprove model writes point-line problems and programs as models, which it reads") {
    const TemporaryFolder folder;
    const std::string file = (folder / "written.model").string();
    const auto at_least = [&] {
        return nlohmann::json::parse(run(plprove + " model --json " + file).out)["at_least"];
    };
    REQUIRE(run(plprove + " model --from 'upright: 3*P/P' -o " + file).status == 0);
    CHECK(at_least() == 4);
    const std::string program = (folder / "conics.m2").string();
    write_file(program, "R = QQ[a,b][x,y]\nI = ideal(x^2 + y^2 - a, x*y - b)\n");
    REQUIRE(run(plprove + " model --import " + program + " -o " + file).status == 0);
    CHECK(at_least() == 4);
    CHECK(run(plprove + " model --import - < " + program).out.find("unknown x, y\n") !=
          std::string::npos);
    write_file(program, "R = QQ[x]\nI = ideal(x^2 + y)\n");
    CHECK(run(plprove + " model --import " + program).err ==
          "plprove: " + program +
              ", line 2, column 17: found 'y', which is no variable and no function that is "
              "imported: did you mean 'x'?\n");
    CHECK(run(plprove + " model --from 'P//P'").status == 2);
    CHECK(run(plprove + " model --from '40*-/P/P'").status == 2);
    CHECK(run(plprove + " model --from 5*P/P --json").status == 3);
    CHECK(run(plprove + " model --from 5*P/P " + file).status == 3);
}

TEST_CASE("written models have no solutions with two cameras in one place") {
    // Such cameras would satisfy what two views say of each other. Without them there are 8
    // solutions (tests/families/three_views_degrees.py), as with the views in another order.
    const TemporaryFolder folder;
    const std::string file = (folder / "written.model").string();
    const std::string problem = "'upright: a/Pa/Pa + 3*P/-/P + P/P/-'";
    REQUIRE(run(plprove + " model --from " + problem + " -o " + file).status == 0);
    CHECK(nlohmann::json::parse(run(plprove + " model --json " + file).out)["at_least"] == 8);
}

TEST_CASE("plprove model refuses what is no model, and writes nothing") {
    const TemporaryFolder folder;
    const std::string file = (folder / "wrong.model").string();
    const std::string certificate = (folder / "wrong.plc").string();
    const auto complaint = [&](const std::string& text) {
        write_file(file, text);
        const Outcome outcome = run(plprove + " model " + file + " -o " + certificate);
        CHECK(outcome.status == 2);
        CHECK(outcome.out.empty());
        CHECK(!std::filesystem::exists(certificate));
        return outcome.err;
    };
    CHECK(complaint("model m\nunknown x\nequation y = 1\n") ==
          "plprove: " + file +
              ", line 3, column 10: found 'y', which has no meaning here: did you mean 'x'?\n");
    CHECK(complaint("model m\ndata a\nunknown x, y\nequation x = a\nequation x^2 = a^2\n")
              .starts_with("plprove: nothing was found to certify: the equations have no "
                           "solutions, or infinitely many"));
    CHECK(complaint(std::string(2'000'000, '\n'))
              .starts_with("plprove: a model has at most 1048576 bytes"));
    CHECK(run(plprove + " model " + file + ".none").status == 2);
    CHECK(run(plprove + " model").status == 3);
}

TEST_CASE("plprove model --lift writes another certificate of the same, each time the same") {
    const TemporaryFolder folder;
    const std::string file = (folder / "lifted.plc").string();
    const std::string model = models + "p3p.model";
    const Outcome found = run(plprove + " model " + model + " --lift -o " + file);
    CHECK(found.status == 0);
    CHECK(found.err.empty());
    CHECK(found.out.find("claimed 8, at least 8, at most 8: exactly 8\n") != std::string::npos);
    const std::string written = read_file(file);
    CHECK(written != read_file(committed + "p3p.plc"));
    CHECK(written == run(plprove + " model " + model + " --lift -o -").out);
    CHECK(run(plcheck + " --quiet --expect " + model + " --degree 8 " + file).status == 0);
    CHECK(run(plprove + " model " + model + " --lift --julia").status == 3);
}

TEST_CASE("plprove template writes a solver, the same each time, and reports its size") {
    const TemporaryFolder folder;
    const std::string solver = (folder / "p3p.py").string();
    const std::string command = plprove + " template " + models + "p3p.model";
    const Outcome people = run(command + " -o " + solver);
    CHECK(people.status == 0);
    CHECK(people.out.find("solutions   8, complex, for generic data\n") != std::string::npos);
    const Outcome text = run(command);
    CHECK(text.status == 0);
    CHECK(text.err.empty());
    CHECK(text.out == read_file(solver));
    const auto json = nlohmann::json::parse(run(command + " --json -o " + solver).out);
    CHECK(json["solutions"] == 8);
    CHECK(json["columns"] == json["rows"].get<int>() + 8);
    CHECK(run(command + " --json").status == 3);
}
