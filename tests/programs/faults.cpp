// Faults that are nobody's mistake: killed processes, full disks, folders that cannot be written,
// readers that have left. A file is under its name whole or not at all, and whoever lives to say so
// says what is wrong, with a status other than 0.
#include "tests/support/process.h"
#include "tests/support/programs.h"

#include <algorithm>
#include <csignal>
#include <doctest/doctest.h>
#include <fcntl.h>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// Starts plprove in a folder, silent, after `prepare` in the new process; the result is its id.
pid_t start(
    const fs::path& folder, const Arguments& arguments,
    const std::function<void()>& prepare = [] {}) {
    return start_program(plprove, folder, arguments, prepare);
}

/// A command that writes one file, which is named "file" here.
struct Writing {
    Arguments arguments;
    std::string before, after; ///< the file's content; no file is the empty string
};

Writing undisturbed(const Arguments& arguments, const std::string& before) {
    const TemporaryFolder folder;
    REQUIRE(wait_for(start(folder.path(), arguments)) == 0);
    return {arguments, before, read_file(folder / "file")};
}

void restore(const fs::path& folder, const Writing& writing) {
    fs::remove(folder / "file");
    if (!writing.before.empty()) write_file(folder / "file", writing.before);
}

/// What a killed process may leave: the old file or the new one; beside it at most whole files
/// that nobody takes for it. Returns whether the new one is there.
bool check_leftovers(const fs::path& folder, const Writing& writing) {
    const std::string now = read_file(folder / "file");
    const bool whole = now == writing.before || now == writing.after;
    REQUIRE(whole);
    REQUIRE(fs::exists(folder / "file") == !now.empty());
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().filename() == "file") continue;
        REQUIRE(entry.path().filename().string().starts_with(".plprove-"));
        fs::remove(entry);
    }
    return now == writing.after;
}

void check_later_run(const fs::path& folder, const Writing& writing) {
    REQUIRE(wait_for(start(folder, writing.arguments)) == 0);
    const bool written = read_file(folder / "file") == writing.after;
    CHECK(written);
}

/// Runs the command step by step: from one entry of its first thread into the kernel, or return
/// from it, to the next. Sends it the signal at step `last`, which lets it end where it has fewer.
struct Traced {
    int steps = 0; ///< none where this system permits no tracing
    int status = 0;
};

Traced trace(const fs::path& folder, const Arguments& arguments, int last, int signal = SIGKILL) {
    const pid_t child = start(folder, arguments, [] {
        if (::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) ::_exit(126);
    });
    int status = wait_for(child);
    if (!WIFSTOPPED(status)) return {0, status};
    for (int step = 0;; ++step) {
        if (step == last) ::kill(child, signal);
        // What stops it besides steps is a signal on its way.
        const long passed = WSTOPSIG(status) == SIGTRAP ? 0 : WSTOPSIG(status);
        ::ptrace(PTRACE_SYSCALL, child, nullptr, passed);
        status = wait_for(child);
        if (!WIFSTOPPED(status)) return {step, status};
    }
}

struct Kills {
    int cut = 0;     ///< processes that died of the signal
    int written = 0; ///< of these, those whose file was complete
};

/// Sends `signal` to runs, each at a random step of those that the command takes, until it has cut
/// `count` of them short: one that has fewer steps than the first had may end before.
Kills kill_at_random(const Writing& writing, int signal, int count) {
    const TemporaryFolder folder;
    restore(folder.path(), writing);
    const int steps = trace(folder.path(), writing.arguments, -1).steps;
    Kills kills;
    if (steps == 0) {
        MESSAGE("this system permits no tracing: not tested");
        return kills;
    }
    std::mt19937 random(42);
    std::uniform_int_distribution<int> moment(0, steps - 1);
    for (int runs = 0; kills.cut < count && runs < 20 * count; ++runs) {
        restore(folder.path(), writing);
        const int status = trace(folder.path(), writing.arguments, moment(random), signal).status;
        const bool cut = WIFSIGNALED(status) && WTERMSIG(status) == signal;
        REQUIRE((cut || (WIFEXITED(status) && WEXITSTATUS(status) == 0)));
        const bool written = check_leftovers(folder.path(), writing);
        REQUIRE((cut || written));
        kills.cut += cut;
        kills.written += cut && written;
    }
    CHECK(kills.cut == count);
    check_later_run(folder.path(), writing);
    return kills;
}

const Arguments certify{"certify", "2394", "-o", "file"};

} // namespace

TEST_CASE("a process killed at a random system call leaves the old file or the new one") {
    const std::string old = "the old file";
    const struct {
        std::string name;
        Writing writing;
        int count;
    } cases[] = {
        {"certify", undisturbed(certify, ""), 90},
        {"certify, over an old file", undisturbed(certify, old), 90},
        {"problem, over an old file",
         undisturbed({"problem", "2394", "--certificate", "file"}, old), 60},
        {"export", undisturbed({"export", "--csv", "file"}, ""), 5},
        {"classification", undisturbed({"classification", "-o", "file"}, ""), 5},
        {"classification, over an old file", undisturbed({"classification", "-o", "file"}, old), 5},
    };
    for (const auto& [name, writing, count] : cases) {
        CAPTURE(name);
        const Kills kills = kill_at_random(writing, SIGKILL, count);
        MESSAGE(name << ": " << kills.cut << " killed, the file was complete after "
                     << kills.written);
    }
}

TEST_CASE("a process killed at any system call around the writing leaves the old file or the new") {
    for (const std::string old : {"", "the old file"}) {
        const Writing writing = undisturbed(certify, old);
        const TemporaryFolder folder;
        restore(folder.path(), writing);
        const int steps = trace(folder.path(), certify, -1).steps;
        if (steps == 0) {
            MESSAGE("this system permits no tracing: not tested");
            return;
        }
        int written = 0;
        const int first = std::max(0, steps - 100);
        const int kills = steps - first;
        for (int last = first; last < steps; ++last) {
            CAPTURE(last);
            restore(folder.path(), writing);
            trace(folder.path(), certify, last);
            written += check_leftovers(folder.path(), writing);
        }
        MESSAGE(kills << " kills at the last system calls, the file was complete after "
                      << written);
        CHECK(written > 0);
        CHECK(written < kills);
        check_later_run(folder.path(), writing);
    }
}

TEST_CASE("Ctrl-C ends a run with its own status and leaves nothing half-written") {
    kill_at_random(undisturbed(certify, "the old file"), SIGINT, 20);
    kill_at_random(undisturbed({"classification", "-o", "file"}, "the old file"), SIGINT, 4);
}

TEST_CASE("two runs that write one file at a time leave one whole file") {
    const TemporaryFolder folder;
    const Writing writing = undisturbed(certify, "");
    for (int i = 0; i < 20; ++i) {
        const pid_t one = start(folder.path(), certify);
        const pid_t other = start(folder.path(), certify);
        CHECK(wait_for(one) == 0);
        CHECK(wait_for(other) == 0);
        CHECK(check_leftovers(folder.path(), writing));
    }
}

TEST_CASE("a full disk is reported, and the old file stays") {
    const TemporaryFolder folder;
    const std::string path = folder.path().string();
    // The old file and the new one do not fit together: the archive alone has 6 MB.
    const auto outcome = run_with_mounts(
        "mount -t tmpfs -o size=4m none " + path + " && cd " + path + " && echo old >file && " +
        plprove + " classification -o file; echo status $?; cat file; ls -A; " + plprove +
        " certify 2394 -o file && head -n 1 file");
    if (!outcome) return;
    CHECK(outcome->out == "status 1\nold\nfile\nplcert 2 problem\n");
    CHECK(outcome->err == "plprove: cannot write file: No space left on device\n");
}

TEST_CASE("a full disk behind standard output is reported") {
    const std::string no_space = "No space left on device";
    for (const char* arguments : {" certify 2394", " list --minimal", " problem 2394", " show 2394",
                                  " export --csv -", " export --macaulay2 2394"}) {
        CAPTURE(arguments);
        const Outcome outcome = run(plprove + arguments + " >/dev/full");
        CHECK(outcome.status == 1);
        CHECK(outcome.err.find(no_space) != std::string::npos);
    }
    const Outcome help = run(plprove + " --help >/dev/full");
    CHECK(help.status == 1);
    CHECK(help.err.find("cannot write") != std::string::npos);
    const Outcome check = run(plcheck + " " + certs + "classification.plc >/dev/full");
    CHECK(check.status == 2);
    CHECK(check.err.find("cannot write") != std::string::npos);
}

TEST_CASE("a file beyond the user's limit is reported, and the old file stays") {
    const TemporaryFolder folder;
    write_file(folder / "file", "the old file");
    const Outcome outcome = run("cd " + folder.path().string() + " && ulimit -f 1000 && " +
                                plprove + " classification -o file");
    CHECK(outcome.status == 1);
    CHECK(outcome.err == "plprove: cannot write file: File too large\n");
    CHECK(read_file(folder / "file") == "the old file");
    CHECK(names_in(folder.path()) == "file\n");
}

TEST_CASE("a read-only folder is reported, and the old file stays") {
    const TemporaryFolder folder;
    const std::string path = folder.path().string();
    const auto outcome =
        run_with_mounts("mount -t tmpfs none " + path + " && echo old >" + path +
                        "/file && mount -o remount,bind,ro " + path + " && cd " + path +
                        " && for name in file new; do " + plprove +
                        " certify 2394 -o $name; echo status $?; done; cat file; ls -A");
    if (!outcome) return;
    CHECK(outcome->out == "status 1\nstatus 1\nold\nfile\n");
    CHECK(outcome->err == "plprove: cannot write file: Read-only file system\n"
                          "plprove: cannot write new: Read-only file system\n");
}

TEST_CASE("a reader that leaves ends the program, without a crash and not with status 0") {
    const TemporaryFolder folder;
    const std::string status_file = (folder / "status").string(), pipe = (folder / "pipe").string();
    const auto into_closed_pipe = [&](const std::string& command) {
        // The reader has left before the command begins.
        Outcome outcome =
            run("rm -f " + pipe + " && mkfifo " + pipe + " && { : <" + pipe + " & exec 3>" + pipe +
                " && wait && " + command + " >&3; echo $? >" + status_file + "; }");
        outcome.status = std::stoi(read_file(status_file));
        return outcome;
    };
    for (const char* arguments : {" certify 2394", " list --minimal", " export --csv -"}) {
        CAPTURE(arguments);
        const Outcome outcome =
            into_closed_pipe("env --default-signal=PIPE " + plprove + arguments);
        CHECK(outcome.status == 128 + SIGPIPE);
        CHECK(outcome.err.empty());
        // Some that start programs, the runners of CI among them, let this signal be ignored.
        CHECK(into_closed_pipe("env --ignore-signal=PIPE " + plprove + arguments).status == 1);
    }
    const Outcome check = into_closed_pipe(plcheck + " " + certs + "classification.plc");
    CHECK(check.status == 2);
    CHECK(check.err.find("cannot write the report") != std::string::npos);
    const Outcome first = run(plprove + " list --minimal | head -n 1");
    CHECK(first.out == "4\n");
    CHECK(first.err.empty());
}

TEST_CASE("a device or a link stays what it is when it is written to") {
    const TemporaryFolder folder;
    const std::string in_folder = "cd " + folder.path().string() + " && ";
    CHECK(run(in_folder + "mknod pipe p && ln -s target link && : >target && ( cat pipe >copy & " +
              plprove + " certify 2394 -o pipe && wait ) && test -p pipe && cmp copy - <<END\n" +
              run(plprove + " certify 2394").out + "END\n")
              .status == 0);
    CHECK(run(in_folder + plprove + " certify 2394 -o link && test -L link && cmp copy target")
              .status == 0);
    CHECK(run(plprove + " certify 2394 -o /dev/stdout | cmp - " + (folder / "copy").string())
              .status == 0);
    CHECK(run(in_folder + plprove + " certify 2394 -o .").err ==
          "plprove: cannot write .: Is a directory\n");
}
