// plprove degrees under mpirun: the bytes of one process, whatever the number of ranks, and
// whichever of them is killed. The program is plprove with a fake engine.
#include "tests/support/process.h"
#include "tests/support/program.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <doctest/doctest.h>
#include <map>
#include <regex>
#include <string>
#include <thread>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// Numbers of classes, of 37 constraint classes. The fake engine does not like two of these.
const std::string some = "60000..60150";

/// More ranks than cores, by root too, and in a container.
void prepare_mpi() {
    for (const char* variable : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM",
                                 "OMPI_MCA_rmaps_base_oversubscribe"})
        ::setenv(variable, "1", 1);
    ::setenv("OMPI_MCA_hwloc_base_binding_policy", "none", 1);
    ::setenv("OMPI_MCA_btl_vader_single_copy_mechanism", "none", 1);
    ::setenv("ASAN_OPTIONS", "detect_leaks=0", 1); // MPI's own
}

Arguments sweep_of(const fs::path& folder, const Arguments& more = {}) {
    Arguments arguments{"degrees", "--target", "40", "--classes", some, "-o", folder.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

std::string shell(const std::string& program, const Arguments& arguments) {
    std::string line = program;
    for (const std::string& argument : arguments)
        line += " '" + argument + "'";
    return line;
}

std::string by_ranks(int ranks) {
    return std::string(MPIRUN) + " -n " + std::to_string(ranks) + " " + PLPROVE_FAKE_ENGINE;
}

/// The finished classes of a sweep, by their paths in it. What a run took is left out, and so is
/// the digest of the line that says it.
std::map<std::string, std::string> finished(const fs::path& folder) {
    const std::regex varying("\"seconds\":[0-9.e-]+| sha256 [0-9a-f]{64}");
    std::map<std::string, std::string> files;
    if (!fs::exists(folder / "seed-0")) return files;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "seed-0"))
        if (entry.path().extension() == ".plc")
            files[entry.path().lexically_relative(folder)] =
                std::regex_replace(read_file(entry.path()), varying, "");
    return files;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

int occurrences(const std::string& text, const std::string& part) {
    int count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

/// A sweep by one process, in a folder that vanishes with the object.
struct SweepByOne {
    TemporaryFolder folder;
    fs::path path = folder / "one";
    Outcome outcome;

    SweepByOne() {
        prepare_mpi();
        outcome = run(shell(PLPROVE_FAKE_ENGINE, sweep_of(path)));
        REQUIRE(outcome.status == 1); // the double fails for some classes, and reports it
    }

    void check_same(const fs::path& other) const {
        for (const char* file : {"degrees.csv", "degrees.plc"})
            CHECK(read_file(other / file) == read_file(path / file));
        CHECK(finished(other) == finished(path));
    }
};

} // namespace

TEST_CASE("two and four ranks write the bytes of one process, and one of them speaks") {
    const SweepByOne one;
    for (const int ranks : {2, 4})
        for (const char* threads : {"1", "3"}) {
            CAPTURE(ranks);
            CAPTURE(threads);
            const fs::path sweep = one.folder / (std::to_string(ranks) + "-" + threads);
            const Outcome outcome =
                run(shell(by_ranks(ranks), sweep_of(sweep, {"--threads", threads})));
            CHECK(outcome.status == 1);
            one.check_same(sweep);
            CHECK(contains(outcome.out, "computed      37 classes in "));
            CHECK(occurrences(outcome.out, "\n") == occurrences(one.outcome.out, "\n"));
            CHECK(occurrences(outcome.err, "plprove: 2 classes fell short:") == 1);
            CHECK(occurrences(outcome.err, "plprove: ") == 1);
        }
}

TEST_CASE("a sweep that loses a rank goes on with the same command and loses nothing") {
    const SweepByOne one;
    for (const int ranks : {2, 4})
        for (const char* lost : {"0", "1"}) {
            CAPTURE(ranks);
            CAPTURE(lost);
            const fs::path sweep = one.folder / (std::to_string(ranks) + "-" + lost);
            std::map<std::string, std::string> files;
            for (const char* last : {"1", "3", "2"}) { // the class with which the rank is lost
                const std::string killed =
                    "PLC_FAKE_ENGINE_STOP=" + std::string(last) +
                    " PLC_FAKE_ENGINE_SIGNAL=9 PLC_FAKE_ENGINE_RANK=" + lost +
                    " PLC_FAKE_ENGINE_MS=20 ";
                CHECK(run(killed + shell(by_ranks(ranks), sweep_of(sweep, {"--threads", "1"})))
                          .status != 0);
                const auto now = finished(sweep);
                CHECK(std::ranges::includes(now, files));
                files = now;
            }
            CHECK(run(shell(by_ranks(ranks), sweep_of(sweep))).status == 1);
            one.check_same(sweep);
        }
}

TEST_CASE("one process ends what ranks have begun, and ranks what one process has") {
    const SweepByOne one;
    const fs::path sweep = one.folder / "both";
    run(shell(PLPROVE_FAKE_ENGINE,
              {"degrees", "--target", "40", "--classes", "60000..60050", "-o", sweep.string()}));
    const std::size_t begun = finished(sweep).size();
    CHECK(begun > 3);
    const Outcome rest = run(shell(by_ranks(3), sweep_of(sweep)));
    CHECK(contains(rest.out, "; " + std::to_string(begun) + " were on file\n"));
    one.check_same(sweep);
    const Outcome again = run(shell(PLPROVE_FAKE_ENGINE, sweep_of(sweep)));
    CHECK(contains(again.out, "computed      0 classes in 0 s; 37 were on file\n"));
}

TEST_CASE("a rank that gets SIGTERM ends the others, rank 0 reports it, and the sweep goes on") {
    const SweepByOne one;
    const fs::path sweep = one.folder / "sweep", err = one.folder / "err";
    // mpirun may not pass on what ranks say while they end: each has a file.
    const std::string rank = "PLC_FAKE_ENGINE_STOP=4 PLC_FAKE_ENGINE_SIGNAL=15 "
                             "PLC_FAKE_ENGINE_RANK=0 exec " +
                             shell(PLPROVE_FAKE_ENGINE, sweep_of(sweep, {"--threads", "1"})) +
                             " 2>" + err.string() + "$OMPI_COMM_WORLD_RANK";
    write_file(one.folder / "rank", rank);
    CHECK(run(std::string(MPIRUN) + " -n 2 /bin/sh " + (one.folder / "rank").string()).status != 0);
    const std::string message = read_file(err.string() + "0");
    CHECK(message.starts_with("plprove: interrupted: "));
    CHECK(contains(message, "goes on from there\n"));
    CHECK(read_file(err.string() + "1").empty());
    const std::size_t on_file = finished(sweep).size();
    CHECK(on_file >= 3);
    CHECK(on_file < 37); // rank 0 was at work on another
    const Outcome rest = run(shell(by_ranks(2), sweep_of(sweep)));
    CHECK(contains(rest.out, "; " + std::to_string(on_file) + " were on file\n"));
    one.check_same(sweep);
}

TEST_CASE("a sweep goes on after mpirun got SIGTERM, as from a batch system, or Ctrl-C") {
    const SweepByOne one;
    for (const int signal : {SIGTERM, SIGINT}) {
        CAPTURE(signal);
        const fs::path sweep = one.folder / std::to_string(signal);
        Arguments ranks{"-n", "3", PLPROVE_FAKE_ENGINE};
        for (const std::string& argument : sweep_of(sweep, {"--threads", "1"}))
            ranks.push_back(argument);
        const pid_t mpirun = start_program( // each rank stays at its third class
            MPIRUN, "/", ranks, [] { ::setenv("PLC_FAKE_ENGINE_STOP", "3", 1); });
        constexpr std::size_t before = 6;
        for (int i = 0; i < 60'000 && finished(sweep).size() < before; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        ::kill(mpirun, signal);
        wait_for(mpirun);
        CHECK(finished(sweep).size() == before);
        const Outcome rest = run(shell(by_ranks(3), sweep_of(sweep)));
        CHECK(contains(rest.out, "; 6 were on file\n"));
        one.check_same(sweep);
    }
}

TEST_CASE("what rank 0 refuses is said once; that, or what any rank cannot write, ends all") {
    const SweepByOne one;
    const Outcome none = run(shell(by_ranks(3), {"degrees", "--classes", "0", "-o", "/nowhere"}));
    CHECK(none.status == 2);
    CHECK(occurrences(none.err, "plprove: no minimal class passes the filter") == 1);
    CHECK(occurrences(none.err, "plprove: ") == 1);

    const fs::path sweep = one.folder / "sweep";
    fs::create_directories(sweep / "seed-0");
    write_file(sweep / "seed-0" / "060", ""); // where a folder should be
    const Outcome full = run(shell(by_ranks(3), sweep_of(sweep)));
    CHECK(full.status == 1);
    CHECK(contains(full.err, "seed-0/060")); // by each rank that comes to it before mpirun ends it
}

TEST_CASE("wrong usage is said once, and so is the help") {
    prepare_mpi();
    for (const Arguments& wrong : {Arguments{"degrees", "--targte", "5"}, Arguments{"bundle"}}) {
        const Outcome outcome = run(shell(by_ranks(3), wrong));
        CHECK(outcome.status == 3);
        CHECK(outcome.out.empty());
        CHECK(occurrences(outcome.err, "plprove: ") == 1);
    }
    const Outcome help = run(shell(by_ranks(3), {"degrees", "--help"}));
    CHECK(help.status == 0);
    CHECK(help.out == run(shell(PLPROVE_FAKE_ENGINE, {"degrees", "--help"})).out);
}

TEST_CASE("rank 0 shows its progress on the terminal of mpirun, and nothing in a pipe") {
    prepare_mpi();
    if (run("command -v script").status != 0) {
        MESSAGE("there is no script(1) here: not tested");
        return;
    }
    const TemporaryFolder folder;
    const std::string ranks = "PLC_FAKE_ENGINE_MS=40 " + by_ranks(2) + " degrees --classes ";
    const auto sweep = [&](const std::string& name) {
        return ranks + "60000..60050 -o " + (folder / name).string();
    };
    write_file(folder / "shown.sh", sweep("shown"));
    write_file(folder / "piped.sh", sweep("piped") + " 2>" + (folder / "errors").string());
    const auto on_terminal = [&](const std::string& script) {
        return run("script -qec 'sh " + (folder / script).string() + "' /dev/null");
    };
    CHECK(contains(on_terminal("shown.sh").out, "\rcomputing degrees of rank 0: "));
    CHECK(!contains(on_terminal("piped.sh").out, "computing degrees"));
    CHECK(!contains(read_file(folder / "errors"), "computing degrees"));
}

TEST_CASE("a plprove that was started alone does not start MPI") {
    const SweepByOne one;
    const std::string broken = "OMPI_MCA_pml=none-of-these ";
    const fs::path alone = one.folder / "alone";
    CHECK(run(broken + shell(by_ranks(2), sweep_of(one.folder / "ranks"))).out.empty());
    CHECK(run(broken + shell(PLPROVE_FAKE_ENGINE, sweep_of(alone))).status == 1);
    one.check_same(alone);
}
