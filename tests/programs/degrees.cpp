// plprove degree and degrees as users run them, and what happens to a sweep that is killed. The
// program is plprove with a fake engine.
#include "tests/support/process.h"
#include "tests/support/program.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <doctest/doctest.h>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

const std::string plprove = PLPROVE_FAKE_ENGINE;

/// Numbers of classes, of 37 constraint classes. The fake engine does not like two of these.
const std::string some = "60000..60150";

Arguments sweep_of(const fs::path& folder, const Arguments& more = {}) {
    Arguments arguments{"degrees", "--target", "40", "--classes", some, "-o", folder.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

/// The class, counted from 1, with which the fake engine stops, if any, and the signal that it
/// sends.
struct Stop {
    int at = 0, signal = 0;
};

pid_t start(const Arguments& arguments, const Stop& stop = {}) {
    return start_program(plprove, "/", arguments, [&] {
        ::setenv("PLC_FAKE_ENGINE_STOP", std::to_string(stop.at).c_str(), 1);
        ::setenv("PLC_FAKE_ENGINE_SIGNAL", std::to_string(stop.signal).c_str(), 1);
    });
}

std::string shell(const Arguments& arguments) {
    std::string line = plprove;
    for (const std::string& argument : arguments)
        line += " '" + argument + "'";
    return line;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The finished classes of a sweep, by path.
std::map<std::string, std::string> finished(const fs::path& folder) {
    std::map<std::string, std::string> files;
    if (!fs::exists(folder / "seed-0")) return files;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "seed-0"))
        if (entry.path().extension() == ".plc") files[entry.path()] = read_file(entry.path());
    return files;
}

/// Every file is whole and what it was before; beside them stands nothing that is taken for one.
void check_nothing_lost(const std::map<std::string, std::string>& before,
                        const std::map<std::string, std::string>& now) {
    bool kept = true, whole = true;
    for (const auto& [path, text] : before)
        kept = kept && now.contains(path) && now.at(path) == text;
    for (const auto& [path, text] : now)
        whole = whole && text.starts_with("plcert 2 degrees\n# run {") && text.ends_with("\n");
    CHECK(kept);
    CHECK(whole);
}

void wait_until(const std::function<bool()>& condition) {
    for (int i = 0; i < 60'000 && !condition(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    REQUIRE(condition());
}

} // namespace

TEST_CASE("a sweep that is killed again and again goes on and loses nothing") {
    const TemporaryFolder folder;
    const fs::path whole = folder / "whole";
    // The double fails for some classes, and reports it.
    REQUIRE(WEXITSTATUS(wait_for(start(sweep_of(whole, {"--threads", "3"})))) == 1);
    std::mt19937 random(7);
    std::uniform_int_distribution<int> moment(1, 13);
    int kills = 0, rounds = 0;
    for (; kills < 60; ++rounds) {
        const fs::path sweep = folder / ("sweep-" + std::to_string(rounds));
        std::map<std::string, std::string> files;
        for (bool done = false; !done;) {
            const int last = moment(random);
            const int status =
                wait_for(start(sweep_of(sweep, {"--threads", "3"}), {last, SIGKILL}));
            done = WIFEXITED(status);
            kills += !done;
            const auto now = finished(sweep);
            check_nothing_lost(files, now);
            // Two other classes may have been at work, the rest is on file.
            CHECK((done || std::ssize(now) >= std::ssize(files) + last - 3));
            files = now;
        }
        for (const char* file : {"degrees.csv", "degrees.plc"})
            CHECK(read_file(sweep / file) == read_file(whole / file));
    }
    MESSAGE(kills << " kills in " << rounds << " sweeps");
}

TEST_CASE("Ctrl-C and SIGTERM end a sweep with a message and their own status, and it goes on") {
    for (const int signal : {SIGINT, SIGTERM}) {
        const TemporaryFolder folder;
        const fs::path sweep = folder / "sweep";
        const std::string err = (folder / "err").string();
        const int status = wait_for(start_program(
            "/bin/sh", "/",
            {"-c", "PLC_FAKE_ENGINE_STOP=9 PLC_FAKE_ENGINE_SIGNAL=" + std::to_string(signal) +
                       " exec " + shell(sweep_of(sweep, {"--threads", "3"})) + " 2>" + err}));
        REQUIRE(WIFSIGNALED(status));
        CHECK(WTERMSIG(status) == signal);
        const std::string message = read_file(err);
        CHECK(contains(message, "plprove: interrupted: "));
        CHECK(contains(message, "goes on from there"));
        const auto files = finished(sweep);
        CHECK(files.size() >= 6);
        const Outcome rest = run(shell(sweep_of(sweep)));
        check_nothing_lost(files, finished(sweep));
        CHECK(contains(rest.out, "; " + std::to_string(files.size()) + " were on file"));
    }
}

TEST_CASE("an ignored signal stays ignored") {
    const TemporaryFolder folder;
    const int status = wait_for(start_program(
        "/bin/sh", "/",
        {"-c", "trap '' INT; PLC_FAKE_ENGINE_STOP=3 PLC_FAKE_ENGINE_SIGNAL=2 PLC_FAKE_ENGINE_MS=5 "
               "exec " +
                   shell(sweep_of(folder / "sweep"))}));
    CHECK(WIFEXITED(status));
    CHECK(fs::exists(folder / "sweep" / "degrees.csv"));
}

TEST_CASE("a second sweep in the same folder is refused until the first one ends or dies") {
    const TemporaryFolder folder;
    const fs::path sweep = folder / "sweep";
    const pid_t first = start(sweep_of(sweep), {3, 0});
    wait_until([&] { return !finished(sweep).empty(); });
    const Outcome second = run(shell(sweep_of(sweep)));
    CHECK(second.status == 1);
    CHECK(second.out.empty());
    CHECK(second.err == "plprove: another sweep is at work in " + sweep.string() +
                            ": wait for it, or name another folder\n");
    // Another folder is free, and the results so far can be looked at.
    CHECK(run(shell(sweep_of(folder / "other"))).err.find("another sweep") == std::string::npos);
    CHECK(run(shell({"collect", "-o", sweep.string()})).status == 0);
    ::kill(first, SIGKILL);
    wait_for(first);
    CHECK(contains(run(shell(sweep_of(sweep))).out, "were on file"));
}

TEST_CASE("two sweeps started at a time: one works, one is refused") {
    for (int i = 0; i < 10; ++i) {
        const TemporaryFolder folder;
        const Arguments arguments{"degrees", "--classes", "2394,6723", "-o", folder.path()};
        const pid_t one = start(arguments, {1, 0});
        const pid_t other = start(arguments, {1, 0});
        // The one that works does not end by itself.
        int status = 0;
        const pid_t refused = ::waitpid(-1, &status, 0);
        CHECK(WIFEXITED(status));
        CHECK(WEXITSTATUS(status) == 1);
        const pid_t works = refused == one ? other : one;
        ::kill(works, SIGKILL);
        CHECK(WIFSIGNALED(wait_for(works)));
    }
}

TEST_CASE("the number of threads has no part in the bytes") {
    const TemporaryFolder folder;
    for (const char* threads : {"1", "4"})
        run(shell(sweep_of(folder / threads, {"--threads", threads})));
    for (const char* file : {"degrees.csv", "degrees.plc"})
        CHECK(read_file(folder / "1" / file) == read_file(folder / "4" / file));
    CHECK(contains(read_file(folder / "1" / "degrees.plc"), "\nreal "));
}

TEST_CASE("a sweep says what it did, names what fell short, and is silent on the way") {
    const TemporaryFolder folder;
    const Outcome first = run(shell(sweep_of(folder / "sweep")));
    CHECK(first.status == 1);
    CHECK(contains(first.out, "computed "));
    CHECK(contains(first.out, "; 0 were on file\n"));
    CHECK(contains(first.out, "certified once plcheck accepts them\n"));
    CHECK(contains(first.err, " fell short: #"));
    CHECK(!contains(first.err, "computing degrees"));
    const Outcome again = run(shell(sweep_of(folder / "sweep")));
    CHECK(again.status == 1);
    CHECK(contains(again.out, "computed      0 classes in 0 s; "));
    CHECK(again.err == first.err);
    const Outcome retried = run(shell(sweep_of(folder / "sweep", {"--retry"})));
    CHECK(!contains(retried.out, "computed      0 classes"));
    const Outcome well = run(
        shell({"degrees", "--exact", "--classes", "2394,6723", "-o", (folder / "two").string()}));
    CHECK(well.status == 0);
    CHECK(well.err.empty());
    const std::string runs = read_file(folder / "two" / "runs.jsonl");
    const auto line = nlohmann::json::parse(runs.substr(0, runs.find('\n')));
    for (const char* field : {"number", "degree", "record", "complete", "tracks", "retried",
                              "failed", "seconds", "notes", "seed"})
        CHECK(line.contains(field));
    CHECK(!contains(runs, "certified")); // plcheck has not been asked yet
}

TEST_CASE(
    "a sweep over a family finds the degrees on file, certified once plcheck has been asked") {
    const TemporaryFolder folder;
    const auto sweep = [&](const std::string& name, const Arguments& more) {
        Arguments arguments{"degrees", "--family", "upright-shared-focal", "-o",
                            (folder / name).string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(shell(arguments));
    };
    const auto rows = [&](const std::string& name) {
        std::vector<std::string> lines =
            lines_of(read_file(folder / name / "upright-shared-focal.csv"));
        std::erase_if(lines, [](const std::string& line) { return !line.starts_with("upright"); });
        return lines;
    };
    const Outcome whole = sweep("one", {"--exact", "--threads", "1"});
    CHECK(whole.status == 0);
    CHECK(contains(whole.out, "8 problems, 8 with all solutions, by evidence, "));
    REQUIRE(rows("one").size() == 8);
    CHECK(rows("one")[0] ==
          "upright-shared-focal,upright-shared-focal: 4*P/P,5,exact,evidence,,32 of 32 ways agree");
    CHECK(contains(sweep("one", {"--exact"}).out, "; 8 were on file\n"));

    // By theorem there are no more (certs/family-degrees.csv): the sweep has found all.
    const std::string file = (folder / "one" / "upright-shared-focal.plc").string();
    const std::string report = (folder / "report").string();
    CHECK(run(std::string(PLCHECK) + " --json " + file + " > " + report).status == 0);
    CHECK(run(shell({"collect", "--family", "upright-shared-focal", "--checked", report, "-o",
                     (folder / "one").string()}))
              .status == 0);
    std::vector<std::string> on_file;
    for (const std::string& line : lines_of(read_file(PLC_CERTS "/family-degrees.csv")))
        if (line.starts_with("upright-shared-focal,"))
            on_file.push_back(std::regex_replace(line, std::regex("certified,(\\d+),by theorem; "),
                                                 "evidence,$1,"));
    CHECK(rows("one") == on_file);

    sweep("two", {"--exact", "--threads", "2"});
    CHECK(read_file(folder / "two" / "upright-shared-focal.plc") == read_file(file));
    const Outcome alone = run(plprove + " degree 'upright-shared-focal: 2*Pa/Pa/Pa' --seed 1 -o -");
    const std::string record = alone.out.substr(alone.out.find('\n') + 1);
    CHECK(contains(read_file(file), record));
    const Outcome some = sweep("some", {"--target", "6"});
    CHECK(some.status == 0);
    CHECK(contains(some.out, "8 problems, 2 with all solutions, by evidence, 6 lower bounds"));
    CHECK(contains(rows("some")[7], ",at-least,evidence,,stopped at the target"));
}

TEST_CASE("a sweep over a family keeps to it") {
    const TemporaryFolder folder;
    const std::string path = (folder / "sweep").string();
    const Outcome counted =
        run(shell({"degrees", "--family", "upright", "--uncounted", "-o", path}));
    CHECK(counted.status == 2);
    CHECK(contains(counted.err, "no problem of upright is left: all have a degree on file"));
    const Outcome two_views =
        run(shell({"degrees", "--family", "upright", "--views", "2", "--exact", "-o", path}));
    CHECK(contains(two_views.out, "computed      2 problems in "));
    for (const char* none : {"5..", "..1"}) {
        const Outcome outcome =
            run(shell({"degrees", "--family", "upright", "--views", none, "-o", path}));
        CHECK(outcome.status == 2);
        CHECK(contains(outcome.err,
                       "no problem of upright is left: all have other numbers of views"));
    }
    CHECK(run(shell({"degrees", "--family", "upright", "--views", "3..2", "-o", path})).status ==
          3);
    for (const Arguments& other : {Arguments{"--classes", "2394"}, Arguments{"--fibres"}}) {
        Arguments arguments{"degrees", "--family", "upright", "-o", path};
        arguments.insert(arguments.end(), other.begin(), other.end());
        CHECK(run(shell(arguments)).status == 3);
    }
    CHECK(run(shell({"degrees", "--uncounted", "-o", path})).status == 3);
    run(shell({"degrees", "--family", "upright", "--exact", "-o", path}));
    CHECK(run(shell({"collect", "-o", path})).status == 2);
    CHECK(run(shell({"collect", "--family", "upright", "-o", path})).status == 0);
}

TEST_CASE("a progress line with rate and time left is shown on a terminal and wiped") {
    const TemporaryFolder folder;
    const std::string line = shell({"degrees", "--classes", "60000..60050", "--threads", "1", "-o",
                                    (folder / "sweep").string()});
    if (run("command -v script").status != 0) {
        MESSAGE("there is no script(1) here: not tested");
        return;
    }
    write_file(folder / "sweep.sh", "PLC_FAKE_ENGINE_MS=40 " + line + "\n");
    const Outcome outcome =
        run("script -qec 'sh " + (folder / "sweep.sh").string() + "' /dev/null");
    CHECK(contains(outcome.out, "\rcomputing degrees: "));
    CHECK(contains(outcome.out, " a second, "));
    CHECK(contains(outcome.out, " left\x1b[K"));
}

TEST_CASE("a full disk or a read-only folder ends a sweep with a message, and nothing is lost") {
    const TemporaryFolder folder;
    const std::string path = folder.path().string();
    const std::string sweep = shell(sweep_of("sweep"));
    std::string quoted; // within the single quotes of the script
    for (const char c : sweep)
        quoted += c == '\'' ? std::string("\"") : std::string(1, c);
    if (const auto full = run_with_mounts("mount -t tmpfs -o size=64k none " + path + " && cd " +
                                          path + " && " + quoted + "; echo status $?; " +
                                          "mount -o remount,size=64m " + path + "; " + quoted +
                                          "; echo status $?; grep -c ^degree sweep/degrees.plc")) {
        CHECK(contains(full->err, "plprove: cannot write sweep/"));
        CHECK(contains(full->err, ": No space left on device\n"));
        CHECK(full->out.starts_with("status 1\n"));
        CHECK(contains(full->out, "computed "));
        CHECK(!contains(full->out, "; 0 were on file"));
    }
    if (const auto read_only =
            run_with_mounts("mount -t tmpfs none " + path + " && mkdir " + path +
                            "/sweep && mount -o remount,bind,ro " + path + " && cd " + path +
                            " && " + quoted + "; echo status $?")) {
        CHECK(read_only->out == "status 1\n");
        CHECK(read_only->err == "plprove: cannot write sweep/lock: Read-only file system\n");
    }
    write_file(folder / "file", "");
    const Outcome no_folder = run(shell(sweep_of(folder / "file")));
    CHECK(no_folder.status == 1);
    CHECK(contains(no_folder.err, (folder / "file").string()));
    CHECK(run("cd " + path + " && ulimit -f 1 && " + sweep).status == 1);
}

TEST_CASE("degree answers for people and for machines") {
    const Outcome text = run(plprove + " degree 2394");
    CHECK(text.status == 0);
    CHECK(text.err.empty());
    CHECK(contains(text.out, "problem     2*Pa/Pa/Pa + P/P/P\n"));
    CHECK(contains(text.out, "degree      312, by theorem\n"));
    CHECK(contains(text.out, "certified once plcheck accepts it"));
    const Outcome json = run(plprove + " degree '2*Pa/Pa/Pa + P/P/P' --json");
    CHECK(json.status == 0);
    const auto report = nlohmann::json::parse(json.out);
    CHECK(report["number"] == 2394);
    CHECK(report["notation"] == "2*Pa/Pa/Pa + P/P/P");
    CHECK(report["complete"] == true);
    CHECK(report["degree"] == 312);
    CHECK(report["found"] == report["certificate"]);
    for (const char* field : {"tracks", "retried", "failed", "seconds", "notes", "target", "seed",
                              "constraint_class", "problem", "minimal"})
        CHECK(report.contains(field));
    const auto stopped = nlohmann::json::parse(run(plprove + " degree 2394 --target 2 --json").out);
    CHECK(stopped["found"] == 2);
    CHECK(stopped["complete"] == false);
    const Outcome bound = run(plprove + " degree 2394 --target 2");
    CHECK(contains(bound.out, "found       2 solutions\n"));
}

TEST_CASE("degree names a problem in all the ways of plprove problem, reduced or not") {
    const auto answer = [](const std::string& spec) {
        auto report = nlohmann::json::parse(run(plprove + " degree --json '" + spec + "'").out);
        report.erase("seconds");
        return report;
    };
    CHECK(answer("#2394") == answer("2394"));
    CHECK(answer("{{0,1},{{{1,1},{1,1,1}},{{1,1},{1,1,1}},{{1,1},{1,1,1}}}}") == answer("2394"));
    const auto camera_minimal = answer("3*P/P/P + P/P/a");
    CHECK(camera_minimal["number"] == 6723);
    CHECK(camera_minimal["minimal"] == false);
    CHECK(camera_minimal["problem"] == "3*P/P/P + P/P/a");
    CHECK(camera_minimal["degree"] == answer("6723")["degree"]);
    // A line that one view sees beside its point is forgotten.
    CHECK(answer("2*Pa/Pa/Pa + Pa/P/P")["constraint_class"] == 2394);
    // Swapped: the same class, another number.
    CHECK(answer("3*P/P/P + P/Pa/a")["constraint_class"] ==
          answer("3*P/P/P + Pa/P/a")["constraint_class"]);
}

TEST_CASE("degree writes the certificate, or nothing") {
    const TemporaryFolder folder;
    const std::string path = (folder / "file").string();
    CHECK(run(plprove + " degree 2394 -o " + path).status == 0);
    const std::string text = read_file(path);
    CHECK(text.starts_with("plcert 2 degrees\ndegree 2394 evidence none\n"));
    CHECK(run(plprove + " degree 2394 -o -").out == text);
    const Outcome nowhere = run(plprove + " degree 2394 -o /nowhere/at/all");
    CHECK(nowhere.status == 1);
    CHECK(nowhere.out.empty());
    CHECK(contains(nowhere.err, "/nowhere/at/all"));
    CHECK(run(plprove + " degree 2394 >/dev/full").status == 1);
}

TEST_CASE("what is no minimal problem, or no command, is refused") {
    const auto refused = [](const std::string& arguments, int status, const std::string& reason) {
        CAPTURE(arguments);
        const TemporaryFolder folder;
        const Outcome outcome =
            run("cd " + folder.path().string() + " && " + plprove + " " + arguments);
        CHECK(outcome.status == status);
        CHECK(outcome.out.empty());
        CHECK(contains(outcome.err, reason));
        CHECK(fs::is_empty(folder.path()));
    };
    refused("degree 0", 2, "only minimal and camera-minimal problems have a degree");
    refused("degree '4*P/P/P'", 2, "over-constrained");
    refused("degree P/P/P -o file", 2, "under-constrained");
    refused("degree '5*P/P' --target 3", 2, "leave --target and --at-least out");
    refused("degree '6*P/P'", 2, "over-constrained");
    refused("degree nonsense", 2, "not a problem");
    refused("degree 143494", 2, "not a problem");
    refused("degree", 3, "PROBLEM");
    refused("degree 2394 --target 0", 3, "--target");
    refused("degree 2394 --target x", 3, "--target");
    refused("degree 2394 --seed -1", 3, "--seed");
    refused("degrees", 3, "--output");
    refused("degrees -o d --target 3 --exact", 3, "--exact");
    refused("degrees -o d --threads 0", 3, "--threads");
    refused("degrees -o d --classes nonsense", 3, "nonsense");
    refused("degrees -o d --classes --nonsense", 3, "nonsense");
    refused("degrees -o d --classes", 3, "--classes");
    refused("degrees -o d --classes 0", 2, "no minimal class passes the filter");
    refused("degrees -o d --checked report", 3, "has no option '--checked'");
    refused("collect", 3, "--output");
    refused("collect -o d --exact", 3, "has no option '--exact'");
    refused("collect -o d --also pl0p", 3, "--below");
    refused("collect -o d --below 3 --checked report", 3, "--below");
    refused("collect -o d", 2, "no results in d");
    for (const char* command : {"degree", "degrees", "collect"}) {
        const Outcome help = run(plprove + " " + command + " --help");
        CHECK(help.status == 0);
        CHECK(contains(help.out, "Examples:"));
    }
}

TEST_CASE("filters are given with dashes or without") {
    const TemporaryFolder folder;
    const auto count = [&](const std::string& filter, const std::string& name) {
        run(plprove + " degrees " + filter + " -o " + (folder / name).string());
        return finished(folder / name).size();
    };
    CHECK(count("--classes pl0p", "a") == 51);
    CHECK(count("--classes --pl0p", "b") == 51);
    CHECK(count("--classes=--pl0p", "c") == 51);
    CHECK(count("--classes '--pl0p --points ..3' --classes 2394", "d") < 51);
    CHECK(count("--classes \"$(" + plprove + " list --pl0p --minimal)\"", "e") == 51);
    CHECK(count("--classes 'contains 3*P/P/P+a/a/a'", "f") == 1);
}
