#include "prover/system/progress.h"

#include "prover/system/ranks.h"

#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace plprove {

namespace {

bool is_pipe(int descriptor) {
    struct stat status {};
    return ::fstat(descriptor, &status) == 0 && S_ISFIFO(status.st_mode);
}

/// Whether the standard error of the process that started this one is a terminal.
bool parent_has_terminal() {
    const std::string path = "/proc/" + std::to_string(::getppid()) + "/fd/2";
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
    if (descriptor < 0) return false;
    const bool is_terminal = ::isatty(descriptor) == 1;
    ::close(descriptor);
    return is_terminal;
}

/// Whether a user sees standard error on a terminal. mpirun reads it from a pipe, and shows it on
/// its own.
bool is_seen() {
    if (::isatty(STDERR_FILENO) == 1) return true;
    return ranks_started() > 1 && is_pipe(STDERR_FILENO) && parent_has_terminal();
}

} // namespace

ProgressLine::ProgressLine(std::string label, std::size_t total)
    : label_(std::move(label)), total_(total), terminal_(is_seen()) {}

ProgressLine::~ProgressLine() {
    wipe();
}

void ProgressLine::show(std::size_t done, const std::string& more) {
    if (!terminal_) return;
    std::string line = label_ + ": " + std::to_string(done);
    if (total_ > 0) line += " of " + std::to_string(total_);
    std::fprintf(stderr, "\r%s%s\033[K", line.c_str(), more.c_str());
}

void ProgressLine::wipe() {
    if (terminal_) std::fputs("\r\033[K", stderr);
}

} // namespace plprove
