#include "tests/support/process.h"

#include <csignal>
#include <cstdlib>
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

pid_t start_program(const std::string& program, const fs::path& folder, const Arguments& arguments,
                    const std::function<void()>& prepare) {
    // Signals wait until the new process is the program: the handlers of the tests are not meant.
    sigset_t all, before;
    ::sigfillset(&all);
    ::sigprocmask(SIG_SETMASK, &all, &before);
    const pid_t child = ::fork();
    if (child != 0) {
        ::sigprocmask(SIG_SETMASK, &before, nullptr);
        return child;
    }
    // The leak checker of the sanitizers cannot work in a traced process.
    ::setenv("ASAN_OPTIONS", "detect_leaks=0", 1);
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        ::dup2(nowhere, stream);
    std::vector<char*> values{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments)
        values.push_back(const_cast<char*>(argument.c_str()));
    values.push_back(nullptr);
    prepare();
    ::signal(SIGINT, SIG_DFL);
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    if (::chdir(folder.c_str()) == 0) ::execv(program.c_str(), values.data());
    ::_exit(127);
}

int wait_for(pid_t child) {
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
}

std::optional<Outcome> run_with_mounts(const std::string& script) {
    for (const std::string unshare :
         {"unshare --mount", "unshare --user --map-root-user --mount"}) {
        const TemporaryFolder folder;
        const std::string mount = "mount -t tmpfs none " + folder.path().string();
        if (run(unshare + " " + mount).status != 0) continue;
        return run(unshare + " sh -c '" + script + "'");
    }
    MESSAGE("this system permits no mounts here: not tested");
    return {};
}

std::string names_in(const fs::path& folder) {
    return run("ls -A " + folder.string()).out;
}
