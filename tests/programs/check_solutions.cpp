// Degrees of problems in general: what plprove writes, plcheck replays; and what plcheck says of
// files of solutions that hold, that are altered, and that lack what is expected.
#include "tests/support/program.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <map>

namespace {

const std::string plprove = PLPROVE;
const std::string plcheck = PLCHECK;
const std::string certs = SOURCE_DIR "/certs/";

std::string last_line(const Outcome& outcome) {
    return lines_of(outcome.out).back();
}

/// The file that FORMAT.md, section 14, shows.
std::string example() {
    const std::string format = read_file(certs + "FORMAT.md");
    const std::size_t start = format.find("\nplcert 2 solutions\n") + 1;
    return format.substr(start, format.find("```", start) - start);
}

/// By notation, the numbers in the column `degree` of certs/family-degrees.csv.
/// Those that are small enough for files of solutions.
std::map<std::string, int> degrees_on_file() {
    constexpr int most = 600;
    std::map<std::string, int> degrees;
    for (const std::string& line : lines_of(read_file(certs + "family-degrees.csv"))) {
        if (line.starts_with("#") || line.starts_with("family,")) continue;
        const std::size_t begin = line.find(',') + 1, end = line.find(',', begin);
        const int degree = std::stoi(line.substr(end + 1));
        if (degree <= most) degrees[line.substr(begin, end - begin)] = degree;
    }
    return degrees;
}

} // namespace

TEST_CASE("the file of solutions in FORMAT.md holds") {
    const TemporaryFolder folder;
    write_file(folder / "seven.plc", example());
    const Outcome outcome = run("cd " + folder.path().string() + " && " + plcheck + " seven.plc");
    CHECK(outcome.status == 0);
    CHECK(outcome.out == "seven.plc: 1 solution record holds, 0 refused\n"
                         "- projective: 7*P/P: certified at least 3 solutions\n"
                         "VERIFIED: at least 3 solutions of projective: 7*P/P (seven.plc)\n");
    CHECK(outcome.err.empty());
}

TEST_CASE("every degree of the families up to 600 is certified as a lower bound") {
    const Outcome outcome = run(plcheck + " --json " + certs + "solutions/plmp.plc " + certs +
                                "solutions/projective.plc");
    REQUIRE(outcome.status == 0);
    std::map<std::string, int> certified;
    const nlohmann::json report = nlohmann::json::parse(outcome.out);
    for (const auto& file : report["files"])
        for (const auto& record : file["solutions"])
            certified[record["problem"]] = record["certified_at_least"];
    CHECK(certified.size() > 300);
    CHECK(certified == degrees_on_file());
}

TEST_CASE("what the prover writes of a degree in general, the checker certifies") {
    const TemporaryFolder folder;
    const std::string file = (folder / "one.plc").string();
    for (const auto& [problem, degree, other] :
         {std::tuple{"projective: 7*P/P", 3, "projective:7*P/P"},
          {"projective: 3*PL/PL + 4*P/P", 2, "projective: 4*P/P + 3*PX/PX"},
          {"3*PL/PL + 2*P/P", 16, "2*P/P + 3*PL/PL"}}) {
        CAPTURE(problem);
        const Outcome written = run(plprove + " degree '" + problem + "' -o " + file);
        REQUIRE(written.status == 0);
        CHECK(contains(written.out, "of at least " + std::to_string(degree) + " solutions"));
        for (const std::string notation : {problem, other}) {
            const std::string expect = plcheck + " --quiet --expect '" + notation + "' ";
            const std::string number = std::to_string(degree);
            CHECK(run(expect + "--degree '>=" + number + "' " + file).status == 0);
            CHECK(run(expect + "--verdict minimal " + file).status == 0);
            const Outcome more =
                run(expect + "--degree '>=" + std::to_string(degree + 1) + "' " + file);
            CHECK(more.status == 1);
            CHECK(contains(more.out, "at least " + number + " solutions are certified"));
            const Outcome exactly = run(expect + "--degree " + number + " " + file);
            CHECK(exactly.status == 1);
            CHECK(contains(exactly.out, "no upper bound"));
        }
        const Outcome absent =
            run(plcheck + " --expect 'projective: 9*a/a/a' --degree '>=1' " + file);
        CHECK(absent.status == 1);
        CHECK(contains(last_line(absent), "add a file of solutions"));
    }
}

TEST_CASE("the same seed writes the same bytes, to a file or alone on standard output") {
    const std::string command = plprove + " degree 'projective: 7*P/P' --seed 4 -o ";
    const TemporaryFolder folder;
    const std::string file = (folder / "one.plc").string();
    REQUIRE(run(command + file).status == 0);
    CHECK(run(command + "-").out == read_file(file));
    const Outcome unsupported =
        run(plprove + " degree 'projective: 7*P/P' --at-least 2 -o " + file);
    CHECK(unsupported.status == 2);
    CHECK(contains(unsupported.err, "use --target"));
}

TEST_CASE("an altered file of solutions is refused with status 1 or 2") {
    const TemporaryFolder folder;
    const std::string file = (folder / "altered.plc").string();
    const auto judged = [&](const char* old, const char* replacement) {
        write_file(file, with(example(), old, replacement));
        return run(plcheck + " " + file);
    };
    CHECK(judged("view 31 80 -3", "view 31 80 0").status == 1);
    CHECK(judged("view 31 80 -3", "view 31 80").status == 2);
    CHECK(judged("projective: 7*P/P", "projective: 8*P/P").status == 2);
    CHECK(judged("projective: 7*P/P", "projective: 6*P/P").status == 2);
    CHECK(judged("real 5", "pair 5").status == 2);
    write_file(file, "plcert 2 solutions\n");
    const Outcome empty = run(plcheck + " " + file);
    CHECK(empty.status == 1);
    CHECK(contains(empty.err, "it has no record, so it proves nothing"));
}
