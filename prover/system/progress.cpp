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
    if (terminal_)
        std::fprintf(stderr, "\r%s: %zu of %zu%s\033[K", label_.c_str(), done, total_,
                     more.c_str());
}

void ProgressLine::wipe() {
    if (terminal_) std::fputs("\r\033[K", stderr);
}

} // namespace plprove
