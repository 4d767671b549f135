// plcheck answers the question asked: the exit status, the last line and the JSON report say the
// same, for every kind of file and of mistake.
#include "tests/support/programs.h"

#include <nlohmann/json.hpp>

namespace {

const std::string schema = std::string(SOURCE_DIR) + "/docs/report.schema.json";
const std::string validate = std::string(SOURCE_DIR) + "/tests/support/validate " + schema + ' ';

/// The record of a class in a committed file of degrees.
std::string degree_record(std::size_t number) {
    const std::string file = read_file(certs + "degrees/three-points.plc");
    const std::size_t begin = file.find("\ndegree " + std::to_string(number) + ' ') + 1;
    return file.substr(begin, file.find("\ndegree ", begin) + 1 - begin);
}

/// The word after the name of a row of the table.
std::string first_number(const std::string& text, const std::string& name) {
    for (const std::string& line : lines_of(text)) {
        if (!line.starts_with(name)) continue;
        const std::string rest = line.substr(line.find_first_not_of(' ', name.size()));
        return rest.substr(0, rest.find(' '));
    }
    return "no such row";
}

/// A folder with files of each kind, good and bad, in which commands run.
class Folder {
public:
    Folder() {
        write("chicago.plc", run(plprove + " certify '2*Pa/Pa/Pa + P/P/P'").out);
        write("point.plc", "plcert 2 problem\nproblem 7*P/P/P\nverdict over-constrained 10\n");
        write("wrong.plc", "plcert 2 problem\nproblem 7*P/P/P\nverdict over-constrained 9\n");
        write("no-degrees.plc", "plcert 2 degrees\n");
        write("text", "hello\n");
        in("ln -s " + certs + " certs");
        write("degrees.plc", "plcert 2 degrees\n" + degree_record(2394) + degree_record(6725));
    }

    void write(const std::string& name, const std::string& bytes) {
        write_file(folder_ / name, bytes);
    }

    /// Runs a command there.
    Outcome in(const std::string& command) const {
        return run("cd " + folder_.path().string() + " && " + command);
    }

    Outcome check(const std::string& arguments) const { return in(plcheck + ' ' + arguments); }

private:
    TemporaryFolder folder_;
};

/// Checks that a run with these arguments ends so, in all its forms.
void ends(const Folder& folder, const std::string& arguments, int status) {
    CAPTURE(arguments);
    const Outcome text = folder.check(arguments);
    CHECK(text.status == status);
    CHECK(last_line(text.out).starts_with(status == 0 ? "VERIFIED: " : "NOT VERIFIED: "));
    CHECK(text.err.empty() == (status == 0 || contains(arguments, "--expect")));
    const Outcome quiet = folder.check("--quiet " + arguments);
    CHECK(quiet.status == status);
    CHECK(quiet.out == last_line(text.out) + '\n');
    const Outcome json = folder.check("--json --errata " + arguments + " >report.json");
    CHECK(json.status == status);
    const Outcome valid = folder.in(validate + "report.json");
    CHECK(valid.status == 0);
    CHECK(valid.out.empty());
    const auto report = nlohmann::json::parse(folder.in("cat report.json").out);
    CHECK(report["status"] == status);
    CHECK(report["conclusion"]["verified"] == (status == 0));
    CHECK(contains(text.out, report["conclusion"]["statement"].get<std::string>()));
    if (status == 0) return;
    const bool refused = !contains(arguments, "--expect");
    CHECK((contains(text.out + json.out, "confirmed") && refused) == false);
}

} // namespace

TEST_CASE("exit status, last line and JSON report agree, for every kind of file") {
    const Folder folder;
    ends(folder, "chicago.plc", 0);
    ends(folder, "certs/classification.plc certs/models/registrations/*.plc degrees.plc", 0);
    ends(folder, "wrong.plc", 1);
    ends(folder, "chicago.plc no-degrees.plc", 1);
    ends(folder, "no-degrees.plc", 1);
    ends(folder, "text", 2);
    ends(folder, "chicago.plc nothing-there", 2);
    ends(folder, "nothing-there", 2);
    ends(folder, "certs/classification.plc text", 2);
    ends(folder, ".", 2);
}

TEST_CASE("what is expected is verified, or the last line says what is missing") {
    const Folder folder;
    const std::string chicago = "--expect '2*Pa/Pa/Pa + P/P/P' ";
    const std::string degrees = "degrees.plc";
    ends(folder, chicago + "--verdict minimal chicago.plc", 0);
    ends(folder, chicago + "--verdict minimal --degree 312 chicago.plc " + degrees, 0);
    ends(folder, chicago + "--degree '>=300' " + degrees, 0);
    ends(folder, "--expect='P/P/P+2*Pa/Pa/Pa' --verdict=minimal -- chicago.plc", 0);
    ends(folder, "--classification certs/classification.plc", 0);
    ends(folder,
         "--expect '-/P/P + 3*P/P/P + P/-/P' --degree 384 certs/classification.plc " + degrees, 0);
    ends(folder, chicago + "--verdict minimal point.plc", 1);
    ends(folder, chicago + "--verdict not-minimal chicago.plc", 1);
    ends(folder, chicago + "--degree 312 " + degrees, 1);
    ends(folder, chicago + "--degree 311 chicago.plc " + degrees, 1);
    const Outcome missing = folder.check("--classification chicago.plc");
    CHECK(missing.status == 1);
    CHECK(last_line(missing.out) ==
          "NOT VERIFIED: the whole table: 143493 of 143494 label classes have no certificate here; "
          "add certs/classification.plc");
}

TEST_CASE("details come on request, after a summary that fits a screen") {
    const Folder folder;
    const std::string files = "certs/classification.plc "
                              "certs/degrees/three-points.plc";
    const Outcome summary = folder.check(files);
    CHECK(lines_of(summary.out).size() <= 24);
    for (const char* part :
         {"143494 of 143494 label classes certified: 140616 minimal, 2878 not minimal",
          " label classes\n", " of 74575 terminal problems\n", "counts confirmed, 3 differ"})
        CHECK(contains(summary.out, part));
    CHECK_FALSE(contains(summary.out, "camera-degrees"));
    const std::string few =
        "certs/classification.plc certs/models/registrations/s_l0_i0_r5.plc degrees.plc";
    const auto shows = [&](const std::string& option, const std::string& part) {
        return contains(folder.check(option + ' ' + few).out, part);
    };
    CHECK(shows("--errata", "  Paper: 6300; certified: 6413;"));
    CHECK(shows("--why", "\n- certs/models/registrations/s_l0_i0_r5.plc: solutions modulo q"));
}

TEST_CASE("the columns of a table stand below each other, in lines of at most 100 columns") {
    const Folder folder;
    const Outcome outcome = folder.check("--table certs/classification.plc degrees.plc");
    CHECK(first_number(outcome.out, "terminal, degree 160 ") == "547");
    std::size_t end = 0; // of the column before the last
    std::size_t rows = 0;
    for (const std::string& line : lines_of(outcome.out)) {
        CAPTURE(line);
        if (!line.starts_with("VERIFIED")) CHECK(line.size() <= 100);
        if (line.starts_with("camera-degrees")) end = line.rfind("certified") + 9;
        if (end == 0 || line.starts_with("camera-degrees") || line.empty()) continue;
        if (line.starts_with("VERIFIED")) continue;
        if (line.size() <= end) { // a long claim, whose numbers follow
            CHECK(line.find("  ") == line.npos);
            continue;
        }
        ++rows;
        CHECK(line.size() > end + 2);
        CHECK(line[end - 1] != ' ');
        CHECK(line.substr(end, 2) == "  ");
        CHECK(line[end + 2] != ' ');
    }
    CHECK(rows > 100);
}

TEST_CASE("an option among the files, or a file named like one, never gives status 0") {
    Folder folder;
    for (const char* arguments : {"wrong.plc --version",
                                  "chicago.plc --version",
                                  "--version chicago.plc",
                                  "--help chicago.plc",
                                  "chicago.plc --json",
                                  "--quiet",
                                  "",
                                  "--",
                                  "--versoin chicago.plc",
                                  "--expect",
                                  "--expect '2*Pa/Pa/Pa + P/P/P' chicago.plc",
                                  "--verdict minimal chicago.plc",
                                  "--degree 312 chicago.plc",
                                  "--expect p/p/p --verdict minimal chicago.plc",
                                  "--expect P/P/P --verdict mnimal chicago.plc",
                                  "--expect P/P/P --degree 0 chicago.plc",
                                  "--threads 0 chicago.plc",
                                  "--threads 2000 chicago.plc",
                                  "--threads many chicago.plc",
                                  "--effort 0 chicago.plc",
                                  "--effort much chicago.plc",
                                  "--expect P/P/P --verdict 'over-constrained x' chicago.plc",
                                  "--expect P/P/P --degree '>312' chicago.plc",
                                  "--expect P/P/P --degree 0x10 chicago.plc",
                                  "--expect P/P/P --expect P/P/P --verdict minimal chicago.plc",
                                  "--classification --verdict minimal chicago.plc"}) {
        CAPTURE(arguments);
        const Outcome outcome = folder.check(arguments);
        CHECK(outcome.status == 3);
        CHECK(outcome.out.empty());
        CHECK(outcome.err.starts_with("plcheck: "));
        CHECK(lines_of(outcome.err).size() == 1);
    }
    CHECK(folder.check("--threads 3 chicago.plc").status == 0);
    CHECK(folder.check("--effort 1000000 chicago.plc").status == 0);
    CHECK(folder.check("--version").status == 0);
    CHECK(folder.check("--help").status == 0);
    folder.write("--version", "hello\n");
    CHECK(folder.check("*").status == 3);
    CHECK(folder.check("-- --version chicago.plc").status == 2);
    CHECK(folder.check("./--version chicago.plc").status == 2);
}

TEST_CASE("a line is told for each file as soon as it is replayed, and no bar in a pipe") {
    const Folder folder;
    folder.in("mkfifo pipe");
    // The line on the first file comes before the second one can be read.
    const Outcome told =
        folder.in(": >out; ( " + plcheck +
                  " chicago.plc pipe >out 2>err & until grep -q certified out; do sleep 0.1; "
                  "done; cat point.plc >pipe; wait ); cat out; cat err >&2");
    CHECK(told.err.empty());
    CHECK(lines_of(told.out).size() == 3);
    CHECK(contains(told.out, "\npipe: certified over-constrained 10: 7*P/P/P\nVERIFIED: "));
}

TEST_CASE("on a terminal a bar shows records, solutions and the time left, and is wiped away") {
    const Folder folder;
    const std::string file = "certs/degrees/three-points.plc";
    const auto on_terminal = [&](const std::string& options) {
        return folder.in("script -qec '" + plcheck + options + file + "' /dev/null").out;
    };
    const std::string shown = on_terminal(" ");
    CHECK(contains(shown, " records, "));
    CHECK(contains(shown, " solutions, 0:0"));
    CHECK(contains(shown, " left"));
    const std::size_t bar = shown.rfind(" left");
    const std::size_t wiped = shown.find("\r\x1b[K", bar);
    CHECK(wiped < shown.find("three-points.plc: 11 degree records hold"));
    CHECK_FALSE(contains(on_terminal(" --quiet "), " left"));
    CHECK_FALSE(contains(folder.check(file).err, " left"));
}
