#include "prover/system/progress.h"

#include <cstdio>
#include <unistd.h>

namespace plprove {

ProgressLine::ProgressLine(std::string label, std::size_t total)
    : label_(std::move(label)), total_(total), terminal_(::isatty(STDERR_FILENO) == 1) {}

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
