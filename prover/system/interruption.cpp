#include "prover/system/interruption.h"

#include <atomic>
#include <csignal>
#include <cstdlib>

namespace plprove {

namespace {

// Signal handlers reach nothing but globals.
std::atomic<int> caught = 0;
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void note_signal(int signal) {
    caught = signal;
}

constexpr int waiting_signals[] = {SIGINT, SIGTERM};

} // namespace

Interruption::Interruption() {
    caught = 0;
    for (const int signal : waiting_signals)
        if (std::signal(signal, &note_signal) == SIG_IGN) std::signal(signal, SIG_IGN);
}

Interruption::~Interruption() {
    for (const int signal : waiting_signals)
        if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
}

int Interruption::pending() const {
    return caught;
}

void Interruption::end_by(int signal) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    std::_Exit(128 + signal); // where the signal is blocked
}

} // namespace plprove
