// `plprove solve` and `plprove start` as their users run them; plcheck replays the certificates.
#include "tests/support/program.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

namespace {

using Json = nlohmann::json;

const std::string plcheck = PLCHECK;

/// Runs plprove in a folder, with a cache for starts there.
class Session {
public:
    Outcome plprove(const std::string& arguments) const {
        return run("cd " + folder_.path().string() +
                   " && XDG_CACHE_HOME=cache-is-not-absolute HOME=" + folder_.path().string() +
                   " " PLPROVE " " + arguments);
    }
    std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
    Json json(const std::string& name) const { return Json::parse(read_file(folder_ / name)); }

private:
    TemporaryFolder folder_;
};

/// Images of the Chicago problem with few digits, which a degree file holds exactly.
std::string integer_images() {
    const auto feature = [](const std::string& a, const std::string& b, const std::string& c) {
        return R"({"views": [)" + a + ", " + b + ", " + c + "]}";
    };
    const auto pin = [](const std::string& x, const std::string& y) {
        return R"({"point": )" + x + R"(, "lines": {"a": [)" + x + ", " + y + "]}}";
    };
    const auto point = [](const std::string& x) { return R"({"point": )" + x + "}"; };
    return R"({"problem": "2*Pa/Pa/Pa + P/P/P", "features": [)" +
           feature(pin("[0.25, 0.5]", "[1, 3]"), pin("[\"1/3\", -0.5]", "[2, 1]"),
                   pin("[-0.2, 0.1]", "[1, 1]")) +
           ", " +
           feature(pin("[-0.7, 0.3]", "[0, 1]"), pin("[0.9, 0.4]", "[3, 2]"),
                   pin("[0.6, -0.8]", "[1.5, 2]")) +
           ", " + feature(point("[0.11, -0.6]"), point("[-0.4, 0.7]"), point("[0.3, 0.9]")) + "]}";
}

} // namespace

TEST_CASE("the examples have all solutions, and the starts are kept") {
    const Session session;
    for (const char* name : {"Chicago", "Cleveland", "five-point"}) {
        CAPTURE(name);
        REQUIRE(
            session.plprove(std::string("solve --example ") + name + " -o images.json").status ==
            0);
        const std::string problem = session.json("images.json")["problem"];
        const Outcome outcome =
            session.plprove("solve '" + problem + "' images.json --json -o answer.json");
        CHECK(outcome.status == 0);
        CHECK(outcome.out.empty());
        const Json answer = session.json("answer.json");
        CHECK(answer["found"] == answer["degree"]);
        CHECK(answer["complete"] == "certified");
        CHECK(answer["lost"] == 0);
        CHECK(answer["moved"] == 0);
        const Outcome table = session.plprove("solve '" + problem + "' images.json");
        CHECK(table.out.starts_with("problem     " + problem + "\nsolutions   " +
                                    std::to_string(answer["found"].get<int>()) + " of "));
        CHECK(table.out == session.plprove("solve '" + problem + "' images.json").out);
    }
    CHECK(std::filesystem::exists(session / ".cache/pointline/2394.start"));
    CHECK(std::filesystem::exists(session / ".cache/pointline/6722.start"));
}

TEST_CASE("real solutions come first, then those with fewer points in front; by any number of "
          "threads") {
    const Session session;
    session.plprove("solve --example Chicago -o images.json");
    session.plprove("solve 2394 images.json --json -o answer.json");
    session.plprove("solve 2394 images.json --json --threads 3 -o by_threads.json");
    CHECK(read_file(session / "by_threads.json") == read_file(session / "answer.json"));
    const Json solutions = session.json("answer.json")["solutions"];
    for (std::size_t i = 1; i < solutions.size(); ++i) {
        const Json &before = solutions[i - 1], &after = solutions[i];
        CHECK((before["real"] || !after["real"]));
        if (after["real"]) CHECK(before["in_front"] >= after["in_front"]);
    }
    for (const Json& solution : solutions) {
        if (!solution["real"]) continue;
        CHECK(solution["cameras"][0]["R"] == Json({1, 0, 0, 0, 1, 0, 0, 0, 1}));
        double square = 0; // the first camera sees the second centre at distance 1
        for (const double t : solution["cameras"][1]["t"])
            square += t * t;
        CHECK(square == doctest::Approx(1));
    }
}

TEST_CASE("a certificate for exactly the given images is replayed by plcheck") {
    const Session session;
    write_file(session / "images.json", integer_images());
    const Outcome outcome = session.plprove("solve 2394 images.json --certify mine.plc");
    CHECK(outcome.status == 0);
    CHECK(outcome.out.find("certificate of 312 solutions for exactly these images") !=
          std::string::npos);
    const std::string file = read_file(session / "mine.plc");
    // The first point is (1/4, 1/2), in integers (1, 2, 4).
    CHECK(file.find("image Pa/Pa/Pa view point 1 2 4 toward") != std::string::npos);
    const Outcome replayed = run(plcheck + " " + (session / "mine.plc").string());
    CHECK(replayed.status == 0);
    CHECK(replayed.out.find("at least 312 solutions") != std::string::npos);
}

TEST_CASE("a certificate is for exactly the images in pixels, or says how far they are from its") {
    const Session session;
    session.plprove("solve --example Cleveland -o images.json");
    const auto certify = [&] {
        const Outcome outcome =
            session.plprove("solve '3*P/P/P + a/a/a' images.json --certify mine.plc --json");
        CHECK(outcome.status == 0);
        CHECK(run(plcheck + " " + (session / "mine.plc").string()).status == 0);
        return Json::parse(outcome.out)["certificate"];
    };
    const Json certificate = certify();
    CHECK(certificate["exact"] == true);
    CHECK(certificate["moved"] == 0);
    CHECK(certificate["solutions"] == 216);

    Json images = session.json("images.json");
    images["features"][0]["views"][0]["point"][0] = "320.1234567890123456789012345";
    write_file(session / "images.json", images.dump());
    const Json of_long_decimals = certify();
    CHECK(of_long_decimals["exact"] == false);
    CHECK(of_long_decimals["moved"] < 2e-18);
    CHECK(of_long_decimals["moved"] > 0);
}

TEST_CASE("certificates for two views are of their five points") {
    const Session session;
    for (const std::string problem : {"5*P/P", "Pa/Pa + 4*P/P + a/a"}) {
        CAPTURE(problem);
        session.plprove("solve --example '" + problem + "' -o images.json");
        const Outcome outcome =
            session.plprove("solve '" + problem + "' images.json --certify mine.plc --json");
        CHECK(outcome.status == 0);
        const Json certificate = Json::parse(outcome.out)["certificate"];
        CHECK(certificate["exact"] == true);
        CHECK(certificate["solutions"] == 20);
        const Outcome replayed = run(plcheck + " " + (session / "mine.plc").string());
        CHECK(replayed.status == 0);
        CHECK(replayed.out.find("VERIFIED: at least 20 solutions of 5*P/P") != std::string::npos);
    }
    // More digits than nine: those nearby.
    session.plprove("solve --example five-point -o images.json");
    Json images = session.json("images.json");
    images["features"][1]["views"][1]["point"][0] = "100.123456789012345";
    write_file(session / "images.json", images.dump());
    const Outcome outcome =
        session.plprove("solve five-point images.json --certify mine.plc --json");
    CHECK(outcome.status == 0);
    const Json certificate = Json::parse(outcome.out)["certificate"];
    CHECK(certificate["exact"] == false);
    CHECK(certificate["moved"] < 2e-9);
    CHECK(certificate["moved"] > 0);
    CHECK(run(plcheck + " " + (session / "mine.plc").string()).status == 0);
}

TEST_CASE(
    "certificates are for problems in any order of views, and for those that are not reduced") {
    const Session session;
    for (const std::string problem :
         {"Pa/a/Pa + Pa/Pa/a + Pa/a/P + 3*P/-/P", "P/P/P + a/Pa/a + a/P/P + 4*P/P/-"}) {
        CAPTURE(problem);
        session.plprove("solve --example '" + problem + "' -o images.json");
        const Outcome outcome =
            session.plprove("solve '" + problem + "' images.json --certify mine.plc --json");
        CHECK(outcome.status == 0);
        const Json answer = Json::parse(outcome.out);
        CHECK(answer["certificate"]["solutions"] == answer["degree"]);
        const Outcome replayed = run(plcheck + " " + (session / "mine.plc").string());
        CHECK(replayed.status == 0);
        CHECK(replayed.out.find("at least " + std::to_string(answer["degree"].get<int>()) +
                                " solutions") != std::string::npos);
    }
}

TEST_CASE("pins that miss their points are moved, and the answer says how far") {
    const Session session;
    session.plprove("solve --example Chicago -o images.json");
    Json images = session.json("images.json");
    Json& line = images["features"][0]["views"][0]["lines"]["a"];
    line[0][0] = line[0][0].get<double>() + 0.5;
    write_file(session / "noisy.json", images.dump());
    const Outcome outcome = session.plprove("solve 2394 noisy.json --json");
    CHECK(outcome.status == 0);
    const Json answer = Json::parse(outcome.out);
    CHECK(answer["moved"] > 0.01);
    CHECK(answer["moved"] < 0.5);
}

TEST_CASE("the problem may stand in the file alone") {
    const Session session;
    session.plprove("solve --example five-point -o images.json");
    const Outcome named = session.plprove("solve five-point images.json");
    const Outcome alone = session.plprove("solve images.json");
    CHECK(alone.status == 0);
    CHECK(alone.out == named.out);
}

TEST_CASE("a problem without a file is refused, however long it is") {
    const Session session;
    std::string long_one = "P/P";
    for (int i = 0; i < 2000; ++i)
        long_one += " + P/P";
    for (const std::string& problem : {std::string("five-point"), "'" + long_one + "'"}) {
        const Outcome outcome = session.plprove("solve " + problem);
        CHECK(outcome.status == 3);
        CHECK(outcome.err.find("solve needs a problem and a file of images") != std::string::npos);
    }
}

TEST_CASE("pixels without cameras are warned of, on standard error and in JSON") {
    const Session session;
    session.plprove("solve --example five-point -o images.json");
    CHECK(session.plprove("solve images.json").err.find("warning") == std::string::npos);
    Json images = session.json("images.json");
    images.erase("cameras");
    write_file(session / "pixels.json", images.dump());
    const Outcome outcome = session.plprove("solve pixels.json --json");
    CHECK(outcome.status == 0);
    const Json warnings = Json::parse(outcome.out)["warnings"];
    REQUIRE(warnings.size() == 1);
    CHECK(outcome.err.find("warning: " + warnings[0].get<std::string>()) != std::string::npos);
    CHECK(outcome.err.find("coordinates look like pixels") != std::string::npos);
}

TEST_CASE("those who want real solutions get no others, and hear how many there are") {
    const Session session;
    session.plprove("solve --example five-point -o images.json");
    const Json all = Json::parse(session.plprove("solve images.json --json").out);
    const Json real = Json::parse(session.plprove("solve images.json --json --real").out);
    CHECK(real["found"] == 20);
    CHECK(real["complete"] == "certified");
    CHECK(real["solutions"].size() == 8);
    for (std::size_t i = 0; i < 8; ++i)
        CHECK(real["solutions"][i] == all["solutions"][i]);
    CHECK(session.plprove("solve images.json --real --certify mine.plc").status == 3);
}

TEST_CASE("what rounding errors make of enormous coordinates is no solution") {
    const Session session;
    session.plprove("solve --example five-point -o images.json");
    Json images = session.json("images.json");
    images.erase("cameras");
    for (Json& feature : images["features"])
        for (Json& view : feature["views"])
            for (Json& x : view["point"])
                x = std::round(1e6 * x.get<double>());
    write_file(session / "far.json", images.dump());
    const Outcome outcome = session.plprove("solve far.json --json");
    CHECK(outcome.status == 1);
    const Json answer = Json::parse(outcome.out);
    CHECK(answer["complete"] == "unknown");
    CHECK(answer["found"].get<int>() < 20);
    for (const Json& solution : answer["solutions"])
        CHECK(solution["residual"].get<double>() < 1e7);
}

TEST_CASE("shared lines, four views and uncalibrated cameras are solved from a file, too") {
    const Session session;
    for (const auto& [problem, degree] : std::vector<std::pair<std::string, int>>{
             {"3*PL/PL/PL/PL + a/a/a/a", 32}, {"projective: 7*P/P", 3}}) {
        CAPTURE(problem);
        REQUIRE(session.plprove("solve --example '" + problem + "' -o images.json").status == 0);
        const Outcome outcome = session.plprove("solve images.json --json");
        CHECK(outcome.status == 0);
        CHECK(outcome.err.empty());
        const Json answer = Json::parse(outcome.out);
        CHECK(answer["problem"] == problem);
        CHECK(answer["found"] == degree);
        CHECK(answer["complete"] == "certified");
        CHECK(std::ssize(answer["solutions"]) == degree);
        const std::string table = session.plprove("solve images.json").out;
        CHECK(table.starts_with("problem     " + problem + "\nsolutions   " +
                                std::to_string(degree) + " of " + std::to_string(degree) +
                                ", all: the degree is certified\nreal        "));
        const Outcome certify = session.plprove("solve images.json --certify mine.plc");
        CHECK(certify.status == 2);
        CHECK(certify.err.find("--certify and --start are for two or three calibrated views") !=
              std::string::npos);
        const Outcome start = session.plprove("start '" + problem + "' -o mine.start");
        CHECK(start.status == 2);
        CHECK(start.err.find("`plprove solve` solves " + problem + " without") !=
              std::string::npos);
        const Json images = session.json("images.json");
        CHECK(images.contains("cameras") != problem.starts_with("projective"));
    }
    // What uncalibrated cameras do not have.
    Json images = session.json("images.json");
    images["cameras"] = {nullptr, nullptr};
    write_file(session / "more.json", images.dump());
    const Outcome more = session.plprove("solve more.json");
    CHECK(more.status == 2);
    CHECK(more.err.find("cameras: uncalibrated cameras have no intrinsics: leave \"cameras\" "
                        "out") != std::string::npos);
}

TEST_CASE("what cannot be solved is said, and is no mistake of notation") {
    const Session session;
    for (const auto& [problem, what] : std::vector<std::pair<std::string, std::string>>{
             {"'P/P/P/P'", "P/P/P/P is none of these"},
             {"'P/P/P/- + 5*P/P/P/P'", " is none of these"},
             {"'shared-focal: 6*P/P'", "shared-focal: 6*P/P has others"}}) {
        CAPTURE(problem);
        for (const std::string command : {"solve --example ", "start -o x.start "}) {
            const Outcome outcome = session.plprove(command + problem);
            CHECK(outcome.status == 2);
            CHECK(outcome.err.find("solve takes ") != std::string::npos);
            CHECK(outcome.err.find(what) != std::string::npos);
        }
    }
}

TEST_CASE("a start is a file that solve takes, and that is refused when damaged") {
    const Session session;
    CHECK(session.plprove("start 2394 -o chicago.start --seed 5").status == 0);
    session.plprove("solve --example Chicago -o images.json");
    const std::string solve = "solve 2394 images.json --start chicago.start --json";
    const Outcome outcome = session.plprove(solve);
    CHECK(outcome.status == 0);
    CHECK(Json::parse(outcome.out)["found"] == 312);
    CHECK(!std::filesystem::exists(session / ".cache"));
    std::string text = read_file(session / "chicago.start");
    text[text.size() / 2] = text[text.size() / 2] == '1' ? '2' : '1';
    write_file(session / "chicago.start", text);
    const Outcome damaged = session.plprove(solve);
    CHECK(damaged.status == 2);
    CHECK(damaged.out.empty());
    CHECK(damaged.err.find("chicago.start") != std::string::npos);
    CHECK(session.plprove("start '5*P/P' -o five.start").status == 2);
    CHECK(!std::filesystem::exists(session / "five.start"));
}

TEST_CASE("bad input is refused with status 2, says where, and writes nothing") {
    const Session session;
    session.plprove("solve --example Chicago -o images.json");
    write_file(session / "broken.json", read_file(session / "images.json").substr(0, 100));
    Json equal = session.json("images.json");
    equal["features"][1]["views"][2]["point"] = equal["features"][0]["views"][2]["point"];
    write_file(session / "equal.json", equal.dump());
    const std::vector<std::pair<std::string, std::string>> bad{
        {"2394 missing.json", "cannot read missing.json"},
        {"2394 broken.json", "broken.json: this is no JSON: parse error at line"},
        {"'3*P/P/P + a/a/a' images.json", "images.json: problem: expected images of 3*P/P/P"},
        {"'4*P/P' images.json", "images.json: problem: expected"},
        {"2394 equal.json", "view 3 sees feature 1 (Pa/Pa/Pa) and feature 2 (Pa/Pa/Pa) at the same "
                            "point"}};
    for (const auto& [arguments, expected] : bad) {
        CAPTURE(arguments);
        const Outcome outcome =
            session.plprove("solve " + arguments + " --json -o answer.json --certify mine.plc");
        CHECK(outcome.status == 2);
        CHECK(outcome.out.empty());
        CHECK(outcome.err.find(expected) != std::string::npos);
        CHECK(!std::filesystem::exists(session / "answer.json"));
        CHECK(!std::filesystem::exists(session / "mine.plc"));
    }
    CHECK(session.plprove("solve --example 4*P/P").status == 2);
    CHECK(session.plprove("solve").status == 3);
    CHECK(session.plprove("solve 2394").status == 3);
}
